// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshed_patches.hpp"
#include "triplex/meshing/mesh_patches.hpp"

namespace triplex {

/// Joins meshed patches to one indexed mesh per row of the table, and the arcs of the triple
/// degenerate curve to its mesh. Vertices are numbered as they are met. Says nothing of the
/// accuracy.
MeshedPatches assemble_meshes(const PatchComplex& complex, const MeshedArcs& arcs,
                              const std::vector<MeshedPatch>& patches);

}  // namespace triplex

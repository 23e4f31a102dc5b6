// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshed_patches.hpp"
#include "triplex/feature/feature_mesh.hpp"

namespace triplex {

/// Joins meshed patches to one indexed mesh per row of the table, and the arcs of the triple
/// degenerate curve to its mesh. Vertices are numbered as they are met.
std::vector<FeatureMesh> assemble_meshes(const PatchComplex& complex, const MeshedArcs& arcs,
                                         const std::vector<MeshedPatch>& patches);

}  // namespace triplex

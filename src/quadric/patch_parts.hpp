// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "patch_mesh.hpp"
#include "sampled_faces.hpp"
#include "spine_cut.hpp"

namespace triplex::detail {

/// How the curve cuts a patch of a tet: the sides of its border and the arc that joins its two
/// ends; empty if the tet's split is open or the whole tet is on one side.
PatchCut cut_of_patch(const TensorField& field, const CutTet& tet, const QuadricPatch& patch,
                      const SampledFaces& faces, const std::vector<TetLoop>& loops, int samples);

/// Gives each triangle the side of the border points in its region. False, and no sides, if the
/// regions are not what was proven: two if there is an arc, else one, each with one side.
bool label_parts(const PatchCut& cut, PatchMesh& mesh);

}  // namespace triplex::detail

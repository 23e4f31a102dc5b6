// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "patch_mesh.hpp"
#include "sampled_faces.hpp"

namespace triplex::detail {

/// The patches of one tet: those of the cut that are on the feature's side.
struct TetPatches {
  std::vector<std::uint8_t> chosen;  ///< numbers of patches of the cut
  std::vector<PatchMesh> meshes;     ///< one for each; no triangles: not meshed
  bool complete = true;              ///< all are meshed
  bool split = true;                 ///< of a balanced surface: all triangles are linear or planar
};

/// The patches on which the trace has the sign of an isotropicity; all of the other kinds.
/// Guarantee: exact.
std::vector<std::uint8_t> patches_of_feature(const SimplexForm<4>& form,
                                             const std::array<EdgeCut, 6>& edges,
                                             const TetCut& cut);

/// The chart of the quadric's own parameters that holds a patch; nothing if none does.
std::unique_ptr<PatchChart> parameter_plane(const QuadraticForm<double, 4>& form,
                                            const std::array<EdgeCut, 6>& edges, const TetCut& cut,
                                            const QuadricPatch& patch,
                                            const std::vector<TetLoop>& loops);

/// Meshes them; patches of one loop that no chart holds as a fan, if `last` or if they are tiny.
/// A cut that no chart holds is left out: the patch is meshed without it.
void mesh_patches(const SimplexForm<4>& form, const CutMesh& mesh, const SampledFaces& faces,
                  const CutTet& tet, TetSplit split, int samples, bool last, TetPatches& patches);

}  // namespace triplex::detail

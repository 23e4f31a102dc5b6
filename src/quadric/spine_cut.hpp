// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "cut_mesh.hpp"
#include "spine_on_face.hpp"

namespace triplex::detail {

/// How the triple degenerate curve cuts the balanced surface in a tet.
enum class TetSplit : std::uint8_t {
  Whole,    ///< no balanced surface, or another feature: nothing to cut
  Linear,   ///< q > 0 in the whole tet
  Planar,   ///< q < 0
  Proven,   ///< no patch has more than one arc of the curve, whose ends are known; no closed curve
  Contact,  ///< the curve meets an edge of the tet
  Open,     ///< not proven
};

/// The curve on the simplices of a mesh: every edge and face decided once.
struct SpineCut {
  std::vector<std::array<Sign, 2>> edges;  ///< of q at the roots; of edges of tets to be cut
  std::vector<FaceSpine> faces;            ///< of faces of tets to be cut
  std::vector<TetSplit> tets;
};

/// Runs in the caller's task arena; the result does not depend on the number of threads. Everything
/// but `Open` is certified. Source: proofs/quadric_spine.md.
SpineCut cut_by_spine(const TensorField& field, const CutMesh& mesh);

}  // namespace triplex::detail

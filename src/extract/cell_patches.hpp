// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <vector>

#include "face_arcs.hpp"

namespace triplex {

/// A vertex of a patch: a crossing of an edge, or a point of the triple degenerate curve on a face.
struct PatchVertex {
  std::uint32_t number = 0;  ///< in EdgeCrossings::crossings() or FaceSpinePoints::points()
  bool on_spine = false;
  std::uint8_t faces = 0;  ///< of the tet at hand, as bits: those that the vertex lies on
};

/// A page has at most one vertex per edge and per face of a tet.
inline constexpr int kPatchVertices = 6 + 4;
/// The oriented boundary of one patch of a page in a tet, normal towards growing angle of (p, q).
using PatchLoop = boost::container::static_vector<PatchVertex, kPatchVertices>;

/// What one tet contributes. Nothing is allocated.
struct CellPatches {
  std::array<boost::container::static_vector<PatchLoop, kPatchVertices / 3>, kPages> pages;
  /// Arcs of the triple degenerate curve.
  boost::container::static_vector<std::array<PatchVertex, 2>, 2> spine;
};

/// The patches of a tet, by combinatorics alone: on each face an arc of a page joins the crossing
/// that leaves the page's inner side to the one that enters it, or ends at the face's spine point;
/// arcs chain to loops over the faces; arcs of the spine join the faces where it enters and leaves.
/// Guarantee: neighbouring tets make the same arcs on their common face, certified or not, so the
/// union is watertight. Source: proofs/cell.md.
CellPatches patches_of(const Leaf& leaf, const std::vector<Sector>& labels,
                       const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                       FeatureSet features);

}  // namespace triplex

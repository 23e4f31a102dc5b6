// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "face_arcs.hpp"
#include "stacked_faces.hpp"

namespace triplex {

/// A vertex of a patch: a crossing of an edge, or a point of the triple degenerate curve on a face.
struct PatchVertex {
  std::uint32_t number = 0;  ///< in EdgeCrossings::crossings() or FaceSpinePoints::points()
  bool on_spine = false;
  std::uint8_t faces = 0;  ///< of the tet at hand, as bits: those that the vertex lies on
};

/// The oriented boundary of one patch of a surface in a tet, normal towards growing angle of (p,
/// q), or out of the convex set. At most two vertices per edge and one per face of the tet.
struct PatchLoop {
  static constexpr std::size_t kMost = 2 * 6 + 4;
  Feature feature{};
  std::array<PatchVertex, kMost> vertices;
  std::size_t size = 0;

  const PatchVertex& operator[](std::size_t i) const { return vertices[i]; }
};

/// What one tet contributes; kept from tet to tet so that it allocates nothing.
struct CellPatches {
  std::vector<PatchLoop> loops;                   ///< in order of the features
  std::vector<std::array<PatchVertex, 2>> spine;  ///< arcs of the triple degenerate curve
};

/// The patches of a tet, by combinatorics alone: on each face an arc of a surface joins the
/// crossing that leaves its inner side to the one that enters it, or ends at the face's spine
/// point; arcs chain to loops over the faces; arcs of the spine join the faces where it enters and
/// leaves; where an edge is crossed twice, `stacks` says what arcs join. Guarantee: neighbouring
/// tets make the same arcs on their common face, certified or not, so the union is watertight.
/// Source: proofs/cell.md.
void patches_of(const Leaf& leaf, const EdgeCrossings& crossings,
                const FaceSpinePoints& spine_points, const StackedFaces& stacks,
                FeatureSet features, CellPatches& patches);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "triplex/quadric/edge_cut.hpp"

namespace triplex {

/// A root on an edge of a face or tet, by the number of the edge and its place there.
struct EdgeRoot {
  std::uint8_t edge = 0;
  std::uint8_t root = 0;

  friend bool operator==(const EdgeRoot&, const EdgeRoot&) = default;
};

/// The edges of a face: 01, 12, 02.
inline constexpr std::array<std::array<int, 2>, 3> kFaceEdges = {{{0, 1}, {1, 2}, {0, 2}}};

/// The curve in which a quadric meets a face.
struct FaceCut {
  /// Its edges are, and the curve has no singular point in the closed face: the quadric is nowhere
  /// tangent to it.
  bool transverse = true;
  /// A whole ellipse that meets no edge; then there are no arcs.
  bool oval = false;
  std::uint8_t arcs = 0;
  /// Around the face, 0 to 1 to 2 to 0: arc n joins two roots.
  std::array<std::array<EdgeRoot, 2>, 3> ends{};
  /// The numbers of the roots of arc n in that order.
  std::array<std::array<std::uint8_t, 2>, 3> order{};
};

/// Arcs are paired by signs of the bilinear form between places on the edges. Guarantee: exact.
/// Source: proofs/quadric_patches.md.
FaceCut cut_face(const SimplexForm<3>& form, const std::array<EdgeCut, 3>& edges);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/quadric/face_cut.hpp"

namespace triplex {

inline constexpr std::array<std::array<int, 2>, 6> kTetEdges = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
/// Face i is opposite to vertex i; its vertices ascend.
inline constexpr std::array<std::array<int, 3>, 4> kTetFaces = {
    {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
/// The edges of each face, in the order of `kFaceEdges`.
inline constexpr std::array<std::array<int, 3>, 4> kEdgesOfFaces = {
    {{3, 5, 4}, {1, 5, 2}, {0, 4, 2}, {0, 3, 1}}};

/// An arc of a face of a tet, on the way around a loop.
struct LoopArc {
  std::uint8_t face = 0;
  std::uint8_t arc = 0;
  bool reversed = false;  ///< the way leads from its second end to its first
  EdgeRoot start;         ///< an edge of the tet, and the root on it
};

/// A closed curve in which the quadric meets the boundary of a tet.
struct QuadricLoop {
  std::vector<LoopArc> arcs;  ///< of an oval: none
  std::uint8_t oval_face = 0;
  bool is_oval() const { return arcs.empty(); }
};

/// A component of the quadric in a tet.
struct QuadricPatch {
  enum class Kind : std::uint8_t {
    Convex,   ///< on the boundary of a convex set: a sphere with as many holes as loops
    Saddle,   ///< of signature (2,2): a disc
    Annulus,  ///< of signature (2,2), with two loops
  };
  Kind kind = Kind::Convex;
  std::vector<std::uint8_t> loops;  ///< none: a closed ellipsoid
};

/// What a quadric is in a tet.
struct TetCut {
  /// Its faces are, and it has no singular point in the closed tet. Else nothing below is known.
  bool transverse = true;
  std::vector<QuadricLoop> loops;
  std::vector<QuadricPatch> patches;
  /// The sign of the form whose region is convex cones; of convex patches only.
  Sign cone = Sign::Zero;
};

/// Guarantee: components, their loops and Euler numbers (2 - loops for each) are exact.
/// Source: proofs/quadric_patches.md.
TetCut cut_tet(const SimplexForm<4>& form, const std::array<EdgeCut, 6>& edges,
               const std::array<FaceCut, 4>& faces);

}  // namespace triplex

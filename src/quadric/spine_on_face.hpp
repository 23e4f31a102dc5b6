// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "conic_arc.hpp"
#include "cut_mesh.hpp"

namespace triplex::detail {

/// A point of the triple degenerate curve on an arc of a face.
struct SpinePoint {
  std::uint8_t arc = 0;
  double place = 0;  ///< in (0, 1): the parameter of `sample_arc_approx`
  FacePoint x{};     ///< in doubles
};

/// The zeros of q on the arcs of the balanced surface in a face.
struct FaceSpine {
  /// Every zero is known, simple and listed. Else nothing is.
  bool known = false;
  std::vector<SpinePoint> points;  ///< arc by arc, along it
};

/// Guarantee: their number and order is exact where known; it is not where q is tangent to an arc
/// or nearer to that than 512 bits tell, and for ovals. Signs of q at the roots on the face's
/// edges are given, and not Zero. Source: proofs/quadric_spine.md.
FaceSpine spine_on_face(const TensorField& field, const CutMeshFace& face,
                        const std::array<EdgeCut, 3>& edges,
                        const std::array<std::array<Sign, 2>, 3>& signs);

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "edge_crossings.hpp"

namespace triplex {

/// A face that the triple degenerate curve passes through, once.
struct SpinePoint {
  std::array<VertexId, 3> face;         ///< ascending
  std::array<double, 3> barycentric{};  ///< of the point p = q = 0
  /// Proven bounds on the distance to the true point: in each barycentric coordinate, and in units
  /// of length from `FaceSpinePoints::position`. Infinite where nothing is proven.
  double coordinate_error = std::numeric_limits<double>::infinity();
  double error = std::numeric_limits<double>::infinity();

  bool proven() const { return coordinate_error < std::numeric_limits<double>::infinity(); }
};

/// All faces of active tets around which (p, q) winds, each once, with their points.
class FaceSpinePoints {
 public:
  FaceSpinePoints(const RefinedComplex& complex, const VertexLabels& labels,
                  const std::vector<std::uint32_t>& active_leaves, const EdgeCrossings& crossings);
  const std::vector<SpinePoint>& points() const { return points_; }
  /// The number of the point on a face, or -1. \pre the vertices ascend.
  int find(const std::array<VertexId, 3>& face) const;
  Point position(const RefinedComplex& complex, const SpinePoint& point) const;

 private:
  std::vector<SpinePoint> points_;
};

/// How often (p, q) winds around the origin along the boundary of a face a -> b -> c -> a: the sum
/// of the rotations over the number of pages; -1, 0 or 1.
int winding(const EdgeCrossings& crossings, VertexId a, VertexId b, VertexId c);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// A mesh of any origin, looked at: triangles and segments over common points. As a set of points
/// it is the union of its triangles and segments; points that none uses do not count.
struct MeshView {
  std::span<const Point> points;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const std::array<std::uint32_t, 2>> segments;

  bool empty() const { return triangles.empty() && segments.empty(); }
};

/// Of anything with these three members, such as a `FeatureMesh`, which must outlive the view.
template <class Mesh>
MeshView view_of(const Mesh& mesh) {
  return {mesh.points, mesh.triangles, mesh.segments};
}

/// What the functions of this layer ask of a mesh: indices in range, none twice in one cell, fewer
/// than 2^30 cells, and coordinates that are finite and at most 1e100 in magnitude, so that their
/// squares are numbers. Cost: linear. \throw std::invalid_argument that names the first culprit.
void check_mesh(const MeshView& mesh);

/// Per point: whether a cell uses it. \pre `check_mesh`.
std::vector<bool> used_points(const MeshView& mesh);

/// An axis-parallel box; empty where low > high.
struct BoundingBox {
  Point low, high;

  bool empty() const { return low[0] > high[0]; }
  /// The length of its diagonal, rounded; 0 if empty.
  double diagonal() const;
};

/// The smallest box around the points that a cell uses.
BoundingBox bounding_box(const MeshView& mesh);
/// The smallest box around both.
BoundingBox common_box(const BoundingBox& a, const BoundingBox& b);

}  // namespace triplex

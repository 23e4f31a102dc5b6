// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// One feature as an indexed mesh: triangles for a surface, segments for the triple curve and for
/// the degenerate curves of symmetric tensors.
/// Watertight by construction: cells share vertices by index. Triangles are consistently oriented:
/// normals point in the direction in which the angle of (p, q) grows; on a level set, outwards.
struct FeatureMesh {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;
  // per point
  std::vector<double> p;  ///< minor of the deviator, in squared tensor units
  std::vector<double> q;  ///< determinant of the deviator, in cubed tensor units
  std::vector<double>
      mode;  ///< mu = 3 sqrt(3) |q| / (2 |p|^(3/2)): 0 neutral, 1 degenerate, inf balanced
  /// On the triple curve: a proven bound on the distance to the true point, in units of length;
  /// infinite where nothing is proven. Empty on surfaces.
  std::vector<double> position_error;
  /// T itself, interpolated in doubles: what further quantities are computed from. Empty unless
  /// `ExtractionOptions::keep_tensors`.
  std::vector<Tensor<double>> tensors;
  /// The point that this one is a periodic copy of (itself, if of none). Empty unless
  /// `ExtractionOptions::periodic`.
  std::vector<std::uint32_t> identified;
  /// Unit vectors along the gradient of the function that vanishes on the surface, turned like the
  /// triangles; the mean of both sides where two tets meet, zero where the gradient is. Empty unless
  /// the mesh was made by `mesh_patches`.
  std::vector<Point> normals;
  /// The points that are nodes, ascending: there the surface is a double cone.
  std::vector<std::uint32_t> nodes;
  // per cell
  std::vector<std::int64_t> source_cell;  ///< cell id in the input file
  std::vector<std::uint8_t> certified;    ///< 1 where the topology is proven
  /// A proven bound on the distances between the cell's patch and the surface in its tet, both ways;
  /// infinite where nothing is proven. Empty unless the mesh was made by `mesh_patches`.
  std::vector<double> error_bound;
};

}  // namespace triplex

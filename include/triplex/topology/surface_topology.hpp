// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// The combinatorial topology of a triangle mesh and what keeps it from being an oriented manifold.
struct SurfaceTopology {
  std::uint64_t vertices = 0;  ///< points that some triangle uses
  std::uint64_t edges = 0;     ///< unordered pairs of vertices that share a triangle
  std::uint64_t triangles = 0;
  std::uint64_t components = 0;  ///< joined through shared vertices
  std::int64_t euler = 0;        ///< vertices - edges + triangles
  /// Connected sets (through shared vertices) of edges that have exactly one triangle.
  std::uint64_t boundary_loops = 0;
  std::uint64_t boundary_edges = 0;        ///< edges of exactly one triangle
  std::uint64_t nonmanifold_edges = 0;     ///< edges of three triangles or more
  std::uint64_t nonmanifold_vertices = 0;  ///< triangles at it not connected through its edges
  /// Edges of exactly two triangles that pass through it in the same direction.
  std::uint64_t orientation_conflicts = 0;

  bool manifold() const { return nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
  bool closed() const { return boundary_edges == 0; }
  friend bool operator==(const SurfaceTopology&, const SurfaceTopology&) = default;
};

/// The topology of the triangles, from their indices alone. Shape: any number of triangles over
/// `points` points; points that no triangle uses do not count. Time: linear, but for sorting the
/// few edges at each vertex. Errors: an index out of range or twice in one triangle ->
/// std::invalid_argument.
SurfaceTopology surface_topology(std::span<const std::array<std::uint32_t, 3>> triangles,
                                 std::size_t points);

/// The sum of the areas of the triangles, in squared units of the points. Rounded, with compensated
/// summation in the order given; not certified.
double area_approx(std::span<const Point> points,
                   std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace triplex

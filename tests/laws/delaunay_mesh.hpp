// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>

#include "linear_meshes.hpp"

namespace triplex::test {

/// The Delaunay triangulation of the corners of the cube [-1,1]^3 and random points inside.
inline TetMesh delaunay_cube(int inner_points, std::mt19937_64& random) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;
  std::vector<Point> points;
  points.reserve(8 + static_cast<std::size_t>(inner_points));
  for (int c = 0; c < 8; ++c)
    points.push_back({c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0});
  std::uniform_int_distribution<int> coordinate(-1000, 1000);
  for (int n = 0; n < inner_points; ++n) {
    Point& x = points.emplace_back();
    for (double& c : x) c = coordinate(random) * 0x1p-10;
  }
  Delaunay delaunay;
  std::map<Delaunay::Vertex_handle, std::uint32_t> ids;
  for (std::uint32_t n = 0; n < points.size(); ++n)
    ids[delaunay.insert({points[n][0], points[n][1], points[n][2]})] = n;
  Tets tets;
  for (auto cell = delaunay.finite_cells_begin(); cell != delaunay.finite_cells_end(); ++cell)
    tets.push_back(
        {ids[cell->vertex(0)], ids[cell->vertex(1)], ids[cell->vertex(2)], ids[cell->vertex(3)]});
  return oriented(std::move(points), tets);
}

}  // namespace triplex::test

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/surface_topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace triplex {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const Triangles kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// A grid of rows x columns squares over (rows + 1) x (columns + 1) points, each axis either open or
// wrapped around; wrapping the columns with `twist` glues them upside down.
struct Grid {
  std::uint32_t rows, columns;
  bool wrap_rows = false, wrap_columns = false, twist = false;

  std::uint32_t points() const { return (rows + 1) * (columns + 1); }
  std::uint32_t id(std::uint32_t r, std::uint32_t c) const {
    if (wrap_columns && c == columns) {
      c = 0;
      if (twist) r = rows - r;
    }
    if (wrap_rows) r %= rows;
    return r * (columns + 1) + c;
  }
  Triangles triangles() const {
    Triangles result;
    for (std::uint32_t r = 0; r < rows; ++r) {
      for (std::uint32_t c = 0; c < columns; ++c) {
        result.push_back({id(r, c), id(r, c + 1), id(r + 1, c + 1)});
        result.push_back({id(r, c), id(r + 1, c + 1), id(r + 1, c)});
      }
    }
    return result;
  }
};

TEST(SurfaceTopology, Nothing) {
  EXPECT_EQ(surface_topology(Triangles{}, 0), SurfaceTopology{});
  EXPECT_EQ(surface_topology(Triangles{}, 7), SurfaceTopology{});
}

TEST(SurfaceTopology, OneTriangleAmongUnusedPoints) {
  const SurfaceTopology t = surface_topology(Triangles{{5, 2, 9}}, 11);
  EXPECT_EQ(t, (SurfaceTopology{.vertices = 3,
                                .edges = 3,
                                .triangles = 1,
                                .components = 1,
                                .euler = 1,
                                .boundary_loops = 1,
                                .boundary_edges = 3}));
}

TEST(SurfaceTopology, TetrahedronIsASphere) {
  const SurfaceTopology t = surface_topology(kTetrahedron, 4);
  EXPECT_EQ(
      t, (SurfaceTopology{.vertices = 4, .edges = 6, .triangles = 4, .components = 1, .euler = 2}));
  EXPECT_TRUE(t.manifold());
  EXPECT_TRUE(t.closed());
}

TEST(SurfaceTopology, Torus) {
  const Grid grid{.rows = 4, .columns = 5, .wrap_rows = true, .wrap_columns = true};
  const SurfaceTopology t = surface_topology(grid.triangles(), grid.points());
  EXPECT_EQ(t, (SurfaceTopology{
                   .vertices = 20, .edges = 60, .triangles = 40, .components = 1, .euler = 0}));
}

TEST(SurfaceTopology, AnnulusHasTwoBoundaryLoops) {
  const Grid grid{.rows = 2, .columns = 6, .wrap_columns = true};
  const SurfaceTopology t = surface_topology(grid.triangles(), grid.points());
  EXPECT_EQ(t.euler, 0);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.boundary_loops, 2u);
  EXPECT_EQ(t.boundary_edges, 12u);
  EXPECT_EQ(t.orientation_conflicts, 0u);
  EXPECT_TRUE(t.manifold());
}

TEST(SurfaceTopology, MoebiusStripHasOneBoundaryLoopAndNoOrientation) {
  const Grid grid{.rows = 2, .columns = 6, .wrap_columns = true, .twist = true};
  const SurfaceTopology t = surface_topology(grid.triangles(), grid.points());
  EXPECT_EQ(t.euler, 0);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.boundary_loops, 1u);
  EXPECT_EQ(t.orientation_conflicts, 2u);  // the two edges of the seam
  EXPECT_TRUE(t.manifold());
}

TEST(SurfaceTopology, KleinBottleIsClosedWithoutOrientation) {
  const Grid grid{.rows = 4, .columns = 6, .wrap_rows = true, .wrap_columns = true, .twist = true};
  const SurfaceTopology t = surface_topology(grid.triangles(), grid.points());
  EXPECT_EQ(t.euler, 0);
  EXPECT_TRUE(t.closed());
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.orientation_conflicts, 4u);
}

TEST(SurfaceTopology, OneFlippedTriangleConflictsOnItsThreeEdges) {
  Triangles triangles = kTetrahedron;
  std::swap(triangles[2][0], triangles[2][1]);
  EXPECT_EQ(surface_topology(triangles, 4).orientation_conflicts, 3u);
}

TEST(SurfaceTopology, TwoSpheresTouchingAtAVertexAreOneComponent) {
  Triangles triangles = kTetrahedron;
  for (const auto& [a, b, c] : kTetrahedron) triangles.push_back({a + 3, b + 3, c + 3});
  const SurfaceTopology t = surface_topology(triangles, 7);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.euler, 3);
  EXPECT_EQ(t.nonmanifold_vertices, 1u);
  EXPECT_EQ(t.nonmanifold_edges, 0u);
  EXPECT_FALSE(t.manifold());
}

TEST(SurfaceTopology, TwoTrianglesTouchingAtAVertexShareOneBoundaryLoop) {
  const SurfaceTopology t = surface_topology(Triangles{{0, 1, 2}, {0, 3, 4}}, 5);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.boundary_loops, 1u);
  EXPECT_EQ(t.boundary_edges, 6u);
  EXPECT_EQ(t.nonmanifold_vertices, 1u);
}

TEST(SurfaceTopology, DisjointPiecesAddUp) {
  Triangles triangles = kTetrahedron;
  triangles.push_back({4, 5, 6});
  const SurfaceTopology t = surface_topology(triangles, 7);
  EXPECT_EQ(t.components, 2u);
  EXPECT_EQ(t.euler, 3);
  EXPECT_EQ(t.boundary_loops, 1u);
}

TEST(SurfaceTopology, ThreePagesOnOneEdge) {
  const SurfaceTopology t = surface_topology(Triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5);
  EXPECT_EQ(t.nonmanifold_edges, 1u);
  EXPECT_EQ(t.nonmanifold_vertices, 0u);
  EXPECT_EQ(t.boundary_edges, 6u);
  EXPECT_EQ(t.boundary_loops, 1u);
  EXPECT_EQ(t.orientation_conflicts, 0u);
  EXPECT_EQ(t.euler, 5 - 7 + 3);
}

TEST(SurfaceTopology, RefusesIndicesThatNameNoTriangle) {
  EXPECT_THROW(surface_topology(Triangles{{0, 1, 3}}, 3), std::invalid_argument);
  EXPECT_THROW(surface_topology(Triangles{{0, 1, 1}}, 3), std::invalid_argument);
  EXPECT_THROW(surface_topology(Triangles{{2, 1, 2}}, 3), std::invalid_argument);
}

TEST(SurfaceTopology, DoesNotDependOnNumberingOrOrder) {
  const Grid grid{.rows = 7, .columns = 9, .wrap_columns = true};
  Triangles triangles = grid.triangles();
  triangles.push_back({grid.id(0, 0), grid.points(), grid.points() + 1});
  const std::size_t points = grid.points() + 2;
  const SurfaceTopology expected = surface_topology(triangles, points);
  std::mt19937_64 random(20260101);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::uint32_t> label(points);
    std::iota(label.begin(), label.end(), 0u);
    std::shuffle(label.begin(), label.end(), random);
    std::shuffle(triangles.begin(), triangles.end(), random);
    Triangles renamed = triangles;
    for (auto& triangle : renamed) {
      for (std::uint32_t& v : triangle) v = label[v];
      std::rotate(triangle.begin(), triangle.begin() + round % 3, triangle.end());
    }
    EXPECT_EQ(surface_topology(renamed, points), expected);
  }
}

TEST(SurfaceTopology, TwoMillionTrianglesInSeconds) {
  const Grid grid{.rows = 1000, .columns = 1000, .wrap_rows = true, .wrap_columns = true};
  const Triangles triangles = grid.triangles();
  const auto start = std::chrono::steady_clock::now();
  const SurfaceTopology t = surface_topology(triangles, grid.points());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(t.triangles, 2'000'000u);
  EXPECT_EQ(t.euler, 0);
  RecordProperty("seconds", std::to_string(taken.count()));
  EXPECT_LT(taken.count(), 20.0);  // quadratic behaviour would take hours
}

TEST(SurfaceTopology, Area) {
  const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}};
  EXPECT_EQ(area_approx(points, Triangles{{0, 1, 2}, {0, 2, 3}}), 6.0);
  EXPECT_EQ(area_approx(points, Triangles{}), 0.0);
}

}  // namespace
}  // namespace triplex

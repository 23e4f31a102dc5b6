// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces contracted as far as it goes: what is left is known from the theory of irreducible
// triangulations. A sphere comes down to the tetrahedron, a disc to the triangle, a circle to
// three segments, and a torus to one of 21 triangulations with 7 to 10 vertices.
#include "triplex/feature/contraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

constexpr Feature kPage = Feature::BalancedLinear, kOther = Feature::NeutralReal;

/// Points at random in a unit cube: contraction asks for their distances only.
SharedComplex over_random_points(std::size_t points, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  SharedComplex complex;
  for (std::size_t n = 0; n < points; ++n)
    complex.points.push_back({coordinate(random), coordinate(random), coordinate(random)});
  complex.fixed.assign(points, 0);
  return complex;
}

/// A grid of n x n squares in two triangles each; opposite sides are one if it closes.
void add_grid(std::uint32_t n, bool closes, Feature feature, SharedComplex& complex,
              const std::vector<std::uint32_t>& first_column = {}, std::uint32_t offset = 0) {
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    if (closes) return offset + i % n * n + j % n;
    if (i == 0 && !first_column.empty()) return first_column[j];
    return offset + i * (n + 1) + j;
  };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
      complex.cells.push_back({{a, b, c}, feature});
      complex.cells.push_back({{a, c, d}, feature});
    }
}

/// What is left of one feature after contraction.
struct Left {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;
};
Left left_of(const SharedComplex& complex, const Contraction& contraction, Feature feature) {
  Left left;
  for (const SharedComplex::Cell& cell : complex.cells) {
    if (cell.feature != feature) continue;
    const std::uint32_t a = contraction.became[cell.vertices[0]],
                        b = contraction.became[cell.vertices[1]],
                        c = contraction.became[cell.vertices[2]];
    if (cell.is_segment() && a != b) left.segments.push_back({a, b});
    if (!cell.is_segment() && a != b && b != c && a != c) left.triangles.push_back({a, b, c});
  }
  return left;
}
Left contracted(const SharedComplex& complex, double reach, Feature feature = kPage) {
  return left_of(complex, contract_short_edges(complex, {reach, reach}), feature);
}
SurfaceTopology topology_of(const Left& left, const SharedComplex& complex) {
  return surface_topology(left.triangles, complex.points.size());
}

/// The boundary of an octahedron whose triangles are cut into four, `levels` times.
SharedComplex sphere(int levels, unsigned seed) {
  std::vector<std::array<std::uint32_t, 3>> t = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                 {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  std::uint32_t points = 6;
  for (int l = 0; l < levels; ++l) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), points);
      points += is_new;
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : t) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    t = std::move(finer);
  }
  SharedComplex complex = over_random_points(points, seed);
  for (const auto& corners : t) complex.cells.push_back({corners, kPage});
  return complex;
}

TEST(Contraction, SphereToTetrahedron) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const SharedComplex complex = sphere(static_cast<int>(seed) % 3, seed);
    const SurfaceTopology t = topology_of(contracted(complex, 100), complex);
    EXPECT_EQ(t.triangles, 4u) << seed;
    EXPECT_EQ(t.vertices, 4u);
    EXPECT_EQ(t.euler, 2);
    EXPECT_TRUE(t.manifold() && t.closed());
    EXPECT_EQ(t.orientation_conflicts, 0u);
  }
}

TEST(Contraction, DiscToTriangle) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SharedComplex complex = over_random_points(49, seed);
    add_grid(6, false, kPage, complex);
    const SurfaceTopology t = topology_of(contracted(complex, 100), complex);
    EXPECT_EQ(t.triangles, 1u) << seed;
  }
}

TEST(Contraction, TorusStaysOne) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SharedComplex complex = over_random_points(49, seed);
    add_grid(7, true, kPage, complex);
    const SurfaceTopology t = topology_of(contracted(complex, 100), complex);
    EXPECT_EQ(t.euler, 0) << seed;
    EXPECT_EQ(t.components, 1u);
    EXPECT_TRUE(t.manifold() && t.closed());
    EXPECT_GE(t.vertices, 7u);
    EXPECT_LE(t.vertices, 10u);
  }
}

TEST(Contraction, CircleToThreeSegments) {
  SharedComplex complex = over_random_points(20, 1);
  for (std::uint32_t n = 0; n < 20; ++n)
    complex.cells.push_back({{n, (n + 1) % 20, (n + 1) % 20}, Feature::TripleCurve});
  const Left left = contracted(complex, 100, Feature::TripleCurve);
  const CurveTopology t = curve_topology(left.segments, complex.points.size());
  EXPECT_EQ(t.segments, 3u);
  EXPECT_EQ(t.closed, 1u);
}

TEST(Contraction, OpenCurveKeepsItsEnds) {
  SharedComplex complex = over_random_points(20, 1);
  for (std::uint32_t n = 0; n + 1 < 20; ++n)
    complex.cells.push_back({{n, n + 1, n + 1}, Feature::TripleCurve});
  const Contraction contraction = contract_short_edges(complex, {100, 100});
  EXPECT_EQ(left_of(complex, contraction, Feature::TripleCurve).segments.size(), 1u);
  EXPECT_EQ(contraction.became[0], 0u);
  EXPECT_EQ(contraction.became[19], 19u);
}

/// Two pages and a curve, glued along a column of vertices: both stay discs that end on the curve.
TEST(Contraction, PagesStayOnTheirCurve) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SharedComplex complex = over_random_points(3 * 36, seed);
    std::vector<std::uint32_t> column;
    for (std::uint32_t j = 0; j <= 5; ++j) column.push_back(72 + j);
    for (std::uint32_t j = 0; j < 5; ++j)
      complex.cells.push_back({{column[j], column[j + 1], column[j + 1]}, Feature::TripleCurve});
    add_grid(5, false, kPage, complex, column, 0);
    add_grid(5, false, kOther, complex, column, 36);
    const Contraction contraction = contract_short_edges(complex, {100, 100});
    const Left page = left_of(complex, contraction, kPage);
    const Left other = left_of(complex, contraction, kOther);
    const Left curve = left_of(complex, contraction, Feature::TripleCurve);
    ASSERT_GE(curve.segments.size(), 1u);
    EXPECT_LT(curve.segments.size(), 5u);
    for (const Left* left : {&page, &other}) {
      const SurfaceTopology t = topology_of(*left, complex);
      EXPECT_EQ(t.euler, 1);
      EXPECT_EQ(t.boundary_loops, 1u);
      EXPECT_TRUE(t.manifold());
      EXPECT_LE(t.triangles, 4u);
      for (const auto& [a, b] : curve.segments)
        EXPECT_EQ(
            std::ranges::count_if(left->triangles,
                                  [&, a = a, b = b](const auto& c) {
                                    return std::ranges::count(c, a) + std::ranges::count(c, b) == 2;
                                  }),
            1);
    }
    // Off the curve they share nothing.
    std::set<std::uint32_t> on_curve, mine;
    for (const auto& [a, b] : curve.segments) on_curve.insert({a, b});
    for (const auto& c : page.triangles) mine.insert(c.begin(), c.end());
    for (const auto& c : other.triangles)
      for (const std::uint32_t v : c) EXPECT_TRUE(on_curve.contains(v) || !mine.contains(v));
  }
}

/// A double cone is no surface at its tip, which stays though nothing says that it is fixed.
TEST(Contraction, TipOfACone) {
  SharedComplex complex = over_random_points(13, 3);
  for (std::uint32_t nappe : {1u, 7u})
    for (std::uint32_t n = 0; n < 6; ++n)
      complex.cells.push_back({{0, nappe + n, nappe + (n + 1) % 6}, kPage});
  const Contraction contraction = contract_short_edges(complex, {100, 100});
  EXPECT_EQ(contraction.became[0], 0u);
  const SurfaceTopology t = topology_of(left_of(complex, contraction, kPage), complex);
  EXPECT_EQ(t.nonmanifold_vertices, 1u);
  EXPECT_EQ(t.euler, 1);
  EXPECT_EQ(t.triangles, 6u);  // three around each nappe: an edge of a triangle closes nothing
}

TEST(Contraction, FixedVerticesStay) {
  SharedComplex complex = sphere(2, 8);
  for (const std::uint32_t v : {3u, 11u, 20u, 31u, 40u}) complex.fixed[v] = 1;
  const Contraction contraction = contract_short_edges(complex, {100, 100});
  for (const std::uint32_t v : {3u, 11u, 20u, 31u, 40u}) EXPECT_EQ(contraction.became[v], v);
  const SurfaceTopology t = topology_of(left_of(complex, contraction, kPage), complex);
  EXPECT_EQ(t.vertices, 5u);
  EXPECT_EQ(t.euler, 2);
}

/// Where the orientation turns over, no surface passes: the edge is a curve.
TEST(Contraction, TurnedTrianglesAreKeptApart) {
  SharedComplex complex = over_random_points(5, 1);
  complex.cells = {{{0, 1, 2}, kPage}, {{0, 2, 3}, kPage}, {{0, 4, 3}, kPage}, {{0, 4, 1}, kPage}};
  const Contraction contraction = contract_short_edges(complex, {100, 100});
  const Left left = left_of(complex, contraction, kPage);
  EXPECT_GE(topology_of(left, complex).orientation_conflicts, 1u);
}

TEST(Contraction, NothingGoesFurtherThanReach) {
  SharedComplex complex = over_random_points(441, 1);
  for (std::uint32_t v = 0; v < 441; ++v)
    complex.points[v] = {v / 21 + complex.points[v][0] / 4, v % 21 + complex.points[v][1] / 4, 0};
  add_grid(20, false, kPage, complex);
  for (const double reach : {0.5, 1.2, 2.5, 4.0}) {
    const Contraction contraction = contract_short_edges(complex, {reach, reach});
    EXPECT_EQ(contraction.removed > 0, reach > 0.7);
    EXPECT_LE(contraction.moved, reach);
    double largest = 0;
    for (std::uint32_t v = 0; v < 441; ++v) {
      const Point &x = complex.points[v], &y = complex.points[contraction.became[v]];
      largest = std::max(largest, std::hypot(x[0] - y[0], x[1] - y[1]));
      EXPECT_EQ(contraction.became[contraction.became[v]], contraction.became[v]);
    }
    EXPECT_LE(largest, contraction.moved);
    const SurfaceTopology t = topology_of(left_of(complex, contraction, kPage), complex);
    EXPECT_EQ(t.euler, 1);
    EXPECT_EQ(t.boundary_loops, 1u);
  }
}

/// Two short edges, one of them within the core: what it is connected to goes, the other stays.
TEST(Contraction, OnlyWhatIsConnectedToTheCore) {
  SharedComplex complex = over_random_points(9, 1);
  const std::vector<double> x = {0, 1, 1.1, 1.1001, 2, 3, 3.1, 4, 5};
  for (std::uint32_t n = 0; n < 9; ++n) {
    complex.points[n] = {x[n], 0, 0};
    if (n < 8) complex.cells.push_back({{n, n + 1, n + 1}, Feature::TripleCurve});
  }
  const Contraction contraction = contract_short_edges(complex, {0.3, 0.001});
  EXPECT_EQ(contraction.removed, 2u);
  EXPECT_EQ(contraction.became[1], contraction.became[3]);
  EXPECT_EQ(contraction.became[2], contraction.became[3]);
  EXPECT_EQ(contraction.became[5], 5u);
  EXPECT_EQ(contraction.became[6], 6u);
}

/// A grid in the unit square, with the border on x or y = 0 or 1: contracted with its border kept,
/// it still fills that square, though with few triangles.
TEST(Contraction, KeepsBordersInTheirPlanes) {
  constexpr std::uint32_t kSide = 8;
  SharedComplex complex;
  for (std::uint32_t i = 0; i <= kSide; ++i)
    for (std::uint32_t j = 0; j <= kSide; ++j)
      complex.points.push_back({i / double{kSide}, j / double{kSide}, 0.5 + 0.01 * i * j});
  complex.fixed.assign(complex.points.size(), 0);
  add_grid(kSide, false, kPage, complex);
  for (const bool keep : {false, true}) {
    ContractionLengths lengths = {10, 10};
    if (keep) lengths.domain = Box{{0, 0, 0}, {1, 1, 2}};
    const Contraction contraction = contract_short_edges(complex, lengths);
    const Left left = left_of(complex, contraction, kPage);
    const SurfaceTopology t = surface_topology(left.triangles, complex.points.size());
    EXPECT_EQ(t.euler, 1);
    EXPECT_EQ(t.boundary_loops, 1u);
    double area = 0;  // of the projection along z
    for (const auto& [a, b, c] : left.triangles) {
      const Point &x = complex.points[a], &y = complex.points[b], &z = complex.points[c];
      area += ((y[0] - x[0]) * (z[1] - x[1]) - (z[0] - x[0]) * (y[1] - x[1])) / 2;
    }
    if (keep) {
      EXPECT_NEAR(area, 1, 1e-12);
      EXPECT_LT(left.triangles.size(), 20u);
    } else {
      EXPECT_EQ(left.triangles.size(), 1u);
    }
  }
}

}  // namespace
}  // namespace triplex

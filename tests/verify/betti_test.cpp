// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/betti.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <stdexcept>

#include "meshes.hpp"

namespace triplex {
namespace {

using test::Mesh;
using test::renumbered;
using test::together;
using test::torus;

BettiNumbers betti(const Mesh& mesh) { return betti_numbers(view_of(mesh)); }

/// The rank of a matrix over Z/2 whose rows are sets of columns, by plain elimination.
std::size_t rank(std::vector<std::set<std::uint32_t>> rows) {
  std::size_t result = 0;
  while (!rows.empty()) {
    const std::set<std::uint32_t> pivot = rows.back();
    rows.pop_back();
    if (pivot.empty()) continue;
    ++result;
    for (auto& row : rows) {
      if (!row.contains(*pivot.begin())) continue;
      for (const std::uint32_t x : pivot)
        if (!row.erase(x)) row.insert(x);
    }
  }
  return result;
}

/// Betti numbers by the definition: kernels and images of both boundary maps.
BettiNumbers by_definition(const Mesh& mesh) {
  std::set<std::uint32_t> vertices;
  std::map<std::set<std::uint32_t>, std::uint32_t> edges;
  std::set<std::set<std::uint32_t>> triangles;
  const auto add_edge = [&](std::uint32_t a, std::uint32_t b) {
    vertices.insert({a, b});
    edges.emplace(std::set{a, b}, edges.size());
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    add_edge(a, b), add_edge(b, c), add_edge(c, a);
    triangles.insert({a, b, c});
  }
  for (const auto& [a, b] : mesh.segments) add_edge(a, b);
  std::vector<std::set<std::uint32_t>> d1, d2;
  for (const auto& [edge, number] : edges) d1.push_back(edge);
  for (const auto& triangle : triangles) {
    std::set<std::uint32_t>& row = d2.emplace_back();
    for (const std::uint32_t left_out : triangle) {
      std::set<std::uint32_t> edge = triangle;
      edge.erase(left_out);
      row.insert(edges.at(edge));
    }
  }
  const std::size_t rank1 = rank(d1), rank2 = rank(d2);
  return {vertices.size() - rank1, edges.size() - rank1 - rank2, triangles.size() - rank2};
}

TEST(Betti, Nothing) {
  EXPECT_EQ(betti({}), BettiNumbers{});
  EXPECT_EQ(betti({.points = std::vector<Point>(3)}), BettiNumbers{});
}

TEST(Betti, KnownSurfaces) {
  EXPECT_EQ(betti(test::square(3)), (BettiNumbers{1, 0, 0}));
  EXPECT_EQ(betti(test::sphere(3, 1)), (BettiNumbers{1, 0, 1}));
  EXPECT_EQ(betti(torus(5, 6)), (BettiNumbers{1, 2, 1}));
  EXPECT_EQ(betti(together(torus(5, 6), test::sphere(2, 1))), (BettiNumbers{2, 2, 2}));
  Mesh open = torus(5, 6);
  open.triangles.pop_back();
  EXPECT_EQ(betti(open), (BettiNumbers{1, 2, 0}));
  open.triangles.erase(open.triangles.begin());
  EXPECT_EQ(betti(open), (BettiNumbers{1, 3, 0}));
}

TEST(Betti, ProjectivePlaneHasAClosedSurfaceOverZ2) {
  // The six-vertex triangulation.
  Mesh mesh{.points = std::vector<Point>(6)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                    {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  EXPECT_EQ(betti(mesh), (BettiNumbers{1, 1, 1}));
}

TEST(Betti, SpheresWithACommonMembrane) {
  // A sphere and its equatorial disc: two chambers, and their sum.
  Mesh mesh = test::sphere(1, 1);  // octahedron
  const auto at = [&](const Point& p) {
    return static_cast<std::uint32_t>(std::ranges::find(mesh.points, p) - mesh.points.begin());
  };
  const std::uint32_t a = at({1, 0, 0}), b = at({0, 1, 0}), c = at({-1, 0, 0}), d = at({0, -1, 0});
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
  EXPECT_EQ(betti(mesh), (BettiNumbers{1, 0, 2}));
}

TEST(Betti, Curves) {
  Mesh mesh{.points = std::vector<Point>(8)};
  mesh.segments = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}};
  EXPECT_EQ(betti(mesh), (BettiNumbers{2, 1, 0}));
  mesh.segments.push_back({1, 0});  // repeated
  EXPECT_EQ(betti(mesh), (BettiNumbers{2, 1, 0}));
  mesh.triangles = {{0, 1, 2}};  // fills the loop
  EXPECT_EQ(betti(mesh), (BettiNumbers{2, 0, 0}));
}

TEST(Betti, RepeatedTrianglesCountOnce) {
  Mesh mesh = test::square(2);
  mesh.triangles.push_back({mesh.triangles[3][1], mesh.triangles[3][0], mesh.triangles[3][2]});
  EXPECT_EQ(betti(mesh), (BettiNumbers{1, 0, 0}));
}

TEST(Betti, RandomComplexesAgreeWithTheDefinition) {
  std::mt19937_64 random(20260301);
  std::uint64_t with_cycles = 0;
  for (int round = 0; round < 400; ++round) {
    const std::uint32_t n = 4 + static_cast<std::uint32_t>(random() % 5);
    Mesh mesh{.points = std::vector<Point>(n)};
    const auto distinct = [&](auto& cell) {
      do
        for (std::uint32_t& v : cell) v = static_cast<std::uint32_t>(random() % n);
      while (std::set(cell.begin(), cell.end()).size() < cell.size());
    };
    mesh.triangles.resize(random() % (4 * n));
    mesh.segments.resize(random() % n);
    for (auto& triangle : mesh.triangles) distinct(triangle);
    for (auto& segment : mesh.segments) distinct(segment);
    const BettiNumbers expected = by_definition(mesh);
    ASSERT_EQ(betti(mesh), expected) << round;
    ASSERT_EQ(betti(renumbered(mesh, random())), expected) << round;
    if (expected.b2 > 1) ++with_cycles;
  }
  EXPECT_GT(with_cycles, 100u);
}

TEST(Betti, AMillionTriangles) { EXPECT_EQ(betti(torus(700, 720)), (BettiNumbers{1, 2, 1})); }

TEST(Betti, RefusesWhatIsNoComplex) {
  EXPECT_THROW(betti({.points = std::vector<Point>(2), .triangles = {{0, 1, 2}}}),
               std::invalid_argument);
  EXPECT_THROW(betti({.points = std::vector<Point>(2), .segments = {{1, 1}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace triplex

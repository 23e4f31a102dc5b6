// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/crossing_curves.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "meshes.hpp"
#include "triplex/topology/curve_topology.hpp"

namespace triplex {
namespace {

/// Two features, a level set and another one that it may cross.
struct Crossed {
  FeatureTable table;
  Feature page = Feature::NeutralReal, level = table.add_magnitude(1);
  FeatureSoup soup;

  Crossed(const test::Mesh& a, const test::Mesh& b) {
    const test::Mesh both = test::together(a, b);
    soup.points = both.points;
    soup.triangles = both.triangles;
    for (std::size_t t = 0; t < both.triangles.size(); ++t) {
      soup.features.push_back(t < a.triangles.size() ? page : level);
      soup.source_cell.push_back(static_cast<std::int64_t>(1000 + t));
      soup.certified.push_back(1);
    }
  }
  CrossingCurves curves() const {
    const EmbeddingResult result =
        check_embedding(soup, {.policy = CrossingPolicy(table), .list_crossings = true});
    EXPECT_TRUE(result.contacts.empty());
    return crossing_curves(soup, result.crossings);
  }
};

CurveTopology topology_of(const CrossingCurves& curves) {
  return curve_topology(curves.segments, curves.points.size());
}

TEST(CrossingCurves, TwoTriangles) {
  const test::Mesh flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const test::Mesh steep = {{{1, 1, -1}, {1, 1, 3}, {1, -7, 3}}, {{0, 1, 2}}};
  const CrossingCurves curves = Crossed(flat, steep).curves();
  ASSERT_EQ(curves.segments.size(), 1u);
  EXPECT_EQ(curves.features[0], (std::array{Feature::NeutralReal, static_cast<Feature>(7)}));
  EXPECT_EQ(curves.source_cells[0], (std::array<std::int64_t, 2>{1000, 1001}));
  std::vector<Point> ends = {curves.points[0], curves.points[1]};
  std::ranges::sort(ends);
  EXPECT_EQ(ends, (std::vector<Point>{{1, 0, 0}, {1, 1, 0}})) << "an edge of each in the other";
}

TEST(CrossingCurves, TorusAndPlane) {
  // The plane z = 0.1 cuts the torus in two circles.
  test::Mesh plane = test::square(7, 0.1);
  for (Point& p : plane.points) p = {4 * p[0] - 2.01, 4 * p[1] - 2.02, p[2]};
  const Crossed crossed(test::torus(40, 30), plane);
  const CrossingCurves curves = crossed.curves();
  const CurveTopology topology = topology_of(curves);
  EXPECT_EQ(topology.components, 2u);
  EXPECT_EQ(topology.closed, 2u);
  EXPECT_EQ(topology.branches, 0u);
  EXPECT_EQ(curves.points_only + curves.overlaps, 0u);
  for (const Point& p : curves.points) EXPECT_NEAR(p[2], 0.1, 1e-16);
  const double small = std::sqrt(0.16 - 0.01);
  EXPECT_NEAR(length_approx(curves.points, curves.segments),
              2 * std::numbers::pi * (1 + small + 1 - small), 0.1);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const CrossingCurves again = crossed.curves();
  EXPECT_EQ(again.points, curves.points);
  EXPECT_EQ(again.segments, curves.segments);
  EXPECT_EQ(again.source_cells, curves.source_cells);
}

TEST(CrossingCurves, ThroughVerticesAndAlongEdges) {
  // The plane x = 1/2 of a square of 4 x 4 squares runs along its edges, x = y through its
  // vertices and along its diagonals.
  const test::Mesh flat = test::square(4);
  const test::Mesh wall = {{{0.5, -1.1, -1}, {0.5, 2, -1}, {0.5, 2, 1}, {0.5, -1.1, 1}},
                           {{0, 1, 2}, {0, 2, 3}}};
  CrossingCurves curves = Crossed(flat, wall).curves();
  CurveTopology topology = topology_of(curves);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.ends, 2u);
  EXPECT_EQ(topology.branches, 0u);
  EXPECT_EQ(topology.segments, 5u) << "four edges, one cut by the wall's diagonal";
  EXPECT_DOUBLE_EQ(length_approx(curves.points, curves.segments), 1);

  const test::Mesh slanted = {{{-1, -1, -1}, {2, 2, -1}, {2, 2, 1}, {-1, -1, 1}},
                              {{0, 1, 2}, {0, 2, 3}}};
  curves = Crossed(flat, slanted).curves();
  topology = topology_of(curves);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.ends, 2u);
  EXPECT_EQ(topology.branches, 0u);
  EXPECT_DOUBLE_EQ(length_approx(curves.points, curves.segments), std::numbers::sqrt2);
}

TEST(CrossingCurves, PointsAndOverlapsAreCounted) {
  const test::Mesh flat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const test::Mesh tip = {{{1, 1, 0}, {1, 2, 1}, {2, 1, 1}}, {{0, 1, 2}}};
  CrossingCurves curves = Crossed(flat, tip).curves();
  EXPECT_TRUE(curves.segments.empty());
  EXPECT_EQ(curves.points_only, 1u);
  curves = Crossed(flat, test::moved(flat, {1, 1, 0})).curves();
  EXPECT_TRUE(curves.segments.empty());
  EXPECT_EQ(curves.overlaps, 1u);
}

TEST(CrossingCurves, PlacesAreExactUpToRounding) {
  // x + y + z = 1 / 3 up to rounding of the corners, cut by an edge from the origin.
  const double third = 1.0 / 3;
  const test::Mesh plane = {{{third, 0, 0}, {0, third, 0}, {0, 0, third}}, {{0, 1, 2}}};
  const test::Mesh needle = {{{0, 0, 0}, {1, 2, 3}, {3, 2, 1}}, {{0, 1, 2}}};
  const CrossingCurves curves = Crossed(plane, needle).curves();
  ASSERT_EQ(curves.points.size(), 2u);
  for (const Point& p : curves.points) {
    const double scale = third / 6;  // t (1 + 2 + 3) = 1 / 3
    for (std::size_t k = 0; k < 3; ++k) {
      const double exact = k == 1 ? 2 * scale : (p[0] < p[2]) == (k == 0) ? scale : 3 * scale;
      EXPECT_NEAR(p[k], exact, 2 * std::numeric_limits<double>::epsilon() * exact);
    }
  }
}

TEST(CrossingCurves, Nothing) {
  const CrossingCurves curves = crossing_curves({}, {});
  EXPECT_TRUE(curves.points.empty());
  EXPECT_TRUE(curves.segments.empty());
}

}  // namespace
}  // namespace triplex

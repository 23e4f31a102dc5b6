// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_distance.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "meshes.hpp"

namespace triplex {
namespace {

using test::Mesh;
using test::moved;
using test::renumbered;

DirectedDistance distance(const Mesh& from, const Mesh& to, double gap = 1e-3) {
  const DirectedDistance d = directed_distance(view_of(from), view_of(to), {.gap = gap});
  EXPECT_LE(d.lower, d.upper);
  if (std::isfinite(d.upper)) {
    EXPECT_LE(d.upper - d.lower, gap);
    // The lower bound is a distance between points of the two.
    EXPECT_NEAR(std::hypot(d.from[0] - d.to[0], d.from[1] - d.to[1], d.from[2] - d.to[2]), d.lower,
                1e-14);
  }
  return d;
}

TEST(MeshDistance, NothingAndSomething) {
  const Mesh something = test::square(2);
  EXPECT_EQ(distance({}, {}).upper, 0);
  EXPECT_EQ(distance({}, something).upper, 0);
  EXPECT_EQ(distance(something, {}).lower, std::numeric_limits<double>::infinity());
}

TEST(MeshDistance, PointsThatNoCellUsesDoNotCount) {
  Mesh mesh = test::square(2);
  mesh.points.push_back({9, 9, 9});
  EXPECT_EQ(distance(mesh, test::square(2)).upper, 0);
  EXPECT_GT(distance(moved(test::square(2), {9, 9, 9}), mesh).lower, 9);
}

TEST(MeshDistance, ExactlyZeroWhereCellsAreTheSame) {
  for (const Mesh& mesh : {test::torus(20, 30), test::sphere(7, 1.7, {0.1, 0.2, 0.3})}) {
    const DirectedDistance d = distance(renumbered(mesh, 1), mesh, 0.1);
    EXPECT_EQ(d.lower, 0);
    EXPECT_EQ(d.upper, 0);
    Mesh part = mesh;
    part.triangles.resize(part.triangles.size() / 2);
    EXPECT_EQ(distance(part, mesh, 0.1).upper, 0);
    EXPECT_GT(distance(mesh, part).lower, 0.3);
  }
  Mesh curve{.points = {{0, 0, 0}, {0.1, 0.3, 0.7}, {1, 1.1, 0.3}, {4, 4, 4}},
             .segments = {{0, 1}, {1, 2}, {3, 2}}};
  EXPECT_EQ(distance(renumbered(curve, 2), curve).upper, 0);
}

TEST(MeshDistance, ParallelSquares) {
  for (const std::uint32_t n : {1u, 3u, 8u}) {
    const DirectedDistance d = distance(test::square(5), test::square(n, 0.25), 1e-4);
    EXPECT_NEAR(d.lower, 0.25, 1e-15);
  }
}

TEST(MeshDistance, TheSameSquareCutOtherwiseIsAtNoDistance) {
  const DirectedDistance d = distance(test::square(3), test::square(7), 1e-3);
  EXPECT_LE(d.lower, 1e-15);
}

TEST(MeshDistance, AHoleIsAttainedInsideATriangle) {
  // The middle of the hole is far from the rest; no vertex of the whole square is.
  Mesh frame = test::square(3);
  std::erase_if(frame.triangles, [](const auto& t) {
    return std::ranges::all_of(
        t, [](std::uint32_t v) { return v == 5 || v == 6 || v == 9 || v == 10; });
  });
  ASSERT_EQ(frame.triangles.size(), 16u);
  const DirectedDistance d = distance(test::square(1), frame, 1e-4);
  EXPECT_NEAR(d.lower, 1.0 / 6, 1e-4);
  EXPECT_NEAR(d.from[0], 0.5, 1e-3);
  EXPECT_NEAR(d.from[1], 0.5, 1e-3);
  EXPECT_LE(distance(frame, test::square(1)).upper, 1e-3);
}

TEST(MeshDistance, UpperBoundsHoldForCoarseGapsToo) {
  // Specks at the corners: the farthest point is the middle.
  const double height = std::sqrt(3) / 2;
  const Mesh triangle{.points = {{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}}, .triangles = {{0, 1, 2}}};
  Mesh specks = triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    specks.points.push_back(specks.points[i]);
    specks.points.back()[2] = 1e-9;
  }
  specks.triangles.clear();
  specks.segments = {{0, 3}, {1, 4}, {2, 5}};
  const Mesh line{.points = {{0, 0, 0}, {1, 0, 0}}, .segments = {{0, 1}}};
  for (const double gap : {0.7, 0.4, 0.2, 0.05}) {
    EXPECT_GE(distance(triangle, specks, gap).upper, 1 / std::sqrt(3) - 1e-9) << gap;
    EXPECT_GE(distance(line, specks, gap).upper, 0.5 - 1e-9) << gap;
  }
  EXPECT_NEAR(distance(triangle, specks, 1e-4).lower, 1 / std::sqrt(3), 1e-4);
}

TEST(MeshDistance, ConcentricSpheres) {
  // Both inscribed: the outer one is within its own sagitta of radius 1.25, likewise the inner.
  const std::uint32_t n = 24;
  const DirectedDistance out = distance(test::sphere(n, 1), test::sphere(n, 1.25));
  const DirectedDistance in = distance(test::sphere(n, 1.25), test::sphere(n, 1));
  const double sagitta = 0.004;  // edges are at most 1.25 * pi / 2 / n * sqrt(3/2) long
  EXPECT_NEAR(out.lower, 0.25, sagitta);
  EXPECT_NEAR(in.lower, 0.25, sagitta);
}

TEST(MeshDistance, OfSegments) {
  const Mesh line{.points = {{0, 0, 0}, {4, 0, 0}}, .segments = {{0, 1}}};
  const Mesh bent{.points = {{0, 0, 0}, {1, 3, 0}, {4, 0, 0}}, .segments = {{0, 1}, {1, 2}}};
  EXPECT_EQ(distance(bent, line).lower, 3);
  // The point of the line as far from both legs: t / 10^(1/2) * 3 = (4 - t) / 2^(1/2).
  const double t = 4 / std::sqrt(2) / (3 / std::sqrt(10) + 1 / std::sqrt(2));
  EXPECT_NEAR(distance(line, bent, 1e-5).lower, 3 * t / std::sqrt(10), 1e-5);
  EXPECT_NEAR(distance(line, test::square(2)).lower, 3, 1e-15);
}

/// The distance of a point to a triangle by minimising over a fine lattice on it.
double by_sampling(const Point& p, const Point& a, const Point& b, const Point& c) {
  double best = std::numeric_limits<double>::infinity();
  const int n = 400;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      double squared = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = (a[k] * i + b[k] * j + c[k] * (n - i - j)) / n - p[k];
        squared += x * x;
      }
      best = std::min(best, squared);
    }
  return std::sqrt(best);
}

TEST(MeshDistance, FromAPointToATriangleInAllRegions) {
  std::mt19937_64 random(20260302);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto point = [&] { return Point{uniform(random), uniform(random), uniform(random)}; };
  for (int round = 0; round < 60; ++round) {
    const Mesh triangle{.points = {point(), point(), point()}, .triangles = {{0, 1, 2}}};
    const Point p = point();
    Point q = p;
    q[0] += 1e-9;
    const Mesh near_point{.points = {p, q}, .segments = {{0, 1}}};
    const double expected =
        by_sampling(p, triangle.points[0], triangle.points[1], triangle.points[2]);
    EXPECT_NEAR(distance(near_point, triangle).lower, expected, 0.01) << round;
    EXPECT_LE(distance(near_point, triangle).lower, expected + 2e-9) << round;
  }
}

TEST(MeshDistance, RandomSoupsAgreeWithSampling) {
  std::mt19937_64 random(20260303);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto soup = [&](std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t t = 0; t < n; ++t) {
      for (int i = 0; i < 3; ++i)
        mesh.points.push_back({uniform(random), uniform(random), uniform(random)});
      mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
  };
  for (int round = 0; round < 5; ++round) {
    const Mesh a = soup(4), b = soup(6);
    double sampled = 0;
    for (const auto& t : a.triangles)
      for (int i = 0; i <= 12; ++i)
        for (int j = 0; i + j <= 12; ++j) {
          Point p{};
          for (std::size_t k = 0; k < 3; ++k)
            p[k] =
                (a.points[t[0]][k] * i + a.points[t[1]][k] * j + a.points[t[2]][k] * (12 - i - j)) /
                12;
          double nearest = std::numeric_limits<double>::infinity();
          for (const auto& s : b.triangles)
            nearest =
                std::min(nearest, by_sampling(p, b.points[s[0]], b.points[s[1]], b.points[s[2]]));
          sampled = std::max(sampled, nearest);
        }
    const DirectedDistance d = distance(a, b, 1e-3);
    EXPECT_GE(d.upper, sampled - 0.01) << round;  // samples of b miss its nearest points
    EXPECT_LE(d.lower, sampled + 0.08) << round;  // samples of a miss its farthest ones
  }
}

TEST(MeshDistance, DegenerateTrianglesAreTheirLongestSide) {
  const Mesh flat{.points = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, .triangles = {{0, 1, 2}}};
  const Mesh line{.points = {{0, 0, 0}, {3, 0, 0}}, .segments = {{0, 1}}};
  EXPECT_LE(distance(flat, line).upper, 1e-3);
  EXPECT_LE(distance(line, flat).upper, 1e-3);
  EXPECT_EQ(distance({.points = {{2, 2, 0}, {2, 2, 0}}, .segments = {{0, 1}}}, flat).lower, 2);
}

TEST(MeshDistance, DoesNotDependOnThreadsOrNumbering) {
  const Mesh a = test::torus(20, 30), b = test::torus(23, 27);
  const DirectedDistance expected = distance(a, b, 1e-2);
  const DirectedDistance other = distance(renumbered(a, 3), renumbered(b, 4), 1e-2);
  EXPECT_NEAR(other.lower, expected.lower, 1e-2);  // each is within the gap of the true one
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(distance(a, b, 1e-2), expected);
}

TEST(MeshDistance, ALimitOnPiecesLeavesTheBoundsApartButRight) {
  const Mesh a = test::square(3), b = test::square(7, 0.01);
  const DirectedDistance d =
      directed_distance(view_of(a), view_of(b), {.gap = 1e-9, .max_pieces = 100});
  EXPECT_NEAR(d.lower, 0.01, 1e-15);
  EXPECT_GT(d.upper, d.lower + 1e-9);
}

TEST(MeshDistance, AThresholdIsDecidedBelowTheGap) {
  const Mesh a = test::torus(20, 30), b = test::torus(23, 27);
  const DirectedDistance fine = distance(a, b, 1e-4);
  for (const double off : {-2e-4, 2e-4}) {
    const double threshold = fine.lower + off;
    const DirectedDistance d =
        directed_distance(view_of(a), view_of(b), {.gap = 0.1, .threshold = threshold});
    EXPECT_EQ(d.lower > threshold, off < 0);
    EXPECT_EQ(d.upper <= threshold, off > 0);
  }
}

TEST(MeshDistance, CanBeStopped) {
  struct Stop {};
  const Mesh a = test::square(3);
  EXPECT_THROW(directed_distance(view_of(a), view_of(a), {.check = [] { throw Stop(); }}), Stop);
}

TEST(MeshDistance, RefusesWhatHasNoDistance) {
  Mesh bad = test::square(1);
  bad.points[0][1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(distance(bad, test::square(1)), std::invalid_argument);
  bad.points[0][1] = 1e200;
  EXPECT_THROW(distance(test::square(1), bad), std::invalid_argument);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/triangle_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace triplex {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TEST(TriangleQuality, KnownAngles) {
  const double h = std::sqrt(3.0) / 2;
  // Equilateral; half a square, 45; legs 1 and 2, 26.57; 1 : 100, 0.573; without area.
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0},   {0.5, h, 0}, {0, 1, 0},
                                     {0, 0, 2}, {100, 0, 0}, {50, 0, 0}};
  const Triangles triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {0, 3, 5}, {0, 6, 5}};
  const AngleHistogram all = smallest_angles_approx(points, triangles);
  EXPECT_EQ(all.counts, (std::array<std::uint64_t, 6>{2, 0, 1, 0, 1, 1}));
  EXPECT_EQ(all.smallest, 0);
  const AngleHistogram needle = smallest_angles_approx(points, Triangles{{5, 3, 0}});
  EXPECT_NEAR(needle.smallest, std::atan(0.01) * 180 / std::acos(-1.0), 1e-12);
}

TEST(TriangleQuality, OfNothing) { EXPECT_EQ(smallest_angles_approx({}, {}).smallest, 60); }

// Needles keep their digits, and far from the origin no angle is negative or above 60.
TEST(TriangleQuality, StaysInRange) {
  std::vector<Point> points;
  Triangles triangles;
  for (std::uint32_t n = 0; n < 40; ++n) {
    points.push_back({1e6, 0, 0});
    points.push_back({1e6 + 1, 0, 0});
    points.push_back({1e6 + 0.5, std::ldexp(1.0, -static_cast<int>(n)), 0});
    triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
    const AngleHistogram one = smallest_angles_approx(points, std::span(triangles).last(1));
    EXPECT_GT(one.smallest, 0);
    EXPECT_LE(one.smallest, 60);
  }
}

}  // namespace
}  // namespace triplex

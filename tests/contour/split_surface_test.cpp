// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "split_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace triplex::detail {
namespace {

/// A square of two triangles in the plane z = 0, split by the function given at its corners.
ContourSurface square(std::array<double, 4> other) {
  ContourSurface s;
  s.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  s.tensors.resize(4);
  for (std::size_t v = 0; v < 4; ++v) s.tensors[v][0] = s.points[v][0];
  s.other.assign(other.begin(), other.end());
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  s.tets = {7, 9};
  return s;
}

/// Twice the signed area seen from above.
double area(const SplitSurface& s, const SplitSurface::Part& part) {
  double sum = 0;
  for (const auto& t : part.triangles) {
    const Point &a = s.points[t[0]], &b = s.points[t[1]], &c = s.points[t[2]];
    const double one = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    EXPECT_GE(one, 0) << "a triangle turned over";
    sum += one;
  }
  return sum;
}

TEST(SplitSurface, CutsAlongTheZeroLine) {
  // other = x - 1/4.
  const SplitSurface s = split_by_sign_approx(square({-0.25, 0.75, 0.75, -0.25}));
  EXPECT_NEAR(area(s, s.negative), 0.5, 1e-15);
  EXPECT_NEAR(area(s, s.positive), 1.5, 1e-15);
  ASSERT_EQ(s.segments.size(), 2u);
  EXPECT_EQ(s.points.size(), 7u) << "three new points: the one on the diagonal is shared";
  for (const auto& segment : s.segments) {
    for (const std::uint32_t v : segment) {
      EXPECT_NEAR(s.points[v][0], 0.25, 1e-15);
      EXPECT_NEAR(s.tensors[v][0], 0.25, 1e-15);
    }
  }
  EXPECT_EQ(std::set<std::uint32_t>(s.segment_tets.begin(), s.segment_tets.end()),
            (std::set<std::uint32_t>{7, 9}));
  EXPECT_EQ(std::ranges::count(s.positive.tets, 7u) + std::ranges::count(s.negative.tets, 7u), 3);
}

TEST(SplitSurface, LeavesOneSideWhole) {
  const SplitSurface above = split_by_sign_approx(square({1, 2, 3, 0}));
  EXPECT_EQ(above.positive.triangles.size(), 2u);
  EXPECT_TRUE(above.negative.triangles.empty());
  EXPECT_TRUE(above.segments.empty());
  const SplitSurface below = split_by_sign_approx(square({-1, -2, -3, -1}));
  EXPECT_EQ(below.negative.triangles.size(), 2u);
  EXPECT_EQ(below.negative.tets, (std::vector<std::uint32_t>{7, 9}));
}

}  // namespace
}  // namespace triplex::detail

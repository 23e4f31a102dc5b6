// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/meshing/least_disc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace triplex {
namespace {

using Corners = std::vector<std::array<double, 2>>;

double area(const Corners& x, const std::array<std::uint32_t, 3>& t) {
  const auto &a = x[t[0]], &b = x[t[1]], &c = x[t[2]];
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/// Every side once, every diagonal twice: a disc with n - 2 triangles.
void expect_disc(const Corners& corners,
                 const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto n = static_cast<std::uint32_t>(corners.size());
  ASSERT_EQ(triangles.size(), n - 2);
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      sides[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  for (const auto& [side, sum] : sides) {
    const bool outer = side[1] == side[0] + 1 || (side[0] == 0 && side[1] == n - 1);
    EXPECT_EQ(std::abs(sum), outer ? 1 : 0) << side[0] << ' ' << side[1];
  }
}

TEST(LeastDisc, OfASimplePolygonHasItsArea) {
  // A comb, not convex: area 2 + 3 * 1.
  const Corners comb = {{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1},
                        {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const auto triangles = least_disc(comb);
  expect_disc(comb, triangles);
  double sum = 0;
  for (const auto& t : triangles) {
    EXPECT_GE(area(comb, t), 0);
    sum += area(comb, t);
  }
  EXPECT_DOUBLE_EQ(sum, 8);
}

TEST(LeastDisc, OfAPinchedPolygonStaysWithinItsTwoParts) {
  // Two squares that touch in a point, which the boundary passes twice.
  const Corners pinched = {{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}};
  const auto triangles = least_disc(pinched);
  expect_disc(pinched, triangles);
  double sum = 0;
  for (const auto& t : triangles) sum += std::fabs(area(pinched, t));
  EXPECT_DOUBLE_EQ(sum, 2);
}

TEST(LeastDisc, OfACrossingPolygonIsADisc) {
  Corners star;
  for (int k = 0; k < 5; ++k)
    star.push_back(
        {std::cos(4 * std::numbers::pi * k / 5), std::sin(4 * std::numbers::pi * k / 5)});
  expect_disc(star, least_disc(star));
  expect_disc({{0, 0}, {1, 0}, {0, 1}}, least_disc(Corners{{0, 0}, {1, 0}, {0, 1}}));
}

}  // namespace
}  // namespace triplex

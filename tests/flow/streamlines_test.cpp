// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/flow/streamlines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "linear_flow.hpp"

namespace triplex {
namespace {

const VectorField kRotation = test::linear_flow({0, -2, 0, 2, 0, 0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0});

TEST(Streamlines, OfARigidRotationAreCircles) {
  const std::vector<Point> seeds = {{0.5, 0, 0.1}, {0, -0.3, -0.2}};
  const LineSet lines = streamlines(kRotation, seeds, {.max_length = 3});
  ASSERT_EQ(lines.lines.size(), 4u);
  ASSERT_EQ(lines.line_numbers[0].name, "Seed");
  ASSERT_EQ(lines.point_values[1].name, "time");
  for (std::size_t k = 0; k < 4; ++k) {
    const auto seed = static_cast<std::size_t>(lines.line_numbers[0].values[k]);
    const Point& s = seeds.at(seed);
    const double radius = std::hypot(s[0], s[1]);
    const bool backward = lines.line_numbers[1].values[k] == 1;
    const Point& first = lines.points[lines.lines[k].front()];
    EXPECT_NEAR(std::hypot(first[0] - s[0], first[1] - s[1], first[2] - s[2]), 0,
                1e-7);  // single precision
    double length = 0;
    for (std::size_t i = 0; i < lines.lines[k].size(); ++i) {
      const std::uint32_t id = lines.lines[k][i];
      const Point& x = lines.points[id];
      ASSERT_NEAR(std::hypot(x[0], x[1]), radius, 1e-6);
      ASSERT_NEAR(x[2], s[2], 1e-7);
      // It turns by 2 in a unit of time.
      const double time = lines.point_values[1].values[id];
      ASSERT_EQ(time <= 0, backward || i == 0);
      const double angle = 2 * time + std::atan2(s[1], s[0]);
      ASSERT_NEAR(x[0], radius * std::cos(angle), 1e-5);
      ASSERT_NEAR(x[1], radius * std::sin(angle), 1e-5);
      if (i > 0) {
        const Point& y = lines.points[lines.lines[k][i - 1]];
        length += std::hypot(x[0] - y[0], x[1] - y[1]);
      }
      const double* const v = &lines.point_values[0].values[3 * id];
      ASSERT_NEAR(v[0], -2 * x[1], 1e-6);
      ASSERT_NEAR(v[1], 2 * x[0], 1e-6);
    }
    EXPECT_NEAR(length, 3, 0.2);
  }
}

TEST(Streamlines, OutsideThereAreNone) {
  const std::vector<Point> seeds = {{5, 0, 0}};
  EXPECT_TRUE(streamlines(kRotation, seeds).lines.empty());
}

TEST(Streamlines, EndAtTheBoundary) {
  const VectorField uniform = test::linear_flow({}, {}, {1, 0, 0});
  const std::vector<Point> seeds = {{0.2, 0.1, 0.3}};
  const LineSet lines = streamlines(uniform, seeds);
  ASSERT_EQ(lines.lines.size(), 2u);
  EXPECT_NEAR(lines.points[lines.lines[0].back()][0], 1, 0.2);
  EXPECT_NEAR(lines.points[lines.lines[1].back()][0], -1, 0.2);
}

}  // namespace
}  // namespace triplex

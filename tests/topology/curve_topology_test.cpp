// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/curve_topology.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace triplex {
namespace {

using Segments = std::vector<std::array<std::uint32_t, 2>>;

TEST(CurveTopology, Nothing) {
  EXPECT_EQ(curve_topology(Segments{}, 0), CurveTopology{});
  EXPECT_EQ(curve_topology(Segments{}, 5), CurveTopology{});
}

TEST(CurveTopology, OpenArcWithAnUnusedPoint) {
  const CurveTopology t = curve_topology(Segments{{3, 1}, {1, 0}}, 5);
  EXPECT_EQ(t,
            (CurveTopology{.vertices = 3, .segments = 2, .components = 1, .closed = 0, .ends = 2}));
}

TEST(CurveTopology, LoopAndArcAreTwoComponents) {
  const CurveTopology t = curve_topology(Segments{{0, 1}, {2, 1}, {0, 2}, {3, 4}}, 5);
  EXPECT_EQ(t,
            (CurveTopology{.vertices = 5, .segments = 4, .components = 2, .closed = 1, .ends = 2}));
}

TEST(CurveTopology, FigureEightIsNotAClosedCurve) {
  const CurveTopology t =
      curve_topology(Segments{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}}, 5);
  EXPECT_EQ(t, (CurveTopology{.vertices = 5, .segments = 6, .components = 1, .branches = 1}));
}

TEST(CurveTopology, RefusesIndicesThatNameNoSegment) {
  EXPECT_THROW(curve_topology(Segments{{0, 2}}, 2), std::invalid_argument);
  EXPECT_THROW(curve_topology(Segments{{1, 1}}, 2), std::invalid_argument);
}

TEST(CurveTopology, Length) {
  const std::vector<Point> points = {{0, 0, 0}, {3, 4, 0}, {3, 4, 12}};
  EXPECT_EQ(length_approx(points, Segments{{0, 1}, {2, 1}}), 17.0);
}

}  // namespace
}  // namespace triplex

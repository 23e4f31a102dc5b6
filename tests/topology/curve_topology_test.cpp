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

/// The points of each chain.
std::vector<std::vector<std::uint32_t>> chains(const Segments& segments, std::size_t points,
                                               const std::vector<std::uint8_t>& labels = {}) {
  std::vector<std::vector<std::uint32_t>> result;
  for (const CurveChain& chain : curve_chains(segments, points, labels)) {
    EXPECT_EQ(chain.points.size(), chain.segments.size() + 1);
    for (std::size_t n = 0; n < chain.segments.size(); ++n) {
      const auto [a, b] = segments[chain.segments[n]];
      EXPECT_TRUE((chain.points[n] == a && chain.points[n + 1] == b) ||
                  (chain.points[n] == b && chain.points[n + 1] == a));
    }
    result.push_back(chain.points);
  }
  return result;
}
using Chains = std::vector<std::vector<std::uint32_t>>;

TEST(CurveChains, ArcsComeFirstThenLoops) {
  EXPECT_EQ(chains({}, 3), Chains{});
  EXPECT_EQ(chains({{1, 0}, {2, 1}, {0, 2}, {5, 4}, {3, 4}}, 7), (Chains{{3, 4, 5}, {0, 1, 2, 0}}));
}

TEST(CurveChains, EndAtBranches) {
  // A loop through a branch point with a tail is a chain that returns there.
  EXPECT_EQ(chains({{0, 1}, {1, 2}, {2, 0}, {0, 3}}, 4), (Chains{{0, 1, 2, 0}, {0, 3}}));
  EXPECT_EQ(chains({{0, 3}, {1, 3}, {2, 3}}, 4), (Chains{{0, 3}, {1, 3}, {2, 3}}));
}

TEST(CurveChains, EndWhereLabelsChange) {
  EXPECT_EQ(chains({{0, 1}, {1, 2}, {2, 3}}, 4, {1, 0, 0}), (Chains{{0, 1}, {1, 2, 3}}));
  EXPECT_EQ(chains({{0, 1}, {1, 2}, {2, 0}}, 3, {1, 1, 0}), (Chains{{0, 1, 2}, {0, 2}}));
  EXPECT_TRUE(curve_chains(Segments{{0, 1}, {1, 2}, {2, 0}}, 3).front().is_loop());
}

TEST(CurveChains, RefuseWhatIsNoCurve) {
  EXPECT_THROW(curve_chains(Segments{{0, 2}}, 2), std::invalid_argument);
  EXPECT_THROW(curve_chains(Segments{{1, 1}}, 2), std::invalid_argument);
  const std::vector<std::uint8_t> labels = {1, 1};
  EXPECT_THROW(curve_chains(Segments{{0, 1}}, 2, labels), std::invalid_argument);
}

TEST(CurveTopology, Length) {
  const std::vector<Point> points = {{0, 0, 0}, {3, 4, 0}, {3, 4, 12}};
  EXPECT_EQ(length_approx(points, Segments{{0, 1}, {2, 1}}), 17.0);
}

}  // namespace
}  // namespace triplex

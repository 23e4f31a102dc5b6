// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/feature_soup.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace triplex {
namespace {

TEST(FeatureSoup, EqualPoints) {
  const std::vector<Point> points = {
      {1, 0, 0}, {0.0, 2, 0}, {1, 0, 0}, {-0.0, 2, 0}, {1, 0, 1e-300}};
  EXPECT_EQ(merge_equal_points(points), (std::vector<std::uint32_t>{0, 1, 0, 1, 4}));
}

TEST(FeatureSoup, JoinsTrianglesThenSegments) {
  std::vector<FeatureMesh> meshes(3);
  meshes[0].points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  meshes[0].triangles = {{0, 1, 2}};
  meshes[0].source_cell = {5};
  meshes[0].certified = {1};
  meshes[2].points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 9}};
  meshes[2].segments = {{0, 1}, {1, 2}};
  meshes[2].triangles = {{1, 3, 2}};
  meshes[2].source_cell = {6, 7, 8};  // the segments come first
  meshes[2].certified = {1, 0, 1};
  meshes[2].nodes = {3};
  const FeatureSoup soup = join_features(meshes);
  EXPECT_EQ(soup.points.size(), 7u);
  EXPECT_EQ(soup.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {4, 6, 5}}));
  EXPECT_EQ(soup.segments, (std::vector<std::array<std::uint32_t, 2>>{{3, 4}, {4, 5}}));
  const auto first = static_cast<Feature>(0), third = static_cast<Feature>(2);
  EXPECT_EQ(soup.features, (std::vector{first, third, third, third}));
  EXPECT_EQ(soup.source_cell, (std::vector<std::int64_t>{5, 8, 6, 7}));
  EXPECT_EQ(soup.certified, (std::vector<std::uint8_t>{1, 1, 1, 0}));
  EXPECT_EQ(soup.nodes, (std::vector<std::uint32_t>{6}));
  meshes[2].certified.pop_back();
  EXPECT_THROW(join_features(meshes), std::invalid_argument);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/plant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "straight_curve.hpp"

namespace triplex {
namespace {

using test::block_tensor;
using test::crossing_curve;
using test::straight_curve;

constexpr PlantSizes kSizes = {.radius = 0.01, .thorn = 0.06, .leaf = 0.05, .sides = 12};

Plant grown(const Hyperstreamline& curve, double spacing = 0.05) {
  Plant plant;
  grow(curve, augment(curve, {.spacing = spacing}), kSizes, 7, plant);
  return plant;
}

std::vector<std::uint32_t> polygon(const Plant& plant, std::size_t k) {
  return {plant.corners.begin() + plant.ends[k], plant.corners.begin() + plant.ends[k + 1]};
}

TEST(Plant, ArraysFit) {
  const Plant plant = grown(crossing_curve());
  const std::size_t points = plant.points.size(), polygons = plant.part.size();
  ASSERT_GT(polygons, 100u);
  EXPECT_EQ(plant.normals.size(), points);
  EXPECT_EQ(plant.rgb.size(), points);
  EXPECT_EQ(plant.arc_length.size(), points);
  EXPECT_EQ(plant.ends.size(), polygons + 1);
  EXPECT_EQ(plant.ends.back(), plant.corners.size());
  EXPECT_EQ(plant.domain.size(), polygons);
  EXPECT_EQ(plant.eigenvector.size(), polygons);
  EXPECT_EQ(plant.curve, std::vector<std::uint32_t>(polygons, 7));
  for (const std::uint32_t corner : plant.corners) ASSERT_LT(corner, points);
  for (const auto& n : plant.normals)
    ASSERT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-12);
  for (std::size_t k = 0; k < polygons; ++k) {
    const bool thorn = plant.part[k] == PlantPart::Thorn;
    EXPECT_EQ(plant.eigenvector[k] == kNotApplicable, !thorn);
  }
}

TEST(Plant, TheStemIsATubeOfThatRadiusOutwardAndPartedAtTheEvent) {
  const Plant plant = grown(crossing_curve());
  std::map<int, std::pair<double, double>> extent;  // of each domain along x
  for (std::size_t k = 0; k < plant.part.size(); ++k) {
    if (plant.part[k] != PlantPart::Stem) continue;
    const auto corners = polygon(plant, k);
    for (const std::uint32_t c : corners) {
      const Point& p = plant.points[c];
      auto [it, fresh] = extent.try_emplace(plant.domain[k], p[0], p[0]);
      it->second.first = std::min(it->second.first, p[0]);
      it->second.second = std::max(it->second.second, p[0]);
      if (std::fabs(p[0]) < 0.25 - 1e-9) {
        ASSERT_NEAR(std::hypot(p[1], p[2]), 0.01, 1e-12);
        ASSERT_NEAR(plant.arc_length[c], p[0], 1e-12);
      }
    }
    // Counter-clockwise seen from outside.
    const Point &a = plant.points[corners[0]], &b = plant.points[corners[1]],
                &c = plant.points[corners[2]];
    const auto& n = plant.normals[corners[0]];
    const auto u = [&](std::size_t i) { return b[i] - a[i]; };
    const auto v = [&](std::size_t i) { return c[i] - b[i]; };
    const double volume = n[0] * (u(1) * v(2) - u(2) * v(1)) + n[1] * (u(2) * v(0) - u(0) * v(2)) +
                          n[2] * (u(0) * v(1) - u(1) * v(0));
    ASSERT_GT(volume, 0) << k;
  }
  ASSERT_EQ(extent.size(), 2u);
  EXPECT_NEAR(extent[2].first, -0.26, 1e-9);
  EXPECT_NEAR(extent[2].second, 0, 1e-9);
  EXPECT_NEAR(extent[1].first, 0, 1e-9);
  EXPECT_NEAR(extent[1].second, 0.26, 1e-9);
}

std::set<std::array<std::uint8_t, 3>> stem_colors(const Tensor<double>& t) {
  const Hyperstreamline curve = straight_curve({0, 1}, [&](double) { return t; });
  const Plant plant = grown(curve);
  std::set<std::array<std::uint8_t, 3>> colors;
  for (std::size_t k = 0; k < plant.part.size(); ++k)
    if (plant.part[k] == PlantPart::Stem)
      for (const std::uint32_t c : polygon(plant, k)) colors.insert(plant.rgb[c]);
  return colors;
}

TEST(Plant, WoodSmoothAndBlend) {
  const auto wood = stem_colors(block_tensor(0.2)), blend = stem_colors(block_tensor(-0.2)),
             smooth = stem_colors({0.1, 0, 0, 0, 0, -2, 0, 2, 0});
  EXPECT_GT(wood.size(), 50u);
  EXPECT_GT(blend.size(), 50u);
  ASSERT_EQ(smooth.size(), 1u);
  for (const auto& c : wood) EXPECT_TRUE(c[0] > c[1] && c[1] > c[2]);  // brown
  // Half and half: each between the smooth colour and one of wood.
  const auto& s = *smooth.begin();
  for (const auto& c : blend)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_GE(2 * c[i] + 2, s[i]);
  EXPECT_GT(s[1], s[0]);
}

TEST(Plant, ThornsReachBothWaysAndAreColouredByEigenvector) {
  const Plant plant = grown(
      straight_curve({0, 1}, [](double) { return Tensor<double>{5, 0, 0, 0, 1, 0, 0, 0, -2}; }));
  std::map<int, std::set<std::array<std::uint8_t, 3>>> tips;
  std::map<int, std::array<double, 2>> reach;
  for (std::size_t k = 0; k < plant.part.size(); ++k) {
    if (plant.part[k] != PlantPart::Thorn) continue;
    const int e = plant.eigenvector[k];
    const std::uint32_t tip = polygon(plant, k)[2];
    tips[e].insert(plant.rgb[tip]);
    const double y = plant.points[tip][static_cast<std::size_t>(e)];
    reach[e][y > 0] = y;
  }
  ASSERT_EQ(tips.size(), 2u);
  for (const int e : {1, 2}) {
    EXPECT_EQ(tips[e].size(), 1u);
    EXPECT_NEAR(reach[e][0], -0.06, 1e-12);
    EXPECT_NEAR(reach[e][1], 0.06, 1e-12);
  }
  EXPECT_NE(tips[1], tips[2]);
}

TEST(Plant, LeavesAreTrueEllipses) {
  const Plant plant = grown(straight_curve({0, 1}, [](double) { return block_tensor(-0.25); }));
  double reach_y = 0, reach_z = 0;
  for (std::size_t k = 0; k < plant.part.size(); ++k) {
    if (plant.part[k] != PlantPart::Leaf) continue;
    for (const std::uint32_t c : polygon(plant, k)) {
      const Point& p = plant.points[c];
      if (std::fabs(plant.normals[c][0]) < 0.9) continue;  // of the midrib
      reach_y = std::max(reach_y, std::fabs(p[1]));
      reach_z = std::max(reach_z, std::fabs(p[2]));
      // Axes 0.05 along y and half of it along z.
      ASSERT_LE(std::hypot(p[1] / 0.05, p[2] / 0.025), 1 + 1e-9);
    }
  }
  EXPECT_NEAR(reach_y, 0.05, 1e-12);
  EXPECT_NEAR(reach_z, 0.025, 1e-12);
}

// At a turn and at a leap the tube is interrupted: no polygon spans the gap.
TEST(Plant, NoPolygonSpansALeapOrATurn) {
  Hyperstreamline curve =
      straight_curve({0, 0.2, 0.2, 0.4, 0.4, 0.6}, [](double) { return block_tensor(0.1); });
  for (std::size_t k = 2; k < 6; ++k) curve.points[k].position[0] -= 1;  // a leap after point 1
  curve.points[5].position = {-0.6, 0.2, 0};                             // a turn at point 3
  curve.points[4].forward = curve.points[5].forward = {0, 1, 0};
  curve.leaps = {1};
  const Plant plant = grown(curve);
  for (std::size_t k = 0; k < plant.part.size(); ++k) {
    if (plant.part[k] != PlantPart::Stem) continue;
    const auto corners = polygon(plant, k);
    for (const std::uint32_t a : corners)
      for (const std::uint32_t b : corners)
        for (std::size_t i = 0; i < 3; ++i)
          ASSERT_LE(std::fabs(plant.points[a][i] - plant.points[b][i]), 0.0201);
  }
}

TEST(Plant, RefusesSizesThatAreNone) {
  Plant plant;
  const Hyperstreamline curve = crossing_curve();
  EXPECT_THROW(grow(curve, {}, {}, 0, plant), std::invalid_argument);
  EXPECT_THROW(grow(curve, {}, {.radius = 1, .thorn = 1, .leaf = 1, .sides = 2}, 0, plant),
               std::invalid_argument);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/augmentation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "straight_curve.hpp"

namespace triplex {
namespace {

using test::block_tensor;
using test::crossing_curve;
using test::straight_curve;

double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// |A v - l v| for the tensor at the place.
double residual(const Thorn& thorn) {
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double r = -thorn.eigenvalue * thorn.direction[i];
    for (std::size_t j = 0; j < 3; ++j) r += thorn.at.tensor[3 * i + j] * thorn.direction[j];
    square += r * r;
  }
  return std::sqrt(square);
}

TEST(Augmentation, ThornsAreTheOtherTwoEigenvectors) {
  const Augmentation plant = augment(crossing_curve(), {.spacing = 0.02});
  ASSERT_GT(plant.thorns.size(), 20u);
  ASSERT_EQ(plant.thorns.size() % 2, 0u);
  for (std::size_t k = 0; k < plant.thorns.size(); k += 2) {
    const Thorn &medium = plant.thorns[k], &minor = plant.thorns[k + 1];
    EXPECT_EQ(medium.eigenvector, 1);
    EXPECT_EQ(minor.eigenvector, 2);
    EXPECT_EQ(medium.at.arc_length, minor.at.arc_length);
    if (medium.at.arc_length == 0) continue;  // on the degenerate surface
    EXPECT_LT(medium.at.arc_length, 0);
    EXPECT_TRUE(medium.place.in_real_domain());
    const double root = std::sqrt(-medium.at.arc_length);
    EXPECT_NEAR(medium.eigenvalue, root, 1e-11);
    EXPECT_NEAR(minor.eigenvalue, -root, 1e-11);
    for (const Thorn& thorn : {medium, minor}) {
      EXPECT_LT(residual(thorn), 1e-11);
      EXPECT_NEAR(dot(thorn.direction, {1, 0, 0}), 0, 1e-11);  // not the stem
      EXPECT_NEAR(dot(thorn.direction, thorn.direction), 1, 1e-14);
    }
  }
}

TEST(Augmentation, LeavesAreTheEllipsesOfTheDualEigenvectors) {
  const Augmentation plant = augment(crossing_curve(), {.spacing = 0.02});
  ASSERT_GT(plant.leaves.size(), 10u);
  for (const StemLeaf& leaf : plant.leaves) {
    const double x = leaf.at.arc_length;
    ASSERT_GT(x, 0);
    EXPECT_EQ(leaf.place.number, 1);
    // y' = z, z' = -x y: orbits x y^2 + z^2 = const.
    EXPECT_NEAR(leaf.axis_ratio, std::sqrt(x), 1e-9);
    EXPECT_NEAR(leaf.eccentricity, std::sqrt(1 - x), 1e-9);
    EXPECT_NEAR(std::fabs(leaf.long_axis[1]), 1, 1e-9);
    EXPECT_NEAR(std::fabs(leaf.short_axis[2]), 1, 1e-9);
    EXPECT_NEAR(leaf.re, 0, 1e-11);
    EXPECT_NEAR(leaf.im, std::sqrt(x), 1e-11);
  }
}

// In proofs/plant_limits.md: halving the distance halves the angle of the long axis, and takes
// that of the thorns, and the axis ratio, down by sqrt(2).
TEST(Augmentation, ConvergesToTheRepeatingEigenvectorAtTheRateOfTheory) {
  const Augmentation plant =
      augment(crossing_curve(1.5), {.spacing = 0.05, .close_to_degenerate = 24});
  double before = 0, angle_before = 0;
  int thorns = 0;
  for (const Thorn& thorn : plant.thorns) {
    const double d = -thorn.at.arc_length;
    if (thorn.eigenvector != 1 || d <= 0 || d > 0.001) continue;
    const double angle = std::acos(std::min(1.0, std::fabs(thorn.direction[1])));
    if (thorns++ > 0) {
      EXPECT_NEAR(std::log(angle / angle_before) / std::log(d / before), 0.5, 0.05) << d;
    }
    before = d;
    angle_before = angle;
  }
  EXPECT_GE(thorns, 15);
  int leaves = 0;
  double ratio_before = 0;
  for (const StemLeaf& leaf : plant.leaves) {
    const double d = leaf.at.arc_length;
    if (d > 0.001 || d < 1e-6) continue;
    const double angle = std::asin(std::hypot(leaf.long_axis[0], leaf.long_axis[2]));
    if (leaves++ > 0) {
      EXPECT_NEAR(std::log(leaf.axis_ratio / ratio_before) / std::log(d / before), 0.5, 0.01) << d;
      EXPECT_NEAR(std::log(angle / angle_before) / std::log(d / before), 1, 0.02) << d;
    }
    before = d;
    angle_before = angle;
    ratio_before = leaf.axis_ratio;
  }
  EXPECT_GE(leaves, 9);
}

TEST(Augmentation, OnTheSurfaceItselfBothThornsAreTheRepeatingEigenvector) {
  const Augmentation plant = augment(crossing_curve(), {.spacing = 0.25});
  int on_surface = 0;
  for (const Thorn& thorn : plant.thorns) {
    if (thorn.at.arc_length != 0) continue;
    ++on_surface;
    EXPECT_EQ(thorn.place, (Classification{Stratum::Page, 2}));
    EXPECT_EQ(std::fabs(thorn.direction[1]), 1);
  }
  EXPECT_EQ(on_surface, 2);
}

TEST(Augmentation, PlacesAreEvenAndCloserAtTheDegenerateSurface) {
  const Augmentation plant =
      augment(crossing_curve(), {.spacing = 0.0625, .close_to_degenerate = 2});
  std::set<double> places;
  for (const Thorn& thorn : plant.thorns) places.insert(thorn.at.arc_length);
  for (const StemLeaf& leaf : plant.leaves) EXPECT_TRUE(places.insert(leaf.at.arc_length).second);
  std::set<double> expected = {-0.03125, -0.015625, 0.015625, 0.03125};
  for (int k = -4; k <= 4; ++k) expected.insert(0.0625 * k);
  ASSERT_EQ(places.size(), expected.size());
  // Between points of the curve arc lengths are rounded.
  EXPECT_TRUE(std::ranges::equal(places, expected,
                                 [](double a, double b) { return std::fabs(a - b) < 1e-15; }));
  const Augmentation by_default = augment(crossing_curve(), {.close_to_degenerate = 0});
  EXPECT_NEAR(static_cast<double>(by_default.thorns.size() / 2 + by_default.leaves.size()), 51, 1);
}

TEST(Augmentation, TurnsWithTheDominantEigenvector) {
  // diag(1, 0, -1) with a trace-free change: q = 0 at x = 0, linear before and planar behind.
  Hyperstreamline curve = straight_curve(
      {-1, 0, 0, 1}, [](double x) { return Tensor<double>{3, 0, 0, 0, x, 0, 0, 0, -3 - x}; });
  curve.points[2].forward = curve.points[3].forward = {0, 0, 1};
  curve.events.push_back({0, 1, {0, 0, 0}, Feature::NeutralReal, 2, 3, true});
  for (const Thorn& thorn : augment(curve, {.spacing = 0.3}).thorns) {
    const bool before = thorn.at.arc_length <= 0;
    EXPECT_NE(thorn.eigenvector, before ? 0 : 2) << thorn.at.arc_length;
    EXPECT_EQ(std::fabs(thorn.direction[static_cast<std::size_t>(thorn.eigenvector)]), 1);
  }
  // Exactly on the surface two eigenvalues dominate alike: the side the curve comes from decides.
  const auto thorns = augment(curve, {.spacing = 2}).thorns;
  ASSERT_EQ(thorns.size(), 2u);
  EXPECT_EQ(thorns[0].eigenvector, 1);
  EXPECT_EQ(thorns[1].eigenvector, 2);
  curve.field = EigenvectorField::Medium;
  EXPECT_EQ(augment(curve, {.spacing = 2}).thorns[0].eigenvector, 0);
  EXPECT_EQ(augment(curve, {.spacing = 2}).thorns[1].eigenvector, 2);
}

TEST(Augmentation, NothingGrowsWhereNothingIsDefined) {
  const auto count = [](const Tensor<double>& t) {
    const Augmentation plant = augment(straight_curve({0, 1}, [&](double) { return t; }));
    return plant.thorns.size() + plant.leaves.size();
  };
  EXPECT_EQ(count({1, 0, 0, 0, 1, 0, 0, 0, 1}), 0u);    // a multiple of the identity
  EXPECT_EQ(count({2, 0, 0, 0, -1, 0, 0, 0, -1}), 0u);  // a node: a plane of eigenvectors
  EXPECT_EQ(count({0, 1, 0, 0, 0, 1, 0, 0, 0}), 0u);    // on the triple degenerate curve
  EXPECT_GT(count(block_tensor(0.25)), 0u);
  EXPECT_GT(count(block_tensor(-0.25)), 0u);
}

TEST(Augmentation, CirclesHaveAxesInTheirPlane) {
  const Augmentation plant = augment(
      straight_curve({0, 1}, [](double) { return Tensor<double>{3, 0, 0, 0, 0, -1, 0, 1, 0}; }));
  ASSERT_GT(plant.leaves.size(), 10u);
  for (const StemLeaf& leaf : plant.leaves) {
    EXPECT_EQ(leaf.axis_ratio, 1);
    EXPECT_EQ(leaf.eccentricity, 0);
    EXPECT_NEAR(leaf.long_axis[0], 0, 1e-15);
    EXPECT_NEAR(leaf.short_axis[0], 0, 1e-15);
    EXPECT_NEAR(dot(leaf.long_axis, leaf.short_axis), 0, 1e-15);
    EXPECT_NEAR(dot(leaf.long_axis, leaf.long_axis), 1, 1e-15);
  }
}

TEST(Augmentation, SkipsTheGapOfALeap) {
  Hyperstreamline curve =
      straight_curve({0, 0.2, 0.2, 0.4}, [](double) { return block_tensor(0.1); });
  curve.points[2].position[0] = -0.8;
  curve.points[3].position[0] = -0.6;
  curve.leaps = {1};
  const auto thorns = augment(curve, {.spacing = 0.05}).thorns;
  ASSERT_GE(thorns.size(), 16u);
  for (const Thorn& thorn : thorns) {
    const double s = thorn.at.arc_length, x = thorn.at.position[0];
    EXPECT_NEAR(x, s <= 0.2 ? s : s - 1, 1e-12);
  }
}

TEST(Augmentation, RefusesSpacingsThatAreNone) {
  const Hyperstreamline curve = crossing_curve();
  EXPECT_THROW(augment(curve, {.spacing = -1}), std::invalid_argument);
  EXPECT_THROW(augment(curve, {.spacing = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(augment(curve, {.spacing = 1e-12}), std::invalid_argument);
  Hyperstreamline point = curve;
  point.points.resize(1);
  point.events.clear();
  EXPECT_TRUE(augment(point, {.spacing = 1}).thorns.empty());
}

TEST(StemPieces, AreCutAtEventsAndKnowTheirDomains) {
  const auto pieces = stem_pieces(crossing_curve());
  ASSERT_EQ(pieces.size(), 4u);
  const std::array<int, 4> sectors = {2, 2, 1, 1};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(pieces[k].sector, sectors[k]);
  EXPECT_EQ(pieces[1].to, 0.5);
  EXPECT_EQ(pieces[2].from, 0.5);
  EXPECT_EQ(pieces[1].segment, 1u);
  EXPECT_EQ(pieces[2].segment, 1u);
  // A curve within a page has no domain to name.
  const auto within = stem_pieces(straight_curve({0, 1}, [](double) { return block_tensor(0); }));
  ASSERT_EQ(within.size(), 1u);
  EXPECT_EQ(within[0].sector, kNoSector);
}

}  // namespace
}  // namespace triplex

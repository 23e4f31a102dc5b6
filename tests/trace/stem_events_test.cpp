// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/trace/stem_events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace triplex {
namespace {

/// A 2x2 block [[a, b - w], [b + w, -a]] and a third eigenvalue z; the mean is taken off by the
/// invariants themselves. D = 4 (a^2 + b^2 - w^2) (...)^2.
Tensor<double> block(double a, double b, double w, double z) {
  return {a, b - w, 0, b + w, -a, 0, 0, 0, z};
}

std::vector<int> sectors(const SegmentSectors& s) {
  std::vector<int> r;
  for (const auto& stretch : s.stretches)
    if (r.empty() || r.back() != stretch.sector) r.push_back(stretch.sector);
  return r;
}

Hyperstreamline stem_through(const std::vector<Tensor<double>>& tensors) {
  Hyperstreamline stem;
  double x = 0;
  for (const auto& t : tensors) {
    StemPoint p;
    p.tensor = t;
    p.position = {x, 0, 0};
    stem.points.push_back(p);
    x += 1;
  }
  return stem;
}

TEST(StemEvents, OneDegenerateCrossingAtAKnownPlace) {
  // w from 0 to 4, a = 1: D = 0 at w = 1, a quarter of the way; z = 30 keeps everything linear.
  const auto stem = stem_through({block(1, 0, 0, 30), block(1, 0, 4, 30)});
  const auto events = stem_events(stem);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].feature, Feature::DegenerateLinear);
  EXPECT_DOUBLE_EQ(events[0].fraction, 0.25);
  EXPECT_DOUBLE_EQ(events[0].position[0], 0.25);
  EXPECT_EQ(events[0].sector_before, 2);
  EXPECT_EQ(events[0].sector_after, 1);
  EXPECT_FALSE(events[0].dominant_jumps);
}

TEST(StemEvents, SeveralInOneSegmentInTheirOrder) {
  // diag(1, -1) with rotation w from -4 to 4: complex, real between -1 and 1, complex.
  const auto events = stem_events(stem_through({block(1, 0, -4, 30), block(1, 0, 4, 30)}));
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].sector_before, 1);
  EXPECT_EQ(events[0].sector_after, 2);
  EXPECT_EQ(events[1].sector_after, 1);
  EXPECT_DOUBLE_EQ(events[0].fraction, 0.375);
  EXPECT_DOUBLE_EQ(events[1].fraction, 0.625);
}

TEST(StemEvents, RealNeutralJumpsOfTheDominantFieldOnly) {
  // Eigenvalues 1, -1 and z from -0.5 to 0.5: q = -z + ... changes its sign at z = 0.
  auto stem = stem_through({block(1, 0, 0, -0.5), block(1, 0, 0, 0.5)});
  auto events = stem_events(stem);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].feature, Feature::NeutralReal);
  EXPECT_EQ(events[0].sector_before, 2);
  EXPECT_EQ(events[0].sector_after, 3);
  EXPECT_DOUBLE_EQ(events[0].fraction, 0.5);
  EXPECT_TRUE(events[0].dominant_jumps);
  stem.field = EigenvectorField::Minor;
  EXPECT_FALSE(stem_events(stem)[0].dominant_jumps);
}

TEST(StemEvents, TouchingIsNone) {
  // a^2 + b^2 - w^2 with w = 1 and (a, b) on a tangent of the unit circle: D touches zero.
  const auto a = block(1, -1, 1, 30), b = block(1, 1, 1, 30);
  EXPECT_TRUE(stem_events(stem_through({a, b})).empty());
  const SegmentSectors s = sectors_along(a, b);
  ASSERT_EQ(s.stretches.size(), 2u);
  EXPECT_EQ(s.stretches[0].sector, 2);
  EXPECT_EQ(s.stretches[1].sector, 2);
  EXPECT_DOUBLE_EQ(s.stretches[1].begin_approx, 0.5);
}

TEST(StemEvents, ThroughTheSpine) {
  // t R with R fixed: p and q vanish together at t = 0, from A to -A: sector 2 to 3.
  const auto minus = block(-1, 0, 0, -0.5), plus = block(1, 0, 0, 0.5);
  const auto events = stem_events(stem_through({plus, minus}));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].feature, Feature::TripleCurve);
  EXPECT_FALSE(events[0].dominant_jumps);
  // The same with a stored point on the spine, and with two.
  const Tensor<double> zero{};
  for (const auto& tensors :
       {std::vector{plus, zero, minus}, std::vector{plus, zero, zero, minus}}) {
    const auto split = stem_events(stem_through(tensors));
    ASSERT_EQ(split.size(), 1u);
    EXPECT_EQ(split[0].feature, Feature::TripleCurve);
    EXPECT_EQ(split[0].segment, tensors.size() - 2);
    EXPECT_EQ(split[0].fraction, 0);
  }
  // To a sector that is no neighbour.
  const auto far = stem_events(stem_through({plus, zero, block(0, 0, 5, 0.5)}));
  ASSERT_EQ(far.size(), 1u);
  EXPECT_EQ(far[0].feature, Feature::TripleCurve);
  EXPECT_EQ(far[0].sector_after, 0);
}

TEST(StemEvents, PointsAndStretchesOnAPage) {
  const auto real = block(2, 0, 1, 30), page = block(1, 0, 1, 30), complex = block(0, 0, 1, 30);
  // The crossing lies at a stored point: it is counted once, where the next segment begins.
  auto events = stem_events(stem_through({real, page, complex}));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].segment, 1u);
  EXPECT_EQ(events[0].fraction, 0);
  EXPECT_EQ(events[0].feature, Feature::DegenerateLinear);
  // Back to where it came from: no crossing. Along the page: a crossing where it leaves it.
  EXPECT_TRUE(stem_events(stem_through({real, page, real})).empty());
  events = stem_events(stem_through({real, page, block(1, 0, 1, 31), complex}));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].segment, 2u);
  EXPECT_EQ(events[0].feature, Feature::DegenerateLinear);
  EXPECT_TRUE(stem_events(stem_through({page, real})).empty());
}

TEST(StemEvents, LeapsAreNoSegments) {
  auto stem = stem_through(
      {block(1, 0, 0, 30), block(2, 0, 1, 30), block(2, 0, 1, 30), block(3, 0, 1, 30)});
  EXPECT_TRUE(stem_events(stem).empty());
  stem.points[1].tensor = stem.points[2].tensor = block(1, 0, 2, 30);
  stem.leaps = {1};
  const auto events = stem_events(stem);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].segment, 0u);
  EXPECT_EQ(events[1].segment, 2u);
}

/// Against dense sampling with certified signs: what samples see must be there in that order, and
/// what is there lies in the samples or between two of them.
TEST(StemEvents, AgreeWithDenseSampling) {
  std::mt19937_64 random(2024);
  const auto entry = [&] { return static_cast<double>(random() % 4097) / 2048 - 1; };
  int crossings = 0, several = 0;
  for (int n = 0; n < 300; ++n) {
    Tensor<double> a, b;
    for (double& x : a) x = entry();
    for (double& x : b) x = entry();
    const SegmentSectors s = sectors_along(a, b);
    constexpr int kSamples = 1024;
    std::size_t at = 0;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      Tensor<double> x;  // exact: entries are multiples of 2^-11, t of 2^-10
      for (int k = 0; k < 9; ++k) x[k] = (1 - t) * a[k] + t * b[k];
      const Classification c = classify(x);
      if (c.stratum != Stratum::Sector) continue;
      while (at + 1 < s.stretches.size() && s.stretches[at + 1].begin_approx < t) ++at;
      EXPECT_EQ(s.stretches[at].sector, c.number) << n << " " << t;
    }
    const int only = only_sector(a, b);
    if (only >= 0) {
      EXPECT_EQ(sectors(s), std::vector<int>{only});
    }
    crossings += sectors(s).size() > 1;
    several += sectors(s).size() > 2;
    // The other way round: the same sectors backwards.
    auto reversed = sectors(sectors_along(b, a));
    std::reverse(reversed.begin(), reversed.end());
    EXPECT_EQ(sectors(s), reversed);
  }
  EXPECT_GT(crossings, 150);
  EXPECT_GT(several, 50);
}

}  // namespace
}  // namespace triplex

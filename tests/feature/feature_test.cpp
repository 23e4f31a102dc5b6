// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/feature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>

namespace triplex {
namespace {

// A -> -A keeps p and negates q.
Feature negated(Feature f) {
  if (f == Feature::TripleCurve) return f;
  return static_cast<Feature>((kPages - static_cast<int>(f)) % kPages);
}

// A point of the page in the (p, q) plane, at p = -3 where p < 0.
std::array<double, 2> point_on_page(const FeatureRow& page) {
  const int p = static_cast<int>(page.sign_p);
  const int q = static_cast<int>(page.sign_q);
  return {3.0 * p, 2.0 * q};
}

double angle(const FeatureRow& page) {
  const auto [p, q] = point_on_page(page);
  const double a = std::atan2(q, p);
  return a < 0 ? a + 2 * std::numbers::pi : a;
}

// The level function of a sheet as the header defines it.
double sheet_value(Sheet sheet, double p, double q) {
  const double v = std::sqrt(std::max(0.0, -p) / 3);
  switch (sheet) {
    case Sheet::Balanced:
      return p;
    case Sheet::Neutral:
      return q;
    case Sheet::DegenerateLinear:
      return q - 2 * v * v * v;
    case Sheet::DegeneratePlanar:
      return q + 2 * v * v * v;
  }
  return std::nan("");
}

TEST(Feature, RowsStandInTheOrderOfTheEnumeration) {
  for (int k = 0; k < kFeatures; ++k) {
    EXPECT_EQ(static_cast<int>(feature_table()[static_cast<std::size_t>(k)].feature), k);
    EXPECT_EQ(row(static_cast<Feature>(k)).feature, static_cast<Feature>(k));
  }
}

TEST(Feature, NamesAreTheFileStemsAndLeadBack) {
  const std::set<std::string_view> expected = {
      "degenerate-linear", "degenerate-planar", "neutral-real", "neutral-complex",
      "balanced-linear",   "balanced-planar",   "triple-curve"};
  std::set<std::string_view> names;
  for (const FeatureRow& r : feature_table()) {
    names.insert(r.name);
    EXPECT_EQ(feature_named(r.name), r.feature);
  }
  EXPECT_EQ(names, expected);
  for (const char* wrong : {"", "degenerate", "Degenerate-linear", "neutral-real ", "spine"}) {
    EXPECT_FALSE(feature_named(wrong).has_value()) << wrong;
  }
}

TEST(Feature, NegationOfTheTensorSwapsLinearAndPlanar) {
  for (const FeatureRow& r : feature_table()) {
    const FeatureRow& n = row(negated(r.feature));
    EXPECT_EQ(n.sign_p, r.sign_p) << r.name;
    EXPECT_EQ(n.sign_q, -r.sign_q) << r.name;
    EXPECT_EQ(negated(n.feature), r.feature);
    std::string swapped(r.name);
    if (const auto at = swapped.find("linear"); at != std::string::npos) {
      swapped.replace(at, 6, "planar");
    } else if (const auto other = swapped.find("planar"); other != std::string::npos) {
      swapped.replace(other, 6, "linear");
    }
    EXPECT_EQ(n.name, swapped);
  }
}

TEST(Feature, PagesAreNumberedCounterClockwiseFromThePositivePAxis) {
  EXPECT_EQ(angle(feature_table()[0]), 0.0);
  for (std::size_t k = 1; k < kPages; ++k) {
    EXPECT_GT(angle(feature_table()[k]), angle(feature_table()[k - 1])) << feature_table()[k].name;
  }
  // Opposite pages lie on one sheet, but for the two halves of the degenerate surface.
  EXPECT_EQ(row(Feature::NeutralReal).sheet, row(Feature::NeutralComplex).sheet);
  EXPECT_EQ(row(Feature::BalancedLinear).sheet, row(Feature::BalancedPlanar).sheet);
  EXPECT_NE(row(Feature::DegenerateLinear).sheet, row(Feature::DegeneratePlanar).sheet);
}

TEST(Feature, EveryPageLiesOnItsSheet) {
  for (const FeatureRow& r : feature_table()) {
    const auto [p, q] = point_on_page(r);
    EXPECT_EQ(sheet_value(r.sheet, p, q), 0.0) << r.name;
  }
  // Both degenerate sheets go on as the complex neutral surface.
  EXPECT_EQ(sheet_value(Sheet::DegenerateLinear, 3, 0), 0.0);
  EXPECT_EQ(sheet_value(Sheet::DegeneratePlanar, 3, 0), 0.0);
}

TEST(Feature, ColorsAreThePapers) {
  const auto hue = [](Feature f) { return row(f).color; };
  const auto [gr, gg, gb] = hue(Feature::DegenerateLinear);
  EXPECT_TRUE(gg > gr && gg > gb);  // green
  const auto [yr, yg, yb] = hue(Feature::DegeneratePlanar);
  EXPECT_TRUE(yr > 0.8 && yg > 0.8 && yb < 0.3);  // yellow
  const auto [orange_r, orange_g, orange_b] = hue(Feature::NeutralReal);
  EXPECT_TRUE(orange_r > 0.8 && orange_g > 0.4 && orange_g < 0.7 && orange_b < 0.3);  // orange
  const auto [rr, rg, rb] = hue(Feature::NeutralComplex);
  EXPECT_TRUE(rr > 0.7 && rg < 0.3 && rb < 0.3);  // red
  const auto [br, bg, bb] = hue(Feature::BalancedLinear);
  EXPECT_TRUE(bb > br && bb > bg);  // blue
  const auto [mr, mg, mb] = hue(Feature::BalancedPlanar);
  EXPECT_TRUE(mr > 0.7 && mg < 0.3 && mb > 0.7);  // magenta
  EXPECT_EQ(hue(Feature::TripleCurve), (std::array<double, 3>{0, 0, 0}));
  for (const FeatureRow& r : feature_table()) {
    for (const double channel : r.color) EXPECT_TRUE(channel >= 0 && channel <= 1) << r.name;
  }
}

TEST(Feature, SetsAreBits) {
  FeatureSet all = 0;
  for (const FeatureRow& r : feature_table()) {
    EXPECT_EQ(all & bit(r.feature), 0);
    all = static_cast<FeatureSet>(all | bit(r.feature));
  }
  EXPECT_EQ(all, kAllFeatures);
}

}  // namespace
}  // namespace triplex

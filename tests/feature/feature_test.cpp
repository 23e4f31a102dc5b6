// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/feature_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

namespace triplex {
namespace {

const FeatureTable kTable;

// A -> -A keeps p and negates q.
Feature negated(Feature f) {
  if (f == Feature::TripleCurve) return f;
  return static_cast<Feature>((kStandardPages - static_cast<int>(f)) % kStandardPages);
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
double sheet_value(const Sheet& sheet, double p, double q) {
  if (sheet.kind == Sheet::Kind::Balanced) return p;
  if (sheet.kind == Sheet::Kind::Neutral) return q;
  const double v = std::sqrt(std::max(0.0, -sheet.map.p_factor * p) / 3);
  return sheet.map.q_factor * q - static_cast<int>(sheet.sign_q) * 2 * v * v * v;
}

TEST(Feature, RowsStandInTheOrderOfTheEnumeration) {
  for (int k = 0; k < kStandardFeatures; ++k) {
    EXPECT_EQ(static_cast<int>(kTable.rows()[static_cast<std::size_t>(k)].feature), k);
    EXPECT_EQ(kTable.row(static_cast<Feature>(k)).feature, static_cast<Feature>(k));
  }
}

TEST(Feature, NamesAreTheFileStemsAndLeadBack) {
  const std::set<std::string_view> expected = {
      "degenerate-linear", "degenerate-planar", "neutral-real", "neutral-complex",
      "balanced-linear",   "balanced-planar",   "triple-curve"};
  std::set<std::string_view> names;
  for (const FeatureRow& r : kTable.rows()) {
    names.insert(r.name);
    EXPECT_EQ(kTable.named(r.name), r.feature);
  }
  EXPECT_EQ(names, expected);
  for (const char* wrong : {"", "degenerate", "Degenerate-linear", "neutral-real ", "spine"}) {
    EXPECT_FALSE(kTable.named(wrong).has_value()) << wrong;
  }
}

TEST(Feature, NegationOfTheTensorSwapsLinearAndPlanar) {
  for (const FeatureRow& r : kTable.rows()) {
    const FeatureRow& n = kTable.row(negated(r.feature));
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
  EXPECT_EQ(angle(kTable.rows()[0]), 0.0);
  for (std::size_t k = 1; k < kStandardPages; ++k) {
    EXPECT_GT(angle(kTable.rows()[k]), angle(kTable.rows()[k - 1])) << kTable.rows()[k].name;
  }
  // Opposite pages lie on one sheet, but for the two halves of the degenerate surface.
  EXPECT_EQ(kTable.sheet_number(Feature::NeutralReal),
            kTable.sheet_number(Feature::NeutralComplex));
  EXPECT_EQ(kTable.sheet_number(Feature::BalancedLinear),
            kTable.sheet_number(Feature::BalancedPlanar));
  EXPECT_NE(kTable.sheet_number(Feature::DegenerateLinear),
            kTable.sheet_number(Feature::DegeneratePlanar));
}

TEST(Feature, EveryPageLiesOnItsSheet) {
  for (const FeatureRow& r : kTable.rows()) {
    const auto [p, q] = point_on_page(r);
    if (r.kind != FeatureKind::Page) continue;
    EXPECT_EQ(sheet_value(kTable.sheet(r.feature), p, q), 0.0) << r.name;
  }
  // Both degenerate sheets go on as the complex neutral surface.
  EXPECT_EQ(sheet_value(kTable.sheet(Feature::DegenerateLinear), 3, 0), 0.0);
  EXPECT_EQ(sheet_value(kTable.sheet(Feature::DegeneratePlanar), 3, 0), 0.0);
}

TEST(Feature, ColorsAreThePapers) {
  const auto hue = [](Feature f) { return kTable.row(f).color; };
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
  for (const FeatureRow& r : kTable.rows()) {
    for (const double channel : r.color) EXPECT_TRUE(channel >= 0 && channel <= 1) << r.name;
  }
}

TEST(Feature, SetsAreBits) {
  FeatureSet all = 0;
  for (const FeatureRow& r : kTable.rows()) {
    EXPECT_EQ(all & bit(r.feature), 0u);
    all |= bit(r.feature);
  }
  EXPECT_EQ(all, kStandardSet);
  EXPECT_EQ(all, kTable.all());
}

constexpr Sign kMinus = Sign::Negative, kPlus = Sign::Positive, kNone = Sign::Zero;

TEST(FeatureTable, SpecialModesAreTheNamedPages) {
  FeatureTable table;
  EXPECT_EQ(table.add_mode({0, 1}, kMinus, kPlus), Feature::NeutralReal);
  EXPECT_EQ(table.add_mode({0, 7}, kPlus, kMinus), Feature::NeutralComplex);
  EXPECT_EQ(table.add_mode({0, 1}, kPlus, kNone), Feature::NeutralComplex);
  EXPECT_EQ(table.add_mode({1, 0}, kMinus, kPlus), Feature::BalancedLinear);
  EXPECT_EQ(table.add_mode({2, 0}, kNone, kMinus), Feature::BalancedPlanar);
  EXPECT_EQ(table.add_mode({3, 3}, kMinus, kPlus), Feature::DegenerateLinear);
  EXPECT_EQ(table.add_mode({1, 1}, kMinus, kMinus), Feature::DegeneratePlanar);
  EXPECT_EQ(table.size(), kStandardFeatures);
  EXPECT_GE(index(table.add_mode({1, 1}, kPlus, kPlus)), std::size_t{kStandardFeatures});
}

TEST(FeatureTable, AddedRowsHaveTheirOwnNamesAndAreAddedOnce) {
  FeatureTable table;
  const Feature half = table.add_mode({1, 2}, kMinus, kPlus);
  EXPECT_EQ(table.row(half).name, "mode-1_2-p-neg-q-pos");
  EXPECT_EQ(table.add_mode({2, 4}, kMinus, kPlus), half);
  EXPECT_NE(table.add_mode({1, 2}, kMinus, kMinus), half);
  EXPECT_NE(table.add_mode({1, 2}, kPlus, kPlus), half);
  EXPECT_EQ(table.row(table.add_magnitude(2.5)).name, "magnitude-2.5");
  EXPECT_EQ(table.row(table.add_isotropicity(-0.25)).name, "isotropicity-neg-0.25");
  EXPECT_EQ(table.add_isotropicity(-0.0), table.add_traceless());
  EXPECT_EQ(table.size(), kStandardFeatures + 6);
  std::set<std::string> names;
  for (const FeatureRow& r : table.rows()) {
    names.insert(r.name);
    EXPECT_EQ(table.named(r.name), r.feature);
    EXPECT_EQ(contains(table.level_sets(), r.feature), r.kind == FeatureKind::LevelSet);
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(table.size()));
}

TEST(FeatureTable, RefusesWhatIsNoFeature) {
  FeatureTable table;
  EXPECT_THROW(table.add_mode({0, 0}, kMinus, kPlus), BadFeature);
  EXPECT_THROW(table.add_mode({1, 1}, kNone, kNone), BadFeature);
  EXPECT_THROW(table.add_mode({1, 0}, kMinus, kNone), BadFeature);
  EXPECT_THROW(table.add_mode({1, 2}, kMinus, kNone), BadFeature);
  EXPECT_THROW(table.add_mode({1, 2}, kNone, kMinus), BadFeature);
  EXPECT_THROW(table.add_mode({100'001, 2}, kMinus, kPlus), BadFeature);
  EXPECT_THROW(table.add_mode({2, 100'001}, kMinus, kPlus), BadFeature);
  for (const double s : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_THROW(table.add_magnitude(s), BadFeature) << s;
  for (const double eta : {1.0, -1.0, 1.5, std::nan("")})
    EXPECT_THROW(table.add_isotropicity(eta), BadFeature) << eta;
  EXPECT_EQ(table.size(), kStandardFeatures);
  for (int n = table.size(); n < kMaxFeatures; ++n) table.add_magnitude(n);
  EXPECT_EQ(table.all(), ~FeatureSet{0});
  EXPECT_THROW(table.add_magnitude(1000), BadFeature);
  EXPECT_NO_THROW(table.add_magnitude(kMaxFeatures - 1));  // is there already
}

/// The pages stand by angle, taken from a point of each; sectors have the signs of the plane
/// between.
TEST(FeatureTable, TheBookIsInOrderWhateverIsAdded) {
  FeatureTable table;
  for (const ModeRatio mu : {ModeRatio{3, 1}, {1, 3}, {1, 2}, {7, 5}})
    for (const Sign p : {kMinus, kPlus})
      for (const Sign q : {kMinus, kPlus}) table.add_mode(mu, p, q);
  ASSERT_EQ(table.page_count(), 6 + 16);
  const auto angle_of = [&](int k) {
    const FeatureRow& r = table.row(table.page(k));
    const double p = r.sign_p == kNone ? 0 : static_cast<int>(r.sign_p);
    const double height = r.mode.is_infinite() ? 1 : 2 * r.mode.value() / std::pow(3, 1.5);
    const double a = std::atan2(static_cast<int>(r.sign_q) * height, p);
    return a < 0 ? a + 2 * std::numbers::pi : a;
  };
  for (int k = 0; k < table.page_count(); ++k) {
    EXPECT_EQ(table.position(table.page(k)), k);
    if (k > 0) {
      EXPECT_GT(angle_of(k), angle_of(k - 1));
    }
    const double next = k + 1 < table.page_count() ? angle_of(k + 1) : 2 * std::numbers::pi;
    const double middle = (angle_of(k) + next) / 2;
    const auto sector = static_cast<Sector>(k);
    EXPECT_EQ(table.sign_p(sector) == kPlus, std::cos(middle) > 0) << k;
    EXPECT_EQ(table.sign_q(sector) == kPlus, std::sin(middle) > 0) << k;
    const Domain domain = table.domain(sector);
    EXPECT_LE(table.position(table.row(kTable.page(static_cast<int>(domain))).feature), k);
  }
}

TEST(FeatureTable, MapsTakePagesToDegenerateOnes) {
  FeatureTable table;
  for (const Sign p : {kMinus, kPlus})
    for (const Sign q : {kMinus, kPlus}) {
      const Feature f = table.add_mode({7, 5}, p, q);
      const double w = 1.25, x = static_cast<int>(p) * 3 * w * w;
      const double y = static_cast<int>(q) * (7.0 / 5) * 2 * w * w * w;
      const double size = table.sheet(f).map.q_factor * std::fabs(y);
      EXPECT_NEAR(sheet_value(table.sheet(f), x, y), 0, 1e-14 * size);
      // On the other side of p = 0 the sheet is neutral.
      EXPECT_EQ(sheet_value(table.sheet(f), -x, 0), 0.0);
    }
}

}  // namespace
}  // namespace triplex

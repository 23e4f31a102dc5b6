// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/feature_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace triplex {
namespace {

using Color = std::array<double, 3>;

constexpr Color kRed = {0.84, 0.10, 0.11}, kBlue = {0.12, 0.32, 0.90}, kGreen = {0.13, 0.63, 0.22},
                kOrange = {0.96, 0.51, 0.12}, kYellow = {0.97, 0.85, 0.16},
                kMagenta = {0.83, 0.16, 0.78}, kBlack = {0.0, 0.0, 0.0};
constexpr Color kNavy = {0.05, 0.08, 0.42}, kBrown = {0.55, 0.32, 0.13}, kPink = {0.95, 0.62, 0.72},
                kTeal = {0.06, 0.53, 0.53};

constexpr ModeRatio kZero = {0, 1}, kOne = {1, 1}, kInfinity = {1, 0};

FeatureRow page_row(Feature feature, std::string name, std::string title, Sign sign_p, Sign sign_q,
                    ModeRatio mode, Color color) {
  return {feature, FeatureKind::Page, std::move(name), std::move(title), sign_p, sign_q, mode, {},
          color};
}
FeatureRow level_row(std::string name, std::string title, LevelSet level, Color color) {
  return {{},
          FeatureKind::LevelSet,
          std::move(name),
          std::move(title),
          Sign::Zero,
          Sign::Zero,
          kZero,
          level,
          color};
}

/// In the order of `Feature`.
std::vector<FeatureRow> standard_rows() {
  constexpr Sign minus = Sign::Negative, zero = Sign::Zero, plus = Sign::Positive;
  return {
      page_row(Feature::NeutralComplex, "neutral-complex", "complex neutral surface", plus, zero,
               kZero, kRed),
      page_row(Feature::BalancedLinear, "balanced-linear", "linear balanced surface", zero, plus,
               kInfinity, kBlue),
      page_row(Feature::DegenerateLinear, "degenerate-linear", "linear degenerate surface", minus,
               plus, kOne, kGreen),
      page_row(Feature::NeutralReal, "neutral-real", "real neutral surface", minus, zero, kZero,
               kOrange),
      page_row(Feature::DegeneratePlanar, "degenerate-planar", "planar degenerate surface", minus,
               minus, kOne, kYellow),
      page_row(Feature::BalancedPlanar, "balanced-planar", "planar balanced surface", zero, minus,
               kInfinity, kMagenta),
      {Feature::TripleCurve,
       FeatureKind::Curve,
       "triple-curve",
       "triple degenerate curve",
       zero,
       zero,
       kZero,
       {},
       kBlack},
  };
}

Color mix(const Color& a, const Color& b, double t) {
  Color c;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = (1 - t) * a[k] + t * b[k];
  return c;
}
/// Between the colours of the named pages on either side.
Color color_of_mode(double mu, Sign sign_p, Sign sign_q) {
  const bool linear = sign_q == Sign::Positive;
  const Color& balanced = linear ? kBlue : kMagenta;
  if (sign_p == Sign::Positive) return mix(kRed, balanced, mu / (1 + mu));
  const Color& degenerate = linear ? kGreen : kYellow;
  return mu < 1 ? mix(kOrange, degenerate, mu) : mix(degenerate, balanced, 1 - 1 / mu);
}

std::string text_of(ModeRatio mu) {
  return mu.denominator == 1 ? fmt::format("{}", mu.numerator)
                             : fmt::format("{}_{}", mu.numerator, mu.denominator);
}
std::string_view text_of(Sign s) { return s == Sign::Negative ? "neg" : "pos"; }

/// A file name has no sign in front of its number: an option might be taken for it.
std::string signed_text(double value) {
  return value < 0 ? fmt::format("neg-{}", -value) : fmt::format("{}", value);
}

/// Counter-clockwise in the (p, q) plane, from the positive p axis: the mode rises from neutral to
/// balanced in the quadrants p q > 0 and falls in the others.
bool precedes(const FeatureRow& a, const FeatureRow& b) {
  const auto slot = [](const FeatureRow& r) {  // the half axes 0, 2, 4, 6, the quadrants between
    constexpr int kSlots[3][3] = {{5, 4, 3}, {6, -1, 2}, {7, 0, 1}};  // [p][q], signs - 0 +
    return kSlots[static_cast<int>(r.sign_p) + 1][static_cast<int>(r.sign_q) + 1];
  };
  const int i = slot(a), j = slot(b);
  if (i != j) return i < j;
  return i == 1 || i == 5 ? a.mode < b.mode : b.mode < a.mode;
}

Sheet sheet_carrying(const FeatureRow& row) {
  const double n = row.mode.numerator, d = row.mode.denominator;
  const double p_factor = row.sign_p == Sign::Negative ? n * n : -n * n;
  return {Sheet::Kind::Curved, row.sign_p, row.sign_q, {p_factor, d * n * n}};
}

}  // namespace

double ModeRatio::value() const {
  return is_infinite() ? HUGE_VAL : static_cast<double>(numerator) / denominator;
}

const FeatureTable& standard_features() {
  static const FeatureTable table;
  return table;
}

FeatureTable::FeatureTable() : rows_(standard_rows()) { bind_book(); }

Feature FeatureTable::add(FeatureRow row) {
  if (const auto known = named(row.name)) return *known;
  if (rows_.size() == kMaxFeatures)
    throw BadFeature(
        fmt::format("at most {} features at once, the standard ones included", kMaxFeatures));
  row.feature = static_cast<Feature>(rows_.size());
  if (row.kind == FeatureKind::LevelSet) level_sets_ |= bit(row.feature);
  rows_.push_back(std::move(row));
  bind_book();
  return rows_.back().feature;
}

Feature FeatureTable::add_mode(ModeRatio mu, Sign sign_p, Sign sign_q) {
  if (mu.is_zero() && mu.is_infinite()) throw BadFeature("mode 0/0 is no number");
  const std::uint32_t common = std::gcd(mu.numerator, mu.denominator);
  mu.numerator /= common;
  mu.denominator /= common;
  if (std::max(mu.numerator, mu.denominator) > kMaxModeTerm)
    throw BadFeature(fmt::format("mode {}/{}: numerator and denominator may not exceed {}",
                                 mu.numerator, mu.denominator, kMaxModeTerm));
  if ((sign_p == Sign::Zero && !mu.is_infinite()) || (sign_q == Sign::Zero && !mu.is_zero()))
    throw BadFeature(fmt::format("mode {}/{}: p is 0 only where the mode is inf, q where it is 0",
                                 mu.numerator, mu.denominator));
  const bool linear = sign_q == Sign::Positive;
  if (mu.is_zero())
    return sign_p == Sign::Negative ? Feature::NeutralReal : Feature::NeutralComplex;
  if (mu.is_infinite()) return linear ? Feature::BalancedLinear : Feature::BalancedPlanar;
  if (mu == kOne && sign_p == Sign::Negative)
    return linear ? Feature::DegenerateLinear : Feature::DegeneratePlanar;
  return add(
      page_row({}, fmt::format("mode-{}-p-{}-q-{}", text_of(mu), text_of(sign_p), text_of(sign_q)),
               fmt::format("mode surface {}/{}, p {} 0, q {} 0", mu.numerator, mu.denominator,
                           sign_p == Sign::Negative ? '<' : '>', linear ? '>' : '<'),
               sign_p, sign_q, mu, color_of_mode(mu.value(), sign_p, sign_q)));
}

Feature FeatureTable::add_magnitude(double s) {
  if (!(s > 0) || !std::isfinite(s))
    throw BadFeature(fmt::format("magnitude {}: must be positive and finite", s));
  return add(level_row(fmt::format("magnitude-{}", s), fmt::format("magnitude surface {}", s),
                       {LevelSet::Kind::Magnitude, s}, kNavy));
}

Feature FeatureTable::add_isotropicity(double eta) {
  if (!(std::fabs(eta) < 1))
    throw BadFeature(fmt::format("isotropicity {}: must lie between -1 and 1", eta));
  if (eta == 0) return add_traceless();
  return add(level_row(fmt::format("isotropicity-{}", signed_text(eta)),
                       fmt::format("isotropicity surface {}", eta),
                       {LevelSet::Kind::Isotropicity, eta}, eta < 0 ? kPink : kBrown));
}

Feature FeatureTable::add_traceless() {
  return add(level_row("traceless", "traceless surface", {LevelSet::Kind::Traceless, 0}, kTeal));
}

void FeatureTable::bind_book() {
  book_.clear();
  for (const FeatureRow& row : rows_)
    if (row.kind == FeatureKind::Page) book_.push_back(row.feature);
  std::ranges::sort(book_, [&](Feature a, Feature b) { return precedes(row(a), row(b)); });

  position_.assign(rows_.size(), -1);
  for (std::size_t k = 0; k < book_.size(); ++k) position_[index(book_[k])] = static_cast<int>(k);

  sheets_ = {{Sheet::Kind::Balanced, {}, {}, {}}, {Sheet::Kind::Neutral, {}, {}, {}}};
  sheet_of_.assign(rows_.size(), -1);
  curved_.clear();
  with_p_ = with_q_ = {};
  for (const FeatureRow& row : rows_) {
    if (row.kind == FeatureKind::LevelSet) continue;
    if (row.sign_p != Sign::Zero) with_p_[row.sign_p == Sign::Positive] |= bit(row.feature);
    if (row.sign_q != Sign::Zero) with_q_[row.sign_q == Sign::Positive] |= bit(row.feature);
    if (row.kind == FeatureKind::Curve) continue;
    if (row.sign_p == Sign::Zero || row.sign_q == Sign::Zero) {
      sheet_of_[index(row.feature)] = row.sign_p == Sign::Zero ? kBalancedSheet : kNeutralSheet;
      continue;
    }
    sheet_of_[index(row.feature)] = static_cast<int>(sheets_.size());
    sheets_.push_back(sheet_carrying(row));
    curved_.push_back(row.feature);
  }
}

std::optional<Feature> FeatureTable::named(std::string_view name) const {
  const auto found = std::ranges::find(rows_, name, &FeatureRow::name);
  if (found == rows_.end()) return std::nullopt;
  return found->feature;
}

FeatureSet FeatureTable::all() const {
  return static_cast<FeatureSet>((std::uint64_t{1} << rows_.size()) - 1);
}

Domain FeatureTable::domain(Sector s) const {
  constexpr std::array kNamed = {Feature::NeutralComplex,   Feature::BalancedLinear,
                                 Feature::DegenerateLinear, Feature::NeutralReal,
                                 Feature::DegeneratePlanar, Feature::BalancedPlanar};
  int domain = 0;
  for (std::size_t k = 0; k < kNamed.size(); ++k)
    if (position(kNamed[k]) <= index(s)) domain = static_cast<int>(k);
  return static_cast<Domain>(domain);
}

std::string_view name_of(Domain domain) {
  constexpr std::array<std::string_view, kDomains> kNames = {
      "inner-complex-linear", "outer-complex-linear", "real-linear",
      "real-planar",          "outer-complex-planar", "inner-complex-planar"};
  return kNames[static_cast<std::size_t>(domain)];
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "triplex/feature/feature.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// A sector of the (p, q) plane: with K pages, sector k lies between page k and page k + 1 (mod K).
enum class Sector : std::uint8_t {};
constexpr int index(Sector s) { return static_cast<int>(s); }

/// The six domains: the sectors between the six named pages, counter-clockwise.
enum class Domain : std::uint8_t {
  InnerComplexLinear = 0,  ///< p > 0, q > 0
  OuterComplexLinear = 1,  ///< p < 0, q > 0, D < 0
  RealLinear = 2,          ///< p < 0, q > 0, D > 0
  RealPlanar = 3,          ///< p < 0, q < 0, D > 0
  OuterComplexPlanar = 4,  ///< p < 0, q < 0, D < 0
  InnerComplexPlanar = 5,  ///< p > 0, q < 0
};
inline constexpr std::size_t kDomains = 6;
/// real-linear, outer-complex-planar and so on: the keys of the report.
std::string_view name_of(Domain domain);

/// Raised by a feature that cannot be: a value out of range, or more rows than a `FeatureSet` has
/// bits.
class BadFeature : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The features that can be asked for, one row each, and the book they make: the pages in
/// counter-clockwise order around the origin of the (p, q) plane, from the positive p axis.
class FeatureTable {
 public:
  /// The seven standard rows.
  FeatureTable();

  /// The mode surface (mu, sign p, sign q): q = sign(q) mu 2 w^3, w = sqrt(|p|/3). Special modes
  /// are the named pages: mu = 0 neutral, where sign q does not count, mu = infinity balanced,
  /// where sign p does not (either may be Zero there, and only there), mu = 1 with p < 0
  /// degenerate. A row that exists is returned as it is. \throw BadFeature.
  Feature add_mode(ModeRatio mu, Sign sign_p, Sign sign_q);
  /// |T| = s. \throw BadFeature unless s > 0 is finite.
  Feature add_magnitude(double s);
  /// tr(T) = sqrt(3) eta |T|; eta = 0 is the traceless surface. \throw BadFeature unless |eta| < 1.
  Feature add_isotropicity(double eta);
  /// tr(T) = 0.
  Feature add_traceless();

  int size() const { return static_cast<int>(rows_.size()); }
  const std::vector<FeatureRow>& rows() const { return rows_; }
  const FeatureRow& row(Feature f) const { return rows_[index(f)]; }
  std::optional<Feature> named(std::string_view name) const;
  /// All rows.
  FeatureSet all() const;
  /// The rows that are level sets.
  FeatureSet level_sets() const { return level_sets_; }
  /// Pages and curve that allow p (q) to have that sign. \pre s is not Zero.
  FeatureSet with_sign_of_p(Sign s) const { return with_p_[s == Sign::Positive]; }
  FeatureSet with_sign_of_q(Sign s) const { return with_q_[s == Sign::Positive]; }

  /// The book.
  int page_count() const { return static_cast<int>(book_.size()); }
  Feature page(int position) const { return book_[static_cast<std::size_t>(position)]; }
  int position(Feature page) const { return position_[index(page)]; }
  /// The sheets that carry the pages: Balanced, Neutral, then one for each curved page.
  const std::vector<Sheet>& sheets() const { return sheets_; }
  int sheet_number(Feature page) const { return sheet_of_[index(page)]; }
  const Sheet& sheet(Feature page) const {
    return sheets_[static_cast<std::size_t>(sheet_number(page))];
  }
  /// The page that a curved sheet carries, by the number of the sheet.
  Feature curved_page(int sheet_number) const {
    return curved_[static_cast<std::size_t>(sheet_number - kFlatSheets)];
  }

  Sign sign_p(Sector s) const {
    const int k = index(s);
    return k >= position(Feature::BalancedLinear) && k < position(Feature::BalancedPlanar)
               ? Sign::Negative
               : Sign::Positive;
  }
  Sign sign_q(Sector s) const {
    return index(s) < position(Feature::NeutralReal) ? Sign::Positive : Sign::Negative;
  }
  Domain domain(Sector s) const;

 private:
  Feature add(FeatureRow row);
  void bind_book();

  std::vector<FeatureRow> rows_;
  std::vector<Feature> book_;
  std::vector<int> position_, sheet_of_;  // per row; -1 where it is no page
  std::vector<Sheet> sheets_;
  std::vector<Feature> curved_;
  FeatureSet level_sets_ = 0;
  std::array<FeatureSet, 2> with_p_{}, with_q_{};
};

/// The table with the seven standard rows only.
const FeatureTable& standard_features();

}  // namespace triplex

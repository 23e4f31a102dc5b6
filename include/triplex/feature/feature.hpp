// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "triplex/arithmetic/sign.hpp"

namespace triplex {

/// The six surfaces are the six pages of the paper's book: rays from the origin of the (p, q)
/// plane, numbered counter-clockwise from the positive p axis. The triple degenerate curve is the
/// spine.
enum class Feature : std::uint8_t {
  NeutralComplex = 0,    ///< q = 0, p > 0
  BalancedLinear = 1,    ///< p = 0, q > 0
  DegenerateLinear = 2,  ///< q = +2 w^3, p < 0, w = sqrt(-p/3)
  NeutralReal = 3,       ///< q = 0, p < 0
  DegeneratePlanar = 4,  ///< q = -2 w^3, p < 0
  BalancedPlanar = 5,    ///< p = 0, q < 0
  TripleCurve = 6,       ///< p = q = 0
};
inline constexpr int kPages = 6;
inline constexpr int kFeatures = 7;

/// The four smooth sheets that carry the pages; each is one C^1 level set f = 0.
/// `DegenerateLinear` is G+ = q - 2 v^3 and `DegeneratePlanar` G- = q + 2 v^3, v =
/// sqrt(max(0,-p)/3): for p > 0 both continue as the complex neutral surface.
enum class Sheet : std::uint8_t {
  Balanced = 0,
  Neutral = 1,
  DegenerateLinear = 2,
  DegeneratePlanar = 3
};
inline constexpr int kSheets = 4;

/// One row of the table of features.
struct FeatureRow {
  Feature feature;
  std::string_view name;   ///< file stem and JSON key
  std::string_view title;  ///< for people
  Sheet sheet;  ///< the sheet whose zero set carries the page (spine: Balanced and Neutral)
  Sign sign_p;  ///< on the page
  Sign sign_q;  ///< on the page
  std::array<double, 3> color;  ///< RGB in [0,1], the paper's colours
};

/// All features, in the order of `Feature`.
const std::array<FeatureRow, kFeatures>& feature_table();
inline const FeatureRow& row(Feature f) { return feature_table()[static_cast<std::size_t>(f)]; }
/// The feature of that name, or nothing.
std::optional<Feature> feature_named(std::string_view name);

/// A set of features, as bits.
using FeatureSet = std::uint8_t;
constexpr FeatureSet bit(Feature f) {
  return static_cast<FeatureSet>(1u << static_cast<unsigned>(f));
}
constexpr FeatureSet bit(int page) { return static_cast<FeatureSet>(1u << page); }
inline constexpr FeatureSet kAllFeatures = 0x7f;

}  // namespace triplex

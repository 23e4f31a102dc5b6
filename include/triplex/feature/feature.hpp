// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "triplex/arithmetic/sign.hpp"
#include "triplex/feature/level_set.hpp"

namespace triplex {

/// A feature is a row of a `FeatureTable`. The first seven rows are the same in every table: the
/// six surfaces are pages of the paper's book, rays from the origin of the (p, q) plane, and the
/// triple degenerate curve is its spine. Rows that a user adds follow.
enum class Feature : std::uint8_t {
  NeutralComplex = 0,    ///< q = 0, p > 0
  BalancedLinear = 1,    ///< p = 0, q > 0
  DegenerateLinear = 2,  ///< q = +2 w^3, p < 0, w = sqrt(-p/3)
  NeutralReal = 3,       ///< q = 0, p < 0
  DegeneratePlanar = 4,  ///< q = -2 w^3, p < 0
  BalancedPlanar = 5,    ///< p = 0, q < 0
  TripleCurve = 6,       ///< p = q = 0
};
inline constexpr int kStandardPages = 6, kStandardFeatures = 7;
constexpr std::size_t index(Feature f) { return static_cast<std::size_t>(f); }

/// A set of features, as bits.
using FeatureSet = std::uint32_t;
inline constexpr int kMaxFeatures = 32;
constexpr FeatureSet bit(Feature f) { return FeatureSet{1} << index(f); }
inline constexpr FeatureSet kStandardSet = 0x7f;
constexpr bool contains(FeatureSet set, Feature f) { return (set & bit(f)) != 0; }

/// A mode mu = numerator / denominator >= 0 in lowest terms; 1/0 is infinity.
struct ModeRatio {
  std::uint32_t numerator = 0, denominator = 1;

  bool is_zero() const { return numerator == 0; }
  bool is_infinite() const { return denominator == 0; }
  double value() const;
  friend bool operator==(const ModeRatio&, const ModeRatio&) = default;
  /// Compares the values, exactly.
  friend bool operator<(const ModeRatio& a, const ModeRatio& b) {
    return std::uint64_t{a.numerator} * b.denominator < std::uint64_t{b.numerator} * a.denominator;
  }
};
/// Terms up to here keep denominator * numerator^2 below 2^53, so that the map which takes a mode
/// page to a degenerate one has factors that are exact as doubles.
inline constexpr std::uint32_t kMaxModeTerm = 100'000;

enum class FeatureKind : std::uint8_t {
  Page,      ///< a mode surface, the named ones included
  Curve,     ///< the triple degenerate curve
  LevelSet,  ///< magnitude, isotropicity, traceless: the boundary of a convex set of tensors
};

struct FeatureRow {
  Feature feature;
  FeatureKind kind;
  std::string name;             ///< file stem and JSON key
  std::string title;            ///< for people
  Sign sign_p, sign_q;          ///< on a page; both zero for the other kinds
  ModeRatio mode;               ///< of a page
  LevelSet level;               ///< of a level set
  std::array<double, 3> color;  ///< RGB in [0,1]; the paper's colours where it has one
};

}  // namespace triplex

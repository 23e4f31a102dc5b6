// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "triplex/arithmetic/exact.hpp"

namespace triplex {

/// A closed interval with exact dyadic ends. Sums, differences and products of enclosures enclose
/// the results, without rounding; quotients and roots are rounded outwards to `kRangeBits` bits
/// after the point. For what doubles cannot tell apart.
struct ExactRange {
  Exact lo, hi;

  ExactRange() = default;
  ExactRange(const Exact& x) : lo(x), hi(x) {}    // NOLINT: ring constants
  ExactRange(double x) : ExactRange(Exact(x)) {}  // NOLINT
  ExactRange(int x) : ExactRange(Exact(x)) {}     // NOLINT
  ExactRange(Exact low, Exact high) : lo(std::move(low)), hi(std::move(high)) {}

  friend ExactRange operator+(const ExactRange& a, const ExactRange& b) {
    return {a.lo + b.lo, a.hi + b.hi};
  }
  friend ExactRange operator-(const ExactRange& a, const ExactRange& b) {
    return {a.lo - b.hi, a.hi - b.lo};
  }
  friend ExactRange operator-(const ExactRange& a) { return {-a.hi, -a.lo}; }
  friend ExactRange operator*(const ExactRange& a, const ExactRange& b);
};

inline constexpr unsigned kRangeBits = 512;
/// \pre b does not contain zero.
ExactRange operator/(const ExactRange& a, const ExactRange& b);
/// The square roots of what is not negative. \pre x.hi >= 0.
ExactRange sqrt(const ExactRange& x);
ExactRange abs(const ExactRange& x);

}  // namespace triplex

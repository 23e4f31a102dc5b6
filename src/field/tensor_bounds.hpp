// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "triplex/field/refinable_field.hpp"

namespace triplex {

inline double largest_entry(const Tensor<double>& t) {
  double m = 0;
  for (const double x : t) m = std::max(m, std::fabs(x));
  return m;
}

/// What scaling down may lose: one rounding below the smallest normal double, tripled and summed.
inline constexpr double kUnderflow = 0x1p-1070;

/// numerator / 2^depth
struct Dyadic {
  std::uint64_t numerator;
  int depth;
};

/// numerator / 2^depth, exactly: by the two words of the numerator.
inline Exact exact_dyadic(WeightNumerator numerator, int depth) {
  Exact sum;
  for (int word = 0; word < 2; ++word) {
    const auto bits = static_cast<std::uint32_t>(numerator >> (32 * word));
    if (bits != 0) sum = sum + Exact(std::ldexp(static_cast<double>(bits), 32 * word - depth));
  }
  return sum;
}

/// \pre inside (0, 1) and a multiple of 2^-63.
inline Dyadic dyadic(double x) {
  Dyadic r{static_cast<std::uint64_t>(std::ldexp(x, 63)), 63};
  while (r.numerator % 2 == 0) {
    r.numerator /= 2;
    r.depth -= 1;
  }
  return r;
}

}  // namespace triplex

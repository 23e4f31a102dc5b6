// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "triplex/certify/simplex.hpp"
#include "triplex/certify/witness.hpp"

namespace triplex {

/// v_low <= sqrt(max(0, -P) / 6) <= v_high on the simplex, tested at every coefficient of P:
/// P + 6 v_high^2 > 0, and P + 6 v_low^2 < 0 unless v_low = 0.
struct BoundsV {
  double low, high;
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    const double error =
        bounds.p_error + gamma(4) * (bounds.p_magnitude + 6 * std::max(low * low, high * high));
    const NT low_square = NT(6) * NT(low) * NT(low);
    const NT high_square = NT(6) * NT(high) * NT(high);
    AllPositive all;
    for (const NT& P : f.p) {
      if (!all.add(certainty(P + high_square, error))) break;
      if (low > 0 && !all.add(certainty(-(P + low_square), error))) break;
    }
    return all.verdict();
  }
};

/// Witness for `BoundsV`, widened so that the filter can confirm it: by 2^-20 (rounding to few
/// bits moves it by 2^-26), and by the error of P.
template <int N>
BoundsV range_of_v(const Forms<double, N>& f, const FormBounds& bounds) {
  const auto [least, most] = std::ranges::minmax(f.p);
  const double margin = 4 * bounds.p_error + gamma(16) * bounds.p_magnitude;
  BoundsV range{};
  range.high = std::sqrt(std::max(0.0, -least + margin) / 6) * (1 + 0x1p-20);
  range.low = std::sqrt(std::max(0.0, -most - margin) / 6) * (1 - 0x1p-20);
  range.high = few_bits(range.high);
  range.low = few_bits(range.low);
  return range;
}

}  // namespace triplex

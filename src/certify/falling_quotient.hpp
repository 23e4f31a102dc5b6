// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdlib>

#include "sign_changes.hpp"

namespace triplex {

/// On segments from one side of a simplex to the other, with r from 0 to 1: the sign of the
/// derivative of f / (r (1 - r)) for f = -D, as `minus_discriminant` gives it. Where it has one, f
/// has at most one root inside, a simple one. The derivative's numerator has the layers, of degree
/// 7,
///     (j - 1) f_j - (6 - j) f_(j-1),      f_j the part of f of degree j in the far side,
/// of which bit i says that vertex i is there. Of layers 0 and 1, which are -f_0 and -5 f_0,
/// nothing is said here. Source: proofs/block_plane.md.
///
/// `error` times its multinomial bounds the error of a coefficient of f. It holds gamma(25) (2
/// |P|^3
/// + 3 |Q|^2), more than the at most 5 roundings of what is done here; so twice that is enough.
template <class NT, int N>
LayerSign slope_of_quotient(const SexticCoefficients<NT, N>& f, double error, unsigned side) {
  constexpr auto& from = kMonomials<N, 6>;
  constexpr auto& to = kMonomials<N, 7>;
  const auto degree_in_side = [side](const auto& exponents) {
    int degree = 0;
    for (std::size_t i = 0; i < exponents.size(); ++i)
      if (side >> i & 1u) degree += exponents[i];
    return degree;
  };
  std::array<NT, to.count()> slope;
  slope.fill(NT(0));
  std::array<int, to.count()> weight{};
  const auto& product = product_table<N, 6, 1>().at;
  for (std::size_t n = 0; n < f.size(); ++n) {
    const int j = degree_in_side(from.exponents[n]);
    for (std::size_t i = 0; i < N; ++i) {
      const int factor = side >> i & 1u ? j - 5 : j - 1;
      NT& sum = slope[product[n][i]];
      sum = sum + NT(factor) * f[n];
      weight[product[n][i]] += std::abs(factor) * from.multinomial[n];
    }
  }
  LayerSign sign;
  for (std::size_t n = 0; n < slope.size(); ++n)
    if (degree_in_side(to.exponents[n]) > 1) sign.add(certainty(slope[n], 2 * error * weight[n]));
  return sign;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "degenerate_conic.hpp"
#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"
#include "triplex/certify/symmetric_field.hpp"

namespace triplex {

/// x 2^exponent, which may be out of the range of one double.
inline Exact times_power_of_two(Exact x, int exponent) {
  for (; exponent > 1000; exponent -= 1000) x = x * Exact(0x1p1000);
  for (; exponent < -1000; exponent += 1000) x = x * Exact(0x1p-1000);
  return x * Exact(std::ldexp(1.0, exponent));
}

/// The exponent of the power of two above the largest of some numbers; 0 if all are zero.
template <class Numbers>
int common_exponent(const Numbers& numbers) {
  bool any = false;
  int exponent = 0;
  for (const Exact& x : numbers) {
    if (x.is_zero()) continue;
    exponent = any ? std::max(exponent, binary_exponent(x)) : binary_exponent(x);
    any = true;
  }
  return exponent;
}

/// delta (B + 2^-20 B_v), tripled deviator, in the units of the input.
inline Components<Exact> shift_at(const SymmetricField& field, VertexId v) {
  constexpr std::array<std::size_t, 9> kUpper = {0, 1, 2, 1, 4, 5, 2, 5, 8};
  const auto own = own_shift(field.representative(v));
  Tensor<Exact> b;
  for (std::size_t k = 0; k < 9; ++k)
    b[k] = Exact(kPerturbation[kUpper[k]] * (1 << kOwnShiftBits) + own[kUpper[k]]);
  Components<Exact> c = components_of(triple_deviator(b));
  for (Exact& x : c)
    x = times_power_of_two(x, kShiftExponent - kOwnShiftBits - field.field().scale_exponent());
  return c;
}

/// The exact tripled deviators of a field at some vertices, scaled together so that the largest
/// entry is about one: forms of high degree in them then fit doubles.
template <std::size_t N>
std::array<Components<Exact>, N> exact_components(const SymmetricField& field,
                                                  const std::array<VertexId, N>& vertices) {
  std::array<Components<Exact>, N> m;
  std::array<int, N> exponents;
  for (std::size_t i = 0; i < N; ++i) {
    m[i] = components_of(field.field().exact(vertices[i]));
    if (field.shift() == Shift::General) {
      const Components<Exact> b = shift_at(field, vertices[i]);
      for (std::size_t k = 0; k < 5; ++k) m[i][k] = m[i][k] + b[k];
    }
    exponents[i] = common_exponent(m[i]);
  }
  const int exponent = *std::ranges::max_element(exponents);
  for (auto& a : m)
    for (Exact& x : a) x = times_power_of_two(x, -exponent);
  return m;
}

}  // namespace triplex

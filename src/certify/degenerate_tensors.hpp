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
#include "triplex/certify/degenerate_point.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// The exact tripled deviators at some vertices, scaled together so that the largest entry is about
/// one: forms of high degree in them then fit doubles.
template <std::size_t N>
std::array<Components<Exact>, N> exact_components(const RefinableField& field,
                                                  const std::array<VertexId, N>& vertices) {
  std::array<Components<Exact>, N> m;
  int exponent = -10000;
  for (std::size_t i = 0; i < N; ++i) {
    m[i] = components_of(field.exact(vertices[i]));
    for (const Exact& x : m[i])
      if (!x.is_zero()) exponent = std::max(exponent, binary_exponent(x));
  }
  if (exponent == -10000) return m;
  // In two steps: denormals need more than one double can hold.
  const Exact half(std::ldexp(1.0, -(exponent / 2))),
      rest(std::ldexp(1.0, -(exponent - exponent / 2)));
  for (auto& a : m)
    for (Exact& x : a) x = x * half * rest;
  return m;
}

/// The same tensors for T + eps B.
template <std::size_t N>
std::array<Components<Series<2>>, N> first_order(const std::array<Components<Exact>, N>& m) {
  const Components<Exact> b = components_of(symmetric_perturbation());
  std::array<Components<Series<2>>, N> r;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < 5; ++k) r[i][k] = Series<2>(m[i][k], b[k]);
  return r;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_kernel.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "linear_algebra.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

using ExactVector = std::array<Exact, 3>;

bool is_zero(const ExactVector& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

ExactVector row(const Tensor<Exact>& m, std::size_t i) {
  return {m[3 * i], m[3 * i + 1], m[3 * i + 2]};
}

ExactVector cross_product(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Scaled so that the largest component is of size one; components 2^-1074 below it are lost.
Direction direction(const ExactVector& v) {
  int exponent = std::numeric_limits<int>::min();
  for (const Exact& x : v) {
    if (!x.is_zero()) exponent = std::max(exponent, binary_exponent(x));
  }
  Direction d;
  for (int i = 0; i < 3; ++i) d[i] = v[i].is_zero() ? 0 : to_double_approx(v[i], -exponent);
  return with_fixed_sign(normalized(d));
}

}  // namespace

ExactKernel exact_kernel(const Tensor<Exact>& m) {
  // Rank two: two rows span the complement of the kernel.
  constexpr std::array<std::array<std::size_t, 2>, 3> kPairs = {{{0, 1}, {0, 2}, {1, 2}}};
  for (const auto& [i, j] : kPairs) {
    const ExactVector v = cross_product(row(m, i), row(m, j));
    if (!is_zero(v)) return {1, direction(v), kNoDirection, kNoDirection};
  }
  // Rank one: all rows are multiples of any one that is not zero.
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_zero(row(m, i))) continue;
    const Direction n = direction(row(m, i));
    const Direction first = any_orthogonal(n);
    return {2, with_fixed_sign(first), with_fixed_sign(cross(n, first)), n};
  }
  return {3, {1, 0, 0}, {0, 1, 0}, kNoDirection};
}

DegeneratePencil degenerate_pencil(const Tensor<double>& t) {
  Tensor<Exact> exact;
  for (int i = 0; i < 9; ++i) exact[i] = Exact(t[i]);
  const Tensor<Exact> a = triple_deviator(exact);
  const Forms<Exact, 1> f = forms_of<Exact, 1>({a});
  const Exact& p = f.p[0];
  const Exact& q = f.q[0];
  DegeneratePencil pencil;
  const Exact two_p = Exact(2) * p;
  for (int i = 0; i < 9; ++i) {
    pencil.repeating[i] = p.is_zero() ? a[i] : two_p * a[i];
    pencil.dominant[i] = p * a[i];
    if (i % 4 != 0) continue;
    pencil.repeating[i] = pencil.repeating[i] - q;
    pencil.dominant[i] = pencil.dominant[i] + q;
  }
  return pencil;
}

}  // namespace triplex

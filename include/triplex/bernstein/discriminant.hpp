// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/forms.hpp"

namespace triplex {

/// Homogeneous polynomials in the N barycentric coordinates, by degree: exponents in lexicographic
/// order of the descending first exponent. `multinomial` turns a monomial's coefficient into a
/// Bernstein coefficient (divide by it).
template <int N, int Degree>
struct Monomials {
  static constexpr int count() {
    int n = 1;  // binomial(Degree + N - 1, N - 1)
    for (int i = 1; i < N; ++i) n = n * (Degree + i) / i;
    return n;
  }
  std::array<std::array<std::uint8_t, N>, count()> exponents{};
  std::array<int, count()> multinomial{};

  constexpr Monomials() {
    std::array<std::uint8_t, N> e{};
    e[0] = Degree;
    for (int n = 0; n < count(); ++n) {
      exponents[n] = e;
      int m = factorial(Degree);
      for (int i = 0; i < N; ++i) m /= factorial(e[i]);
      multinomial[n] = m;
      next(e);
    }
  }
  static constexpr int factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }
  static constexpr void next(std::array<std::uint8_t, N>& e) {
    int i = N - 2;
    while (i >= 0 && e[i] == 0) --i;
    if (i < 0) return;
    const auto last = e[N - 1];
    e[N - 1] = 0;
    e[i] -= 1;
    e[i + 1] = static_cast<std::uint8_t>(last + 1);
  }
  constexpr int find(const std::array<std::uint8_t, N>& e) const {
    for (int n = 0; n < count(); ++n)
      if (exponents[n] == e) return n;
    return -1;
  }
};
template <int N, int Degree>
inline constexpr Monomials<N, Degree> kMonomials{};

/// Where the product of two monomials goes.
template <int N, int D1, int D2>
struct ProductTable {
  std::array<std::array<std::uint8_t, Monomials<N, D2>::count()>, Monomials<N, D1>::count()> at{};
  ProductTable() {
    for (int a = 0; a < Monomials<N, D1>::count(); ++a)
      for (int b = 0; b < Monomials<N, D2>::count(); ++b) {
        auto e = kMonomials<N, D1>.exponents[a];
        for (int i = 0; i < N; ++i) e[i] += kMonomials<N, D2>.exponents[b][i];
        at[a][b] = static_cast<std::uint8_t>(kMonomials<N, D1 + D2>.find(e));
      }
  }
};
template <int N, int D1, int D2>
const ProductTable<N, D1, D2>& product_table() {
  static const ProductTable<N, D1, D2> table;
  return table;
}

template <int N, int D1, int D2, class NT>
std::array<NT, Monomials<N, D1 + D2>::count()> multiply(
    const std::array<NT, Monomials<N, D1>::count()>& a,
    const std::array<NT, Monomials<N, D2>::count()>& b) {
  std::array<NT, Monomials<N, D1 + D2>::count()> r;
  r.fill(NT(0));
  const auto& table = product_table<N, D1, D2>().at;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) r[table[i][j]] = r[table[i][j]] + a[i] * b[j];
  return r;
}

template <class NT, int N>
using SexticCoefficients = std::array<NT, Monomials<N, 6>::count()>;

/// Monomial coefficients of -4 D(A') = 2 P^3 + 3 Q^2 (28 on a face, 84 on a tet); the Bernstein
/// coefficient is the monomial one over its multinomial, so signs agree.
template <class NT, int N>
SexticCoefficients<NT, N> minus_discriminant(const Forms<NT, N>& f) {
  std::array<NT, Monomials<N, 2>::count()> p;
  std::array<NT, Monomials<N, 3>::count()> q;
  // The lexicographic orders of index pairs and of exponents coincide.
  for (std::size_t n = 0; n < p.size(); ++n) p[n] = NT(kMonomials<N, 2>.multinomial[n]) * f.p[n];
  for (std::size_t n = 0; n < q.size(); ++n) q[n] = NT(kMonomials<N, 3>.multinomial[n]) * f.q[n];
  const auto p3 = multiply<N, 4, 2>(multiply<N, 2, 2>(p, p), p);
  const auto q2 = multiply<N, 3, 3>(q, q);
  SexticCoefficients<NT, N> d;
  for (std::size_t n = 0; n < d.size(); ++n) d[n] = NT(2) * p3[n] + NT(3) * q2[n];
  return d;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// Number of Bernstein coefficients of degree 2 and 3 on a simplex with N vertices.
template <int N>
inline constexpr int kPairs = N*(N + 1) / 2;
template <int N>
inline constexpr int kTriples = N*(N + 1) * (N + 2) / 6;

namespace detail {

template <int N>
struct IndexTables {
  std::array<std::array<int, N>, N> pair{};
  std::array<std::array<std::array<int, N>, N>, N> triple{};
  std::array<std::array<int, 2>, kPairs<N>> pairs{};
  std::array<std::array<int, 3>, kTriples<N>> triples{};
  constexpr IndexTables() {
    int n = 0;
    for (int i = 0; i < N; ++i)
      for (int j = i; j < N; ++j) {
        pairs[n] = {i, j};
        pair[i][j] = pair[j][i] = n++;
      }
    n = 0;
    for (int i = 0; i < N; ++i)
      for (int j = i; j < N; ++j)
        for (int k = j; k < N; ++k) {
          triples[n] = {i, j, k};
          triple[i][j][k] = triple[i][k][j] = triple[j][i][k] = n;
          triple[j][k][i] = triple[k][i][j] = triple[k][j][i] = n++;
        }
  }
};
template <int N>
inline constexpr IndexTables<N> kTables{};

}  // namespace detail

/// Position of the coefficient with vertex indices i, j (, k) in any order; and back, ascending.
/// Order: lexicographic in i <= j <= k, so (0,0), (0,1), ... and (0,0,0), (0,0,1), ... .
template <int N>
constexpr int pair_index(int i, int j) {
  return detail::kTables<N>.pair[i][j];
}
template <int N>
constexpr int triple_index(int i, int j, int k) {
  return detail::kTables<N>.triple[i][j][k];
}
template <int N>
constexpr const auto& pairs() {
  return detail::kTables<N>.pairs;
}
template <int N>
constexpr const auto& triples() {
  return detail::kTables<N>.triples;
}

/// The invariants p and q of a linear tensor field on a simplex with N vertices, as Bernstein
/// coefficients of degree two and three, free of division: with A' = 3A the tripled deviator,
///     P = -tr(A'^2) = 18 p,      Q = 6 det(A') = 162 q.
/// On the degenerate pages Q = +-12 v^3 with v = sqrt(-P/6), and 4 D(A') = -(2 P^3 + 3 Q^2).
template <class NT, int N>
struct Forms {
  std::array<NT, kPairs<N>> p;
  std::array<NT, kTriples<N>> q;

  const NT& P(int i, int j) const { return p[pair_index<N>(i, j)]; }
  const NT& Q(int i, int j, int k) const { return q[triple_index<N>(i, j, k)]; }
};

/// Polar form of the cofactor matrix, cof(A + B) - cof(A) - cof(B): entry = 4 products.
template <class NT>
Tensor<NT> mixed_cofactor(const Tensor<NT>& a, const Tensor<NT>& b) {
  const auto two_by_two = [&](int i, int j, int k, int l) {
    return (a[i] * b[j] + b[i] * a[j]) - (a[k] * b[l] + b[k] * a[l]);
  };
  return {two_by_two(4, 8, 5, 7), two_by_two(5, 6, 3, 8), two_by_two(3, 7, 4, 6),
          two_by_two(2, 7, 1, 8), two_by_two(0, 8, 2, 6), two_by_two(1, 6, 0, 7),
          two_by_two(1, 5, 2, 4), two_by_two(2, 3, 0, 5), two_by_two(0, 4, 1, 3)};
}

/// A : B = sum of the products of corresponding entries.
template <class NT>
NT double_dot(const Tensor<NT>& a, const Tensor<NT>& b) {
  NT s = a[0] * b[0];
  for (int i = 1; i < 9; ++i) s = s + a[i] * b[i];
  return s;
}

/// -tr(A B).
template <class NT>
NT minus_trace_of_product(const Tensor<NT>& a, const Tensor<NT>& b) {
  NT s = a[0] * b[0];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (i + j > 0) s = s + a[3 * i + j] * b[3 * j + i];
  return -s;
}

/// The forms of a simplex from the tripled deviators at its vertices, by polarisation:
/// P_ij = -tr(A_i A_j), Q_ijk = M(A_i, A_j) : A_k with i <= j <= k and M the mixed cofactor.
/// Each coefficient depends on its own vertices only, so a face gets the same numbers from both
/// sides.
template <class NT, int N>
Forms<NT, N> forms_of(const std::array<Tensor<NT>, N>& a) {
  Forms<NT, N> f;
  for (int i = 0; i < N; ++i) {
    for (int j = i; j < N; ++j) {
      f.p[pair_index<N>(i, j)] = minus_trace_of_product(a[i], a[j]);
      if (i < j && j == N - 1) continue;  // no third vertex after j
      const Tensor<NT> m = mixed_cofactor(a[i], a[j]);
      if (i == j) {  // Q_iij for every j, on either side of i
        for (int k = 0; k < N; ++k) f.q[triple_index<N>(i, i, k)] = double_dot(m, a[k]);
      } else {
        for (int k = j + 1; k < N; ++k) f.q[triple_index<N>(i, j, k)] = double_dot(m, a[k]);
      }
    }
  }
  return f;
}

/// The forms of the sub-simplex spanned by some of the vertices: a selection of coefficients.
template <int K, class NT, int N>
Forms<NT, K> restrict_to(const Forms<NT, N>& f, const std::array<int, K>& vertices) {
  Forms<NT, K> r;
  for (int n = 0; n < kPairs<K>; ++n) {
    const auto [i, j] = pairs<K>()[n];
    r.p[n] = f.P(vertices[i], vertices[j]);
  }
  for (int n = 0; n < kTriples<K>; ++n) {
    const auto [i, j, k] = triples<K>()[n];
    r.q[n] = f.Q(vertices[i], vertices[j], vertices[k]);
  }
  return r;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/quadric/quadric_form.hpp"

namespace triplex {

namespace detail {

/// The determinant of the rows and columns chosen, at most three of each.
template <class NT, int N, std::size_t K>
NT minor_of(const QuadraticForm<NT, N>& f, const std::array<int, K>& rows,
            const std::array<int, K>& columns) {
  const auto two = [&](int i, int j, int k, int l) {
    return f(i, k) * f(j, l) - f(i, l) * f(j, k);
  };
  if constexpr (K == 2) {
    return two(rows[0], rows[1], columns[0], columns[1]);
  } else {
    static_assert(K == 3);
    return f(rows[0], columns[0]) * two(rows[1], rows[2], columns[1], columns[2]) -
           f(rows[0], columns[1]) * two(rows[1], rows[2], columns[0], columns[2]) +
           f(rows[0], columns[2]) * two(rows[1], rows[2], columns[0], columns[1]);
  }
}

template <int N>
constexpr std::array<int, N - 1> all_but(int i) {
  std::array<int, N - 1> r{};
  for (int n = 0, k = 0; n < N; ++n)
    if (n != i) r[k++] = n;
  return r;
}

}  // namespace detail

/// The adjugate of the matrix of a form: F adj(F) = det(F) I.
template <class NT, int N>
QuadraticForm<NT, N> adjugate(const QuadraticForm<NT, N>& f) {
  QuadraticForm<NT, N> r;
  for (int i = 0; i < N; ++i)
    for (int j = i; j < N; ++j) {
      const NT m = detail::minor_of(f, detail::all_but<N>(i), detail::all_but<N>(j));
      r(i, j) = (i + j) % 2 == 0 ? m : -m;
    }
  return r;
}

/// det(F), from its adjugate.
template <class NT, int N>
NT determinant(const QuadraticForm<NT, N>& f, const QuadraticForm<NT, N>& adjugate_of_f) {
  NT sum = f(0, 0) * adjugate_of_f(0, 0);
  for (int j = 1; j < N; ++j) sum = sum + f(0, j) * adjugate_of_f(0, j);
  return sum;
}

/// The pole of the plane at infinity, adj(F) (1, ..., 1): a multiple of the centre, if there is
/// one.
template <class NT, int N>
std::array<NT, N> center(const QuadraticForm<NT, N>& adjugate_of_f) {
  std::array<NT, N> c;
  for (int i = 0; i < N; ++i) {
    c[i] = adjugate_of_f(i, 0);
    for (int j = 1; j < N; ++j) c[i] = c[i] + adjugate_of_f(i, j);
  }
  return c;
}

/// How the zero set of a form lies in a simplex beside its boundary. Each answer is exact.
struct InnerPoints {
  /// The form has rank N - 1, and its only singular point lies in the closed simplex.
  bool singular = false;
  /// The centre lies strictly inside, with this sign of the form there; else Zero.
  Sign at_center = Sign::Zero;
};

/// Empty if enclosures cannot tell. Source: proofs/quadric_patches.md.
template <class NT, int N>
std::optional<InnerPoints> inner_points(const QuadraticForm<NT, N>& f) {
  const QuadraticForm<NT, N> adjugate_of_f = adjugate(f);
  const auto det = known_sign(determinant(f, adjugate_of_f));
  if (!det) return std::nullopt;
  InnerPoints inner;
  // 1: all coordinates positive, -1: all negative, 0: neither; strictly or not.
  const auto common_sign = [](const std::array<NT, N>& x, bool strictly) -> std::optional<int> {
    bool positive = true, negative = true, known = true;
    for (const NT& xi : x) {
      const auto s = known_sign(xi);
      if (!s) {
        known = false;
        continue;
      }
      positive = positive && (*s == Sign::Positive || (*s == Sign::Zero && !strictly));
      negative = negative && (*s == Sign::Negative || (*s == Sign::Zero && !strictly));
    }
    if (!positive && !negative) return 0;
    if (!known) return std::nullopt;
    return positive ? 1 : -1;
  };
  if (*det == Sign::Zero) {  // only exact forms come here, or plain zeros
    for (int k = 0; k < N; ++k) {
      std::array<NT, N> column;
      bool any = false;
      for (int i = 0; i < N; ++i) {
        column[i] = adjugate_of_f(i, k);
        any = any || known_sign(column[i]) != Sign::Zero;
      }
      if (!any) continue;
      const auto s = common_sign(column, false);
      if (!s) return std::nullopt;
      inner.singular = *s != 0;
      break;
    }
    return inner;
  }
  const auto s = common_sign(center(adjugate_of_f), true);
  if (!s) return std::nullopt;
  // F(c) = det(F) (1^T adj(F) 1), and 1^T adj(F) 1 is the sum of the coordinates of c.
  inner.at_center = *s == 0 ? Sign::Zero : *s > 0 ? *det : -*det;
  return inner;
}

}  // namespace triplex

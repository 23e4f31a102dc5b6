// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

// The degenerate tensors with axis n are the multiples of N(n) = |n|^2 I - 3 n n^T. In a linear
// field of symmetric tensors the place is a quadratic form in n, and n lies on conics: all that the
// certificates of degenerate curves rest on (proofs/symmetric_curve.md). Everything here is over
// any ring NT.

/// A symmetric tensor without trace: xx, yy, xy, xz, yz.
template <class NT>
using Components = std::array<NT, 5>;
template <class NT>
using Direction = std::array<NT, 3>;

template <class NT>
Components<NT> components_of(const Tensor<NT>& a) {
  return {a[0], a[4], a[1], a[2], a[5]};
}

template <class NT>
NT dot(const Direction<NT>& a, const Direction<NT>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class NT>
NT determinant(const Direction<NT>& a, const Direction<NT>& b, const Direction<NT>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// A quadratic form in n: the rows of its symmetric matrix.
template <class NT>
struct Conic {
  std::array<Direction<NT>, 3> rows;

  Direction<NT> times(const Direction<NT>& n) const {
    return {dot(rows[0], n), dot(rows[1], n), dot(rows[2], n)};
  }
  NT polar(const Direction<NT>& a, const Direction<NT>& b) const { return dot(a, times(b)); }
  NT at(const Direction<NT>& n) const { return polar(n, n); }
  NT determinant() const { return triplex::determinant(rows[0], rows[1], rows[2]); }
};

/// a P + b Q.
template <class NT>
Conic<NT> combination(const NT& a, const Conic<NT>& p, const NT& b, const Conic<NT>& q) {
  Conic<NT> r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r.rows[i][j] = a * p.rows[i][j] + b * q.rows[i][j];
  return r;
}

/// Twice the form c . N(n).
template <class NT>
Conic<NT> conic_of(const Components<NT>& c) {
  const NT two(2), three(3);
  const NT xy = NT(0) - three * c[2], xz = NT(0) - three * c[3], yz = NT(0) - three * c[4];
  return {{{{two * (c[1] - two * c[0]), xy, xz},
            {xy, two * (c[0] - two * c[1]), yz},
            {xz, yz, two * (c[0] + c[1])}}}};
}

/// The columns of M by which relations between the others are written.
template <std::size_t N>
using Columns = std::array<std::size_t, N>;

/// The determinant of these columns of three rows.
template <class NT>
NT minor_of(const std::array<Components<NT>, 3>& m, const Columns<3>& j) {
  const auto row = [&](std::size_t i) -> Direction<NT> {
    return {m[i][j[0]], m[i][j[1]], m[i][j[2]]};
  };
  return determinant(row(0), row(1), row(2));
}

/// What is left of an array without its entry k.
template <class T, std::size_t N>
std::array<T, N - 1> without(const std::array<T, N>& all, std::size_t k) {
  std::array<T, N - 1> r;
  for (std::size_t i = 0; i + 1 < N; ++i) r[i] = all[i < k ? i : i + 1];
  return r;
}

/// The determinant of these columns of four rows, and the cofactors of its entries.
template <class NT>
NT cofactor_of(const std::array<Components<NT>, 4>& m, const Columns<4>& j, std::size_t row,
               std::size_t column) {
  const NT d = minor_of(without(m, row), without(j, column));
  return (row + column) % 2 == 0 ? d : NT(0) - d;
}
template <class NT>
NT minor_of(const std::array<Components<NT>, 4>& m, const Columns<4>& j) {
  NT d(0);
  for (std::size_t k = 0; k < 4; ++k) d = d + m[0][j[k]] * cofactor_of(m, j, 0, k);
  return d;
}
template <class NT>
NT cofactor_of(const std::array<Components<NT>, 3>& m, const Columns<3>& j, std::size_t row,
               std::size_t column) {
  const auto at = [&](std::size_t a, std::size_t b) -> const NT& {
    return m[(row + a) % 3][j[(column + b) % 3]];
  };
  return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
}

/// The relation c . A = 0 of all rows A that has c_k = det of the columns and no other column.
template <class NT, std::size_t N>
Components<NT> relation(const std::array<Components<NT>, N>& m, const Columns<N>& j, const NT& det,
                        std::size_t k) {
  Components<NT> c;
  c.fill(NT(0));
  c[k] = det;
  for (std::size_t n = 0; n < N; ++n) {
    Columns<N> replaced = j;
    replaced[n] = k;
    c[j[n]] = NT(0) - minor_of(m, replaced);
  }
  return c;
}

/// The forms g_i with sum over i of g_i A_i = 2 det N wherever the conics of all relations vanish.
template <class NT, std::size_t N>
std::array<Conic<NT>, N> place_forms(const std::array<Components<NT>, N>& m, const Columns<N>& j) {
  std::array<Conic<NT>, N> g;
  for (std::size_t i = 0; i < N; ++i) {
    Components<NT> c;
    c.fill(NT(0));
    for (std::size_t n = 0; n < N; ++n) c[j[n]] = cofactor_of(m, j, i, n);
    g[i] = conic_of(c);
  }
  return g;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "block_algebra.hpp"

#include <algorithm>
#include <cmath>

namespace triplex {

bool is_interval(const Interval& x) { return x.inf() <= x.sup(); }
bool contains_zero(const Interval& x) { return !(x.inf() > 0 || x.sup() < 0) || !is_interval(x); }
double magnitude(const Interval& x) {
  return is_interval(x) ? std::max(-x.inf(), x.sup()) : INFINITY;
}
Interval square(const Interval& x) {
  const double m = magnitude(x);
  if (contains_zero(x)) return Interval(0, (Interval(m) * Interval(m)).sup());
  return x * x;
}
int sign_of(const Interval& x) { return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0; }

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.inf(), b.inf()), std::max(a.sup(), b.sup())};
}

std::optional<Block> inverse(const Block& m) {
  const Interval determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  if (contains_zero(determinant)) return {};
  const Interval r = Interval(1) / determinant;
  return Block{Pair{m[1][1] * r, -m[0][1] * r}, Pair{-m[1][0] * r, m[0][0] * r}};
}
Interval dot(const Pair& a, const Pair& b) { return a[0] * b[0] + a[1] * b[1]; }
Pair row_times(const Pair& row, const Block& m) {
  return {row[0] * m[0][0] + row[1] * m[1][0], row[0] * m[0][1] + row[1] * m[1][1]};
}
namespace {
Pair times_column(const Block& m, const Pair& column) {
  return {dot(m[0], column), dot(m[1], column)};
}
}  // namespace

Split split(const Tensor<Interval>& t) {
  return {{Pair{t[0], t[1]}, Pair{t[3], t[4]}}, {t[2], t[5]}, {t[6], t[7]}, t[8]};
}

/// By cofactors.
std::optional<Tensor<Interval>> inverse(const SplittingBasis& s) {
  const auto minor = [&](int i, int j, int k, int l) {
    return Interval(s(i, k)) * Interval(s(j, l)) - Interval(s(i, l)) * Interval(s(j, k));
  };
  Tensor<Interval> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)  // adj_ij, the cofactor of s_ji
      r[3 * i + j] = minor((j + 1) % 3, (j + 2) % 3, (i + 1) % 3, (i + 2) % 3);
  Interval determinant(0);
  for (int j = 0; j < 3; ++j) determinant += Interval(s(0, j)) * r[3 * j];
  if (contains_zero(determinant)) return {};
  for (Interval& x : r) x = x / determinant;
  return r;
}

Tensor<Interval> in_basis(const Tensor<Interval>& t, const SplittingBasis& basis,
                          const Tensor<Interval>& inverse_basis) {
  Tensor<Interval> half, r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      half[3 * i + j] = Interval(0);
      for (int k = 0; k < 3; ++k) half[3 * i + j] += t[3 * i + k] * Interval(basis(k, j));
    }
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      r[3 * i + j] = Interval(0);
      for (int k = 0; k < 3; ++k) r[3 * i + j] += inverse_basis[3 * i + k] * half[3 * k + j];
    }
  return r;
}

namespace {

/// A box that F(z) = (a - (z . b) z) K maps into itself, K acting from either side; it then holds a
/// fixed point (Brouwer). Starts from the image of zero and grows.
template <class Apply>
std::optional<Pair> invariant_box(const Pair& a, const Pair& b, const Apply& apply) {
  constexpr int kSteps = 8;  // a quality limit only
  constexpr double kGrowth = 1.25, kTiny = 0x1p-1000;
  const Pair first = apply(a);
  std::array<double, 2> bound = {kGrowth * magnitude(first[0]) + kTiny,
                                 kGrowth * magnitude(first[1]) + kTiny};
  for (int step = 0; step < kSteps; ++step) {
    const Pair z = {Interval(-bound[0], bound[0]), Interval(-bound[1], bound[1])};
    const Interval zb = dot(z, b);
    const Pair image = apply({a[0] - zb * z[0], a[1] - zb * z[1]});
    const std::array<double, 2> m = {magnitude(image[0]), magnitude(image[1])};
    if (m[0] <= bound[0] && m[1] <= bound[1]) return image;
    if (!(m[0] < INFINITY && m[1] < INFINITY)) return {};
    for (std::size_t k = 0; k < 2; ++k) bound[k] = std::max(bound[k], kGrowth * m[k]);
  }
  return {};
}

}  // namespace

Split enclosure_in(std::span<const Tensor<Interval>> tensors, const SplittingBasis& basis,
                   const Tensor<Interval>& inverse_basis) {
  Tensor<Interval> enclosure = in_basis(tensors[0], basis, inverse_basis);
  for (const Tensor<Interval>& t : tensors.subspan(1)) {
    const Tensor<Interval> other = in_basis(t, basis, inverse_basis);
    for (std::size_t k = 0; k < 9; ++k) enclosure[k] = hull(enclosure[k], other[k]);
  }
  return split(enclosure);
}

std::optional<Block> inverse_of_shifted(const Block& m, const Interval& shift) {
  Block shifted = m;
  for (std::size_t k = 0; k < 2; ++k) shifted[k][k] -= shift;
  return inverse(shifted);
}

std::optional<Pair> invariant_plane(const Split& a) {
  const auto k = inverse_of_shifted(a.block, a.corner);
  if (!k) return {};
  return invariant_box(a.row, a.column, [&](const Pair& z) { return row_times(z, *k); });
}
std::optional<Pair> invariant_line(const Split& a) {
  const auto k = inverse_of_shifted(a.block, a.corner);
  if (!k) return {};
  return invariant_box({-a.column[0], -a.column[1]}, {-a.row[0], -a.row[1]},
                       [&](const Pair& z) { return times_column(*k, z); });
}

Block restricted(const Split& a, const Pair& y) {
  Block m = a.block;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) m[i][j] += a.column[i] * y[j];
  return m;
}

Block restricted_rate(const Split& a, const Pair& y, const Split& derivative, const Block& apart) {
  // y' (M + b y - (d - y b)) = c' + d' y - y M' - (y b') y, and (M + b y)' = M' + b' y + b y'.
  const Pair ym = row_times(y, derivative.block);
  const Interval yd = dot(y, derivative.column);
  Pair rate;
  for (std::size_t j = 0; j < 2; ++j)
    rate[j] = derivative.row[j] + derivative.corner * y[j] - ym[j] - yd * y[j];
  rate = row_times(rate, apart);
  Block growth;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      growth[i][j] = derivative.block[i][j] + derivative.column[i] * y[j] + a.column[i] * rate[j];
  return growth;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "block.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace triplex {
namespace {

using Pair = std::array<Interval, 2>;
using Block = std::array<Pair, 2>;

// What overflowed and is no interval any more (infinity minus infinity, zero times infinity) counts
// as all numbers.
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
Pair times_column(const Block& m, const Pair& column) {
  return {dot(m[0], column), dot(m[1], column)};
}

/// A 3 x 3 matrix as [[block, column], [row, corner]].
struct Split {
  Block block;
  Pair column, row;
  Interval corner;
};
Split split(const Tensor<Interval>& t) {
  return {{Pair{t[0], t[1]}, Pair{t[3], t[4]}}, {t[2], t[5]}, {t[6], t[7]}, t[8]};
}

/// Enclosure of the inverse of a basis, by cofactors.
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

/// The hull of tensors, in a basis.
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

/// The plane {(z, y z)} that a tensor maps into itself: y (M - d) = c - (y b) y.
std::optional<Pair> invariant_plane(const Split& a) {
  const auto k = inverse_of_shifted(a.block, a.corner);
  if (!k) return {};
  return invariant_box(a.row, a.column, [&](const Pair& z) { return row_times(z, *k); });
}
/// The line through (r, 1) that it maps into itself: (M - d) r = r (c r) - b.
std::optional<Pair> invariant_line(const Split& a) {
  const auto k = inverse_of_shifted(a.block, a.corner);
  if (!k) return {};
  return invariant_box({-a.column[0], -a.column[1]}, {-a.row[0], -a.row[1]},
                       [&](const Pair& z) { return times_column(*k, z); });
}

/// The tensor restricted to the plane, in the coordinates z: M + b y.
Block restricted(const Split& a, const Pair& y) {
  Block m = a.block;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) m[i][j] += a.column[i] * y[j];
  return m;
}

}  // namespace

std::optional<SplittingBasis> splitting_basis_approx(const Eigen::Matrix3d& tensor) {
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(tensor);
  if (solver.info() != Eigen::Success) return {};
  const auto& l = solver.eigenvalues();
  int third = -1;
  double best = 0;
  for (int i = 0; i < 3; ++i) {
    if (l[i].imag() != 0) continue;
    const auto a = l[(i + 1) % 3], b = l[(i + 2) % 3];
    const double apart = std::min(std::abs(l[i] - a), std::abs(l[i] - b));
    const double relative = apart / (apart + std::abs(a - b));
    if (relative > best) best = relative, third = i;
  }
  if (third < 0) return {};
  // The left eigenvector is what is orthogonal to the columns of A - l I: a cross product of two.
  const Eigen::Matrix3d b = tensor - l[third].real() * Eigen::Matrix3d::Identity();
  Eigen::Vector3d left = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d n = b.col(i).cross(b.col((i + 1) % 3));
    if (n.squaredNorm() > left.squaredNorm()) left = n;
  }
  if (!(left.squaredNorm() > 0)) return {};
  left.normalize();
  SplittingBasis s;
  s.col(0) = left.unitOrthogonal();
  s.col(1) = left.cross(s.col(0));
  s.col(2) = solver.eigenvectors().col(third).real().normalized();
  return s;
}

Eigen::Vector3d traceless_part(const Eigen::Matrix2d& m) {
  return {(m(0, 0) - m(1, 1)) / 2, (m(0, 1) + m(1, 0)) / 2, (m(0, 1) - m(1, 0)) / 2};
}

std::optional<Eigen::Matrix2d> rotation_basis_approx(const Eigen::Vector3d& t) {
  const double w2 = t[2] * t[2] - t[0] * t[0] - t[1] * t[1];
  if (!(w2 > 0)) return {};
  // Columns (x, B x / w): B^2 = -w^2 I swaps them up to sign.
  Eigen::Matrix2d b, basis;
  b << t[0], t[1] + t[2], t[1] - t[2], -t[0];
  const Eigen::Vector2d x(1, 0);
  basis.col(0) = x;
  basis.col(1) = b * x / std::sqrt(w2);
  const double scale = std::sqrt(std::fabs(basis.determinant()));
  if (!(scale > 0)) return {};
  return Eigen::Matrix2d(basis / scale);
}

bool compression_is_timelike(std::span<const Tensor<Interval>> tensors,
                             const Tensor<Interval>& derivative, const SplittingBasis& basis) {
  const auto inverse_basis = inverse(basis);
  if (!inverse_basis) return false;
  const Split a = enclosure_in(tensors, basis, *inverse_basis);
  const auto y = invariant_plane(a), r = invariant_line(a);
  if (!y || !r) return false;

  // The line is not in the plane, and its eigenvalue is none of the plane's.
  Block complement;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      complement[i][j] = Interval(i == j ? 1 : 0) - (*r)[i] * (*y)[j];
  const auto normal = inverse(complement);
  const Interval third = a.corner + dot(a.row, *r);
  if (!normal || !inverse_of_shifted(restricted(a, *y), third) || magnitude(dot(*y, *r)) >= 1)
    return false;

  // Compressed: (I - r y)^-1 (M' + b' y - r (c' + d' y)), and its discriminant.
  const Split d = split(in_basis(derivative, basis, *inverse_basis));
  Block p;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      p[i][j] = d.block[i][j] + d.column[i] * (*y)[j] - (*r)[i] * (d.row[j] + d.corner * (*y)[j]);
  const Pair first = row_times((*normal)[0], p), second = row_times((*normal)[1], p);
  const Interval discriminant = square(first[0] - second[1]) + Interval(4) * first[1] * second[0];
  return is_interval(discriminant) && discriminant.sup() < 0;
}

std::optional<SplittingBasis> block_basis_approx(const Eigen::Matrix3d& tensor, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  Eigen::Matrix2d m;
  m << tensor(i, i), tensor(i, j), tensor(j, i), tensor(j, j);
  const Eigen::EigenSolver<Eigen::Matrix2d> solver(m);
  if (solver.info() != Eigen::Success || solver.eigenvalues()[0].imag() != 0) return {};
  const Eigen::Vector2d l = solver.eigenvalues().real();
  const int near =
      std::fabs(l[0] - tensor(axis, axis)) < std::fabs(l[1] - tensor(axis, axis)) ? 0 : 1;
  SplittingBasis s = SplittingBasis::Zero();
  const Eigen::Matrix2d vectors = solver.eigenvectors().real();
  s(i, 0) = vectors(0, near), s(j, 0) = vectors(1, near);
  s(axis, 1) = 1;
  s(i, 2) = vectors(0, 1 - near), s(j, 2) = vectors(1, 1 - near);
  return s;
}

bool couplings_agree(std::span<const Tensor<Interval>> tensors,
                     std::span<const Tensor<Interval>> derivatives, const SplittingBasis& basis,
                     const ZeroCouplings& zero) {
  const auto inverse_basis = inverse(basis);
  if (!inverse_basis) return false;
  const Split a = enclosure_in(tensors, basis, *inverse_basis);
  const auto y = invariant_plane(a);
  if (!y) return false;
  const Block effective = restricted(a, *y);
  const auto apart = inverse_of_shifted(effective, a.corner - dot(*y, a.column));
  if (!apart) return false;
  int sign = 0;
  const auto agrees = [&](const Interval& x) {
    const int s = x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0;
    if (s == 0 || (sign != 0 && s != sign)) return false;
    sign = s;
    return true;
  };
  if (!zero.upper && !agrees(effective[0][1])) return false;
  if (!zero.lower && !agrees(effective[1][0])) return false;
  return std::ranges::all_of(derivatives, [&](const Tensor<Interval>& derivative) {
    // y' (M + b y - (d - y b)) = c' + d' y - y M' - (y b') y, and (M + b y)' = M' + b' y + b y'.
    const Split d = split(in_basis(derivative, basis, *inverse_basis));
    const Pair ym = row_times(*y, d.block);
    const Interval yd = dot(*y, d.column);
    Pair rate;
    for (std::size_t j = 0; j < 2; ++j)
      rate[j] = d.row[j] + d.corner * (*y)[j] - ym[j] - yd * (*y)[j];
    rate = row_times(rate, *apart);
    const auto growth = [&](std::size_t i, std::size_t j) {
      return d.block[i][j] + d.column[i] * (*y)[j] + a.column[i] * rate[j];
    };
    return (!zero.upper || agrees(growth(0, 1))) && (!zero.lower || agrees(growth(1, 0)));
  });
}

}  // namespace triplex

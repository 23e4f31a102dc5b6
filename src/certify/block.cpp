// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "block.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "block_algebra.hpp"

namespace triplex {

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
    const int s = sign_of(x);
    if (s == 0 || (sign != 0 && s != sign)) return false;
    sign = s;
    return true;
  };
  if (!zero.upper && !agrees(effective[0][1])) return false;
  if (!zero.lower && !agrees(effective[1][0])) return false;
  return std::ranges::all_of(derivatives, [&](const Tensor<Interval>& derivative) {
    const Block growth =
        restricted_rate(a, *y, split(in_basis(derivative, basis, *inverse_basis)), *apart);
    return (!zero.upper || agrees(growth[0][1])) && (!zero.lower || agrees(growth[1][0]));
  });
}

}  // namespace triplex

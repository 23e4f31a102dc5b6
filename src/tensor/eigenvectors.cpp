// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenvectors.hpp"

#include <Eigen/Eigenvalues>

#include "exact_kernel.hpp"
#include "linear_algebra.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

bool is_symmetric(const Tensor<double>& t) { return t[1] == t[3] && t[2] == t[6] && t[5] == t[7]; }

Eigenvectors on_spine(const Tensor<Exact>& a) {
  const ExactKernel kernel = exact_kernel(a);
  const int n = kernel.dimension;
  if (n == 1) return {true, {kernel.first, kernel.first, kernel.first}, {n, n, n}};
  if (n == 3) return {true, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {n, n, n}};
  const Direction x = with_fixed_sign(exact_kernel(transpose(a)).normal);
  const Direction other = with_fixed_sign(normalized(cross(x, kernel.normal)));
  return {true, {x, other, other}, {n, n, n}};
}

// D = 0, p < 0: the dominant eigenvector is the major one where q > 0, else the minor one.
Eigenvectors on_degenerate_surface(const DegeneratePencil& pencil, Sign sign_q) {
  const ExactKernel repeating = exact_kernel(pencil.repeating);
  const Direction dominant = exact_kernel(pencil.dominant).first;
  const int n = repeating.dimension;
  const Direction& one = repeating.first;
  const Direction& two = n == 1 ? repeating.first : repeating.second;
  if (sign_q == Sign::Positive) return {true, {dominant, one, two}, {1, n, n}};
  return {true, {one, two, dominant}, {n, n, 1}};
}

Eigenvectors of_symmetric(const Tensor<double>& a) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = a[i];
  const Eigen::Matrix3d v = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).eigenvectors();
  Eigenvectors e;
  e.dimensions = {1, 1, 1};
  for (int k = 0; k < 3; ++k) {  // there in ascending order
    e.vectors[k] = with_fixed_sign({v(0, 2 - k), v(1, 2 - k), v(2, 2 - k)});
  }
  return e;
}

}  // namespace

Eigenvectors eigenvectors(const Tensor<double>& t) {
  const Invariants i = invariants(t, kEigenvalueAccuracy);
  if (i.sign_discriminant == Sign::Zero) {
    const DegeneratePencil pencil = degenerate_pencil(t);
    return i.sign_p == Sign::Zero ? on_spine(pencil.repeating)
                                  : on_degenerate_surface(pencil, i.sign_q);
  }
  const UnitDeviator unit = unit_deviator(t);
  if (is_symmetric(t)) return of_symmetric(unit.a);
  const Eigenvalues values = deviator_eigenvalues(i, -unit.exponent);
  Eigenvectors e;
  e.all_real = values.all_real;
  for (int k = 0; k < 3; ++k) {
    const bool is_real = k == 0 || e.all_real;
    e.vectors[k] = is_real ? null_vector(shifted(unit.a, values.real[k])) : kNoDirection;
    e.dimensions[k] = is_real ? 1 : 0;
  }
  return e;
}

}  // namespace triplex

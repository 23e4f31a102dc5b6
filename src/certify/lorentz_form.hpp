// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <optional>

#include "block.hpp"

/// Guesses of directions along which the block of a nearly degenerate tensor changes in a timelike
/// or a spacelike way. Source: proofs/nappe.md.
namespace triplex {

inline Eigen::Matrix3d to_eigen(const Tensor<double>& t) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = t[static_cast<std::size_t>(i)];
  return m;
}

/// Weights of the differences A_k - A_0, k = 1 ... N-1: a direction in the affine hull.
template <int N>
using Direction = Eigen::Matrix<double, N - 1, 1>;

/// The Lorentzian form of the compressed derivatives at a tensor, and the basis that it refers to.
template <int N>
struct FormThere {
  SplittingBasis basis;
  std::array<Eigen::Vector3d, N - 1> derivatives;  // (u, v, w) of each difference
  Eigen::Matrix<double, N - 1, N - 1> form;

  /// The direction that is spacelike there, if any, and by the largest margin.
  std::optional<Direction<N>> spacelike() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N - 1, N - 1>> solver(form);
    if (!(solver.eigenvalues()[N - 2] > 0)) return {};
    return Direction<N>(solver.eigenvectors().col(N - 2));
  }
  /// The direction that is timelike there, if any, and by the largest margin.
  std::optional<Direction<N>> timelike() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N - 1, N - 1>> solver(form);
    if (!(solver.eigenvalues()[0] < 0)) return {};
    return Direction<N>(solver.eigenvectors().col(0));
  }
};

template <int N>
std::optional<FormThere<N>> form_at(const Eigen::Matrix3d& tensor,
                                    const std::array<Eigen::Matrix3d, N - 1>& differences) {
  const auto basis = splitting_basis_approx(tensor);
  if (!basis) return {};
  FormThere<N> there{*basis, {}, {}};
  const Eigen::Matrix3d inverse = basis->inverse();
  for (int k = 0; k < N - 1; ++k)
    there.derivatives[k] =
        traceless_part((inverse * differences[k] * *basis).template topLeftCorner<2, 2>());
  for (int k = 0; k < N - 1; ++k)
    for (int m = 0; m < N - 1; ++m) {
      const auto &a = there.derivatives[k], &b = there.derivatives[m];
      there.form(k, m) = a[0] * b[0] + a[1] * b[1] - a[2] * b[2];
    }
  return there;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "lorentz_form.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Where D is smallest in proportion: a tensor near the sheets. Downhill from
/// near each corner.
template <int N>
class NearlyDegenerate {
 public:
  using Weights = Eigen::Matrix<double, N, 1>;

  explicit NearlyDegenerate(const std::array<Eigen::Matrix3d, N>& a) : a_(a) {}

  Eigen::Matrix3d find() const {
    Point best;
    const Weights middle = Weights::Constant(1.0 / N);
    for (int i = 0; i < N; ++i) {
      const Weights x = (Weights::Unit(i) * 3 + middle) / 4;
      Point start{x, size_of_discriminant(x)};
      descend(start);
      if (start.value < best.value) best = start;
    }
    return tensor_at(best.x);
  }

 private:
  static constexpr int kSteps = 24;  // a limit of effort only
  struct Point {
    Weights x = Weights::Constant(1.0 / N);
    double value = INFINITY;
  };

  Eigen::Matrix3d tensor_at(const Weights& x) const {
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (int i = 0; i < N; ++i) m += x[i] * a_[i];
    return m;
  }
  double size_of_discriminant(const Weights& x) const {
    const Eigen::Matrix3d m = tensor_at(x);
    const double p = -(m * m).trace() / 2, q = m.determinant(), norm = m.squaredNorm();
    return std::fabs(4 * p * p * p + 27 * q * q) / (norm * norm * norm);
  }
  void descend(Point& point) const {
    double step = 0.25;
    for (int n = 0; n < kSteps; ++n) {
      Point next = point;
      for (int a = 0; a < N; ++a)
        for (int b = 0; b < N; ++b) {
          Weights x = point.x;
          const double shift = std::min(step, x[b]);
          x[a] += shift, x[b] -= shift;
          if (const double value = size_of_discriminant(x); value < next.value) next = {x, value};
        }
      if (!(next.value < point.value)) step /= 2;
      point = next;
    }
  }

  const std::array<Eigen::Matrix3d, N>& a_;
};

/// A basis in which the block changes along a spacelike direction like a diagonal one.
struct SpacelikeGuess {
  SplittingBasis basis;
  Eigen::VectorXd direction;
};
template <int N>
std::optional<SpacelikeGuess> spacelike_guess(const Simplex<N>& simplex) {
  std::array<Eigen::Matrix3d, N> a;
  for (int i = 0; i < N; ++i) a[i] = to_eigen(simplex.field().approximate(simplex.vertices()[i]).a);
  std::array<Eigen::Matrix3d, N - 1> differences;
  for (int k = 1; k < N; ++k) differences[k - 1] = a[k] - a[0];
  const std::optional<FormThere<N>> there = form_at<N>(NearlyDegenerate<N>(a).find(), differences);
  if (!there) return {};
  const std::optional<Direction<N>> direction = there->spacelike();
  if (!direction) return {};
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  for (int k = 0; k < N - 1; ++k) change += (*direction)[k] * there->derivatives[k];
  Eigen::Matrix2d c;
  c << change[0], change[1] + change[2], change[1] - change[2], -change[0];
  const Eigen::EigenSolver<Eigen::Matrix2d> solver(c);
  if (solver.info() != Eigen::Success || solver.eigenvalues()[0].imag() != 0) return {};
  Eigen::Matrix2d vectors = solver.eigenvectors().real();
  if (solver.eigenvalues()[0].real() < solver.eigenvalues()[1].real())
    vectors.col(0).swap(vectors.col(1));
  SpacelikeGuess guess{there->basis, *direction};
  const SplittingBasis& basis = there->basis;
  guess.basis.leftCols<2>() = (basis.leftCols<2>() * vectors).eval();
  return guess;
}

}  // namespace triplex

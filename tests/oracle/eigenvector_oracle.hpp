// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "random_tensors.hpp"
#include "rational_oracle.hpp"
#include "triplex/tensor/eigenvalues.hpp"

/// Exact residuals of eigenvectors and Schur forms, exact ranks, and conversions to Eigen.
namespace triplex::oracle {

using Vector3 = std::array<double, 3>;

inline Eigen::Matrix3d matrix(const Tensor<double>& t) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = t[i];
  return m;
}

inline Eigen::Vector3d vector(const Vector3& v) { return {v[0], v[1], v[2]}; }

inline Tensor<mpq_class> rational_deviator(const Tensor<double>& t) {
  Tensor<mpq_class> a = rational(t);
  const mpq_class mean = (a[0] + a[4] + a[8]) / 3;
  for (const int i : {0, 4, 8}) a[i] -= mean;
  return a;
}

template <class Values>
mpq_class sum_of_squares(const Values& values) {
  mpq_class sum = 0;
  for (const auto& x : values) sum += mpq_class(x) * mpq_class(x);
  return sum;
}

/// x 2^exponent.
inline mpq_class times_power(double x, int exponent) {
  mpq_class r(x);
  if (exponent > 0) mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  if (exponent < 0) mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return r;
}

/// The eigenvalues of the deviator, exact as far as they are known, at any scale: none of them
/// meets the denormals.
inline std::array<mpq_class, 3> real_eigenvalues(const Tensor<double>& t) {
  const Invariants i = invariants(t, kEigenvalueAccuracy);
  const int shift = -(i.sign_p != Sign::Zero ? i.p.exponent / 2 : i.q.exponent / 3);
  const Eigenvalues e = deviator_eigenvalues(i, shift);
  return {times_power(e.real[0], -shift), times_power(e.real[1], -shift),
          times_power(e.real[2], -shift)};
}

/// |A v - l v| / |A|, squared and exact. \pre A is not 0.
inline double relative_residual(const Tensor<mpq_class>& a, const Vector3& v, const mpq_class& l) {
  std::array<mpq_class, 3> r;
  for (int i = 0; i < 3; ++i) {
    r[i] = a[3 * i] * v[0] + a[3 * i + 1] * v[1] + a[3 * i + 2] * v[2] - l * v[i];
  }
  const mpq_class ratio = sum_of_squares(r) / sum_of_squares(a);
  return std::sqrt(ratio.get_d());
}

/// |Q S Q^T - A| / |A|, exact up to the final root. \pre A is not 0.
inline double schur_residual(const Tensor<mpq_class>& a, const Tensor<double>& q,
                             const Tensor<mpq_class>& s) {
  Tensor<mpq_class> r;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      r[3 * i + j] = -a[3 * i + j];
      for (int k = 0; k < 3; ++k) {
        for (int l = 0; l < 3; ++l) {
          r[3 * i + j] += mpq_class(q[3 * i + k]) * s[3 * k + l] * mpq_class(q[3 * j + l]);
        }
      }
    }
  }
  const mpq_class ratio = sum_of_squares(r) / sum_of_squares(a);
  return std::sqrt(ratio.get_d());
}

/// By elimination over the rationals.
inline int rank(Tensor<mpq_class> m) {
  int r = 0;
  for (int column = 0; column < 3 && r < 3; ++column) {
    int row = r;
    while (row < 3 && m[3 * row + column] == 0) ++row;
    if (row == 3) continue;
    for (int j = 0; j < 3; ++j) std::swap(m[3 * r + j], m[3 * row + j]);
    for (int i = r + 1; i < 3; ++i) {
      const mpq_class factor = m[3 * i + column] / m[3 * r + column];
      for (int j = 0; j < 3; ++j) m[3 * i + j] -= factor * m[3 * r + j];
    }
    ++r;
  }
  return r;
}

/// The dimension of the repeating eigenvalue's eigenspace, 0 if none repeats, from the definition.
inline int repeating_dimension(const Tensor<double>& t) {
  const RationalInvariants i = rational_invariants(t);
  if (i.d != 0) return 0;
  Tensor<mpq_class> a = rational_deviator(t);
  const mpq_class l = i.p == 0 ? mpq_class(0) : mpq_class(3 * i.q / (2 * i.p));
  for (const int k : {0, 4, 8}) a[k] -= l;
  return 3 - rank(a);
}

/// The sine of the angle between two lines.
inline double sine(const Vector3& a, const Vector3& b) {
  return vector(a).normalized().cross(vector(b).normalized()).norm();
}

/// The middle singular value of A - l I: by it the error of an eigenvector is divided.
inline double separation(const Tensor<double>& t, double l) {
  const Eigen::Matrix3d m = matrix(t) - l * Eigen::Matrix3d::Identity();
  return Eigen::JacobiSVD<Eigen::Matrix3d>(m).singularValues()[1];
}

/// A uniformly random rotation, row-major.
inline Tensor<double> random_rotation(Random& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  const Eigen::Matrix3d r = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  Tensor<double> t;
  for (int i = 0; i < 9; ++i) t[i] = r(i / 3, i % 3);
  return t;
}

/// R T R^T.
inline Tensor<double> rotated(const Tensor<double>& r, const Tensor<double>& t) {
  return product(product(r, t), transposed(r));
}

inline Vector3 rotated(const Tensor<double>& r, const Vector3& v) {
  Vector3 w;
  for (int i = 0; i < 3; ++i) w[i] = r[3 * i] * v[0] + r[3 * i + 1] * v[1] + r[3 * i + 2] * v[2];
  return w;
}

/// A generic tensor, an exactly degenerate one, one close to a stratum, or a strongly non-normal
/// one; entries of size one.
inline Tensor<double> tensor_of_any_kind(Random& random, int n) {
  Tensor<double> t = n % 3 == 0   ? double_tensor(random)
                     : n % 3 == 1 ? degenerate_tensor(random)
                                  : integer_tensor(random, 3);
  if (n % 5 == 0) {
    for (double& x : t) x += std::ldexp(integer(random, 1), -20 - n % 32);
  }
  if (n % 7 == 0) {
    t[1] *= 1e6;
    t[3] *= 1e-6;
  }
  return t;
}

}  // namespace triplex::oracle

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/dual_eigenvectors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "../oracle/eigenvector_oracle.hpp"
#include "triplex/tensor/eigenvectors.hpp"

namespace triplex {
namespace {

using oracle::Random;
using oracle::sine;

bool is_none(const Direction& v) {
  return std::isnan(v[0]) && std::isnan(v[1]) && std::isnan(v[2]);
}

void expect_nothing(const Tensor<double>& t) {
  const DualEigenvectors d = dual_eigenvectors(t);
  EXPECT_TRUE(is_none(d.long_axis));
  EXPECT_TRUE(is_none(d.short_axis));
  EXPECT_TRUE(std::isnan(d.axis_ratio));
  EXPECT_TRUE(std::isnan(d.eccentricity));
}

// Orbits in the invariant plane are the ellipses Re(exp(i s) z) with z a complex eigenvector: their
// axes are the singular vectors of [Re z, Im z].
TEST(DualEigenvectors, AreTheAxesOfTheOrbits) {
  Random random(1);
  int complex = 0;
  for (int n = 0; n < 6000; ++n) {
    Tensor<double> t = oracle::double_tensor(random);
    if (n % 3 == 0) t[3] -= 2;
    const DualEigenvectors d = dual_eigenvectors(t);
    if (oracle::rational_invariants(t).d >= 0) {
      expect_nothing(t);
      continue;
    }
    ++complex;
    const Eigen::EigenSolver<Eigen::Matrix3d> solver(oracle::matrix(t));
    int k = 0;
    for (const int j : {1, 2}) {
      if (solver.eigenvalues()[j].imag() > solver.eigenvalues()[k].imag()) k = j;
    }
    const Eigen::Vector3cd z = solver.eigenvectors().col(k);
    Eigen::Matrix<double, 3, 2> ellipse;
    ellipse << z.real(), z.imag();
    const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> svd(ellipse, Eigen::ComputeFullU);
    const double ratio = svd.singularValues()[1] / svd.singularValues()[0];
    const double im = solver.eigenvalues()[k].imag();
    const double tolerance = 1e-12 / (im * im * im);  // Eigen's eigenvector near the boundary
    ASSERT_NEAR(d.axis_ratio, ratio, tolerance);
    ASSERT_NEAR(d.eccentricity * d.eccentricity, 1 - ratio * ratio, tolerance);
    const Eigen::Vector3d u0 = svd.matrixU().col(0), u1 = svd.matrixU().col(1);
    ASSERT_LE(sine(d.long_axis, {u0[0], u0[1], u0[2]}), tolerance / (1 - ratio));
    ASSERT_LE(sine(d.short_axis, {u1[0], u1[1], u1[2]}), tolerance / (1 - ratio));
    ASSERT_NEAR(oracle::vector(d.long_axis).dot(oracle::vector(d.short_axis)), 0, 1e-15);
  }
  EXPECT_GT(complex, 2000);
}

// x' = y, y' = -e x has the ellipses e x^2 + y^2 = const. As e decreases the axis ratio sqrt(e)
// keeps its relative accuracy, and the long axis is that of the limit.
TEST(DualEigenvectors, ConvergeToTheRepeatingEigenvector) {
  Random random(2);
  for (int n = 0; n < 200; ++n) {
    const double a = n % 3 == 0 ? 0 : 1 + n % 4;
    const auto block = [&](double e) {
      return Tensor<double>{a, 1, 0.5, -e, a, -0.25, 0, 0, -2 * a + (n % 2)};
    };
    for (int k = 10; k <= 50; k += 10) {
      const double e = std::ldexp(1, -2 * k);
      const DualEigenvectors d = dual_eigenvectors(block(e));
      ASSERT_NEAR(d.axis_ratio / std::ldexp(1, -k), 1, 1e-9) << a << ' ' << k;
      ASSERT_NEAR(d.eccentricity, 1, 1e-6);
      ASSERT_LE(sine(d.long_axis, {1, 0, 0}), 1e-9);
      ASSERT_LE(sine(d.short_axis, {0, 1, 0}), 1e-9);
    }
    const DualEigenvectors limit = dual_eigenvectors(block(0));
    ASSERT_EQ(limit.axis_ratio, 0);
    ASSERT_EQ(limit.eccentricity, 1);
    ASSERT_LE(sine(limit.long_axis, {1, 0, 0}), 1e-15);
    ASSERT_LE(sine(limit.short_axis, {0, 1, 0}), 1e-15);
  }
}

TEST(DualEigenvectors, OnTheBoundary) {
  Random random(3);
  int defined = 0;
  for (int n = 0; n < 3000; ++n) {
    const Tensor<double> t = oracle::degenerate_tensor(random);
    if (oracle::rational_invariants(t).d != 0) continue;
    if (oracle::repeating_dimension(t) > 1) {
      expect_nothing(t);
      continue;
    }
    ++defined;
    const DualEigenvectors d = dual_eigenvectors(t);
    ASSERT_EQ(d.long_axis, eigenvectors(t).vectors[1]);
    ASSERT_EQ(d.eccentricity, 1);
    // In the plane: T maps the short axis into it. Its normal is a left eigenvector.
    const Eigen::Vector3d u = oracle::vector(d.long_axis), v = oracle::vector(d.short_axis);
    const Eigen::Vector3d w = oracle::matrix(t) * v;
    ASSERT_NEAR(u.cross(v).dot(w), 0, 1e-13 * oracle::matrix(t).norm());
    ASSERT_GT(std::fabs(u.dot(w)), 1e-9);
    ASSERT_NEAR(u.dot(v), 0, 1e-15);
  }
  EXPECT_GT(defined, 300);
}

TEST(DualEigenvectors, Circles) {
  const DualEigenvectors d = dual_eigenvectors({0, -1, 0, 1, 0, 0, 0, 0, 3});
  EXPECT_TRUE(is_none(d.long_axis));
  EXPECT_TRUE(is_none(d.short_axis));
  EXPECT_EQ(d.axis_ratio, 1);
  EXPECT_EQ(d.eccentricity, 0);
}

// 2^k T: the same bits. -T: the same ellipses, run backwards.
TEST(DualEigenvectors, Laws) {
  Random random(4);
  for (int n = 0; n < 2000; ++n) {
    Tensor<double> t = oracle::double_tensor(random);
    t[3] -= 3;
    t[1] += 1;
    const DualEigenvectors d = dual_eigenvectors(t);
    if (std::isnan(d.eccentricity)) continue;
    for (const int k : {-900, 900}) {
      const DualEigenvectors scaled = dual_eigenvectors(oracle::scaled(t, k));
      ASSERT_EQ(scaled.long_axis, d.long_axis);
      ASSERT_EQ(scaled.eccentricity, d.eccentricity);
    }
    const DualEigenvectors negated = dual_eigenvectors(oracle::negated(t));
    const double tolerance = 1e-9 / (d.eccentricity * d.eccentricity * d.axis_ratio);
    ASSERT_LE(sine(negated.long_axis, d.long_axis), tolerance);
    ASSERT_NEAR(negated.axis_ratio, d.axis_ratio, 1e-9);
    const Tensor<double> r = oracle::random_rotation(random);
    const DualEigenvectors turned = dual_eigenvectors(oracle::rotated(r, t));
    ASSERT_LE(sine(turned.long_axis, oracle::rotated(r, d.long_axis)), tolerance);
    ASSERT_LE(sine(turned.short_axis, oracle::rotated(r, d.short_axis)), tolerance);
  }
  // Among the denormals: an ellipse of axes 2 and 1 with 12 bits to spare.
  const Tensor<double> tiny = oracle::scaled({0, -4, 0, 1, 0, 0, 0, 0, 1}, -1070);
  EXPECT_NEAR(dual_eigenvectors(tiny).axis_ratio, 0.5, 1e-12);
  EXPECT_LT(sine(dual_eigenvectors(tiny).long_axis, {1, 0, 0}), 1e-12);
}

}  // namespace
}  // namespace triplex

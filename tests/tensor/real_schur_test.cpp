// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/real_schur.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>

#include "../oracle/eigenvector_oracle.hpp"
#include "triplex/tensor/direction.hpp"
#include "triplex/tensor/domain.hpp"

namespace triplex {
namespace {

using oracle::Random;
using Complex = std::complex<double>;

oracle::Vector3 column(const Tensor<double>& q, int j) { return {q[j], q[3 + j], q[6 + j]}; }

// The least distance of the third eigenvalue from the others over |A|, in doubles.
double relative_gap(const Tensor<double>& t, const oracle::RationalInvariants& exact) {
  const Eigenvalues l = deviator_eigenvalues(t);
  const double size = std::sqrt(oracle::sum_of_squares(oracle::rational_deviator(t)).get_d());
  double gap = 0;
  if (!l.all_real) {
    gap = std::abs(Complex(l.real[0]) - Complex(l.re, l.im));
  } else if (exact.q > 0) {
    gap = l.real[0] - l.real[1];
  } else if (exact.q < 0) {
    gap = l.real[1] - l.real[2];
  } else {
    gap = l.real[0];
  }
  return gap / size;
}

void expect_shape(const Tensor<double>& s, const Classification& c, const Eigenvalues& l) {
  EXPECT_EQ(s[6], 0);
  EXPECT_EQ(s[7], 0);
  if (!l.all_real) {
    EXPECT_EQ(s[1], -s[3]);
    EXPECT_GT(s[3], 0);
    EXPECT_GE(s[0], s[4]);
    EXPECT_LE((s[0] - s[4]) / 2, s[3]);
    EXPECT_EQ(s[8], l.real[0]);
    return;
  }
  EXPECT_EQ(s[3], 0);
  std::array<double, 3> diagonal = l.real;
  const bool linear =
      c == Classification{Stratum::Sector, 2} || c == Classification{Stratum::Page, 2};
  if (linear) diagonal = {l.real[1], l.real[2], l.real[0]};
  if (c == Classification{Stratum::Page, 3}) diagonal = {l.real[0], l.real[2], 0};
  EXPECT_EQ(s[0], diagonal[0]);
  EXPECT_EQ(s[4], diagonal[1]);
  EXPECT_EQ(s[8], diagonal[2]);
}

// The contract at size one; the residual in exact arithmetic.
void expect_contract(const Tensor<double>& t) {
  const oracle::RationalInvariants exact = oracle::rational_invariants(t);
  const RealSchur r = real_schur(t);
  const Eigen::Matrix3d q = oracle::matrix(r.rotation);
  ASSERT_LT((q.transpose() * q - Eigen::Matrix3d::Identity()).norm(), 2e-15);
  ASSERT_GT(q.determinant(), 0);
  expect_shape(r.deviator, classify(t), deviator_eigenvalues(t));
  ASSERT_EQ(with_fixed_sign(column(r.rotation, 0)), column(r.rotation, 0));
  const Tensor<mpq_class> a = oracle::rational_deviator(t);
  if (oracle::sum_of_squares(a) == 0) {
    ASSERT_EQ(r.rotation, (Tensor<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
    ASSERT_EQ(r.deviator, Tensor<double>{});
    return;
  }
  const double bound = exact.d == 0 ? 0x1p-48 : 0x1p-40 * (1 + 1 / relative_gap(t, exact));
  ASSERT_LE(oracle::schur_residual(a, r.rotation, oracle::rational(r.deviator)), bound);
}

TEST(RealSchur, ContractInExactArithmetic) {
  Random random(1);
  for (int n = 0; n < 6000; ++n) {
    ASSERT_NO_FATAL_FAILURE(expect_contract(oracle::tensor_of_any_kind(random, n))) << n;
    ASSERT_FALSE(HasFailure()) << n;
  }
}

// On the strata where eigenvalues repeat the form is that of the paper.
TEST(RealSchur, DegenerateForms) {
  Random random(2);
  int nodes = 0, rank_one = 0;
  for (int n = 0; n < 5000; ++n) {
    const oracle::Kind kinds[] = {oracle::Kind::Degenerate, oracle::Kind::Derogatory,
                                  oracle::Kind::Nilpotent, oracle::Kind::Isotropic};
    const Tensor<double> t = oracle::degenerate_tensor(random, kinds[n % 4]);
    const Tensor<double> s = real_schur(t).deviator;
    const int dimension = oracle::repeating_dimension(t);
    if (dimension == 0) continue;  // a = 0 in a kind's normal form changes it
    ASSERT_EQ(s[0], s[4]);
    const bool spine = s[8] == 0;
    if (spine) {
      ASSERT_EQ(s[0], 0);
    }
    nodes += static_cast<int>(dimension == 2 && !spine);
    rank_one += static_cast<int>(dimension == 2 && spine);
    if (dimension == 2 && spine) {
      ASSERT_NE(s[1], 0);
      ASSERT_EQ(s[2], 0);
      ASSERT_EQ(s[5], 0);
    } else if (dimension > 1) {
      ASSERT_EQ(s[1], 0);
    } else {
      ASSERT_NE(s[1], 0);
    }
  }
  EXPECT_GT(nodes, 100);
  EXPECT_GT(rank_one, 100);
}

// The third column is the left eigenvector of the third eigenvalue, normal to an invariant plane,
// and the norm of what is above the diagonal, or beside the complex block, does not depend on the
// algorithm.
TEST(RealSchur, AgreesWithEigen) {
  Random random(3);
  for (int n = 0; n < 5000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const RealSchur r = real_schur(t);
    const Eigen::Matrix3d m = oracle::matrix(t);
    const double last = r.form()[8];
    const Eigen::EigenSolver<Eigen::Matrix3d> left(m.transpose());
    int k = 0;
    for (const int j : {1, 2}) {
      if (std::abs(left.eigenvalues()[j] - last) < std::abs(left.eigenvalues()[k] - last)) k = j;
    }
    const Eigen::Vector3d v = left.eigenvectors().col(k).real();
    ASSERT_LE(oracle::sine(column(r.rotation, 2), {v[0], v[1], v[2]}),
              1e-12 / oracle::separation(oracle::transposed(t), last));
    const Eigen::RealSchur<Eigen::Matrix3d> schur(m);
    ASSERT_NEAR(oracle::matrix(r.form()).norm(), schur.matrixT().norm(), 1e-9);
    ASSERT_NEAR(r.form()[0] + r.form()[4] + r.form()[8], schur.matrixT().trace(), 1e-14);
    ASSERT_NEAR(r.form()[8] * (r.form()[0] * r.form()[4] - r.form()[1] * r.form()[3]),
                schur.matrixT().determinant(), 1e-12);
  }
}

TEST(RealSchur, Laws) {
  Random random(4);
  for (int n = 0; n < 2000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const RealSchur r = real_schur(t);
    for (const int k : {-800, 800}) {
      const RealSchur scaled = real_schur(oracle::scaled(t, k));
      ASSERT_EQ(scaled.rotation, r.rotation);
      ASSERT_EQ(oracle::scaled(scaled.deviator, -k), r.deviator);
      ASSERT_EQ(std::ldexp(scaled.mean, -k), r.mean);
    }
    // A rotation of the frame changes Q only, up to signs of columns.
    const Tensor<double> turn = oracle::random_rotation(random);
    const RealSchur turned = real_schur(oracle::rotated(turn, t));
    if (classify(t).in_real_domain() != classify(oracle::rotated(turn, t)).in_real_domain())
      continue;
    const double condition = 1 / relative_gap(t, oracle::rational_invariants(t));
    const double imaginary = deviator_eigenvalues(t).im;
    const double spread = classify(t).in_real_domain() ? r.deviator[0] - r.deviator[4] : imaginary;
    for (int i = 0; i < 9; ++i) {
      const double tolerance = 1e-11 * condition * (1 + 1 / spread);
      ASSERT_NEAR(std::fabs(turned.deviator[i]), std::fabs(r.deviator[i]), tolerance)
          << n << ' ' << i;
    }
  }
}

TEST(RealSchur, KnownOnes) {
  const double stretch = 2, spin = 3, shear = 0.5;
  const RealSchur c = real_schur({-1 + shear, -spin, 7, spin, -1 - shear, -8, 0, 0, stretch});
  const Tensor<double> expected = {-0.5, -3, 7, 3, -1.5, -8, 0, 0, 2};
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(c.deviator[i], expected[i], 1e-14);
    EXPECT_NEAR(c.rotation[i], i % 4 == 0, 1e-14);
  }
  // [[1, -1, 0], [1, -1, 0], [0, 0, 0]]: balanced, yet real: in the frame of (1, 1), (1, -1).
  const Tensor<double> nilpotent = real_schur({1, -1, 0, 1, -1, 0, 0, 0, 0}).deviator;
  EXPECT_NEAR(nilpotent[1], 2, 1e-15);
  for (const int i : {0, 2, 3, 4, 5, 6, 7, 8}) EXPECT_EQ(nilpotent[i], 0);
  EXPECT_EQ(real_schur({5, 0, 0, 0, 4, 0, 0, 0, 3}).mean, 4);
  // Tiny deviators keep their form under a huge trace, entries of 1e300 theirs.
  const RealSchur tiny = real_schur({1, 1e-300, 0, -1e-300, 1, 0, 0, 0, 1});
  EXPECT_NEAR(tiny.deviator[3] / 1e-300, 1, 1e-14);
  const RealSchur huge = real_schur({0, 1e300, 0, -1e300, 0, 0, 0, 0, 1e300});
  EXPECT_NEAR(huge.form()[3] / 1e300, 1, 1e-14);
  EXPECT_NEAR(huge.form()[8] / 1e300, 1, 1e-14);
}

}  // namespace
}  // namespace triplex

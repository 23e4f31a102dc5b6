// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenvalues.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>

#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

using oracle::Random;

std::array<std::complex<double>, 3> all_of(const Eigenvalues& e) {
  if (e.all_real) return {e.real[0], e.real[1], e.real[2]};
  return {std::complex<double>(e.real[0]), {e.re, e.im}, {e.re, -e.im}};
}

// The largest distance between two sets of three numbers under the best matching.
double distance(std::array<std::complex<double>, 3> a,
                const std::array<std::complex<double>, 3>& b) {
  std::array<int, 3> order = {0, 1, 2};
  double best = HUGE_VAL;
  do {
    double worst = 0;
    for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(a[order[i]] - b[i]));
    best = std::min(best, worst);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

std::array<std::complex<double>, 3> by_eigen(const Tensor<double>& t) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = t[i];
  const Eigen::Vector3cd v = Eigen::EigenSolver<Eigen::Matrix3d>(m, false).eigenvalues();
  return {v[0], v[1], v[2]};
}

TEST(Eigenvalues, AgreeWithEigenOnGenericTensors) {
  Random random(1);
  int real = 0;
  for (int n = 0; n < 20000; ++n) {
    Tensor<double> t = oracle::double_tensor(random);
    if (n % 3 == 0) {  // symmetric: well-conditioned and always real
      t[3] = t[1];
      t[6] = t[2];
      t[7] = t[5];
    }
    const Eigenvalues e = eigenvalues(t);
    real += static_cast<int>(e.all_real);
    ASSERT_LT(distance(all_of(e), by_eigen(t)), n % 3 == 0 ? 1e-12 : 1e-7);
    if (n % 3 == 0) {
      ASSERT_TRUE(e.all_real);
    }
    if (e.all_real) {
      ASSERT_GE(e.real[0], e.real[1]);
      ASSERT_GE(e.real[1], e.real[2]);
    } else {
      ASSERT_GT(e.im, 0);
    }
  }
  EXPECT_GT(real, 1000);
  EXPECT_LT(real, 19000);
}

TEST(Eigenvalues, KnownOnesWithCorrectLabels) {
  // The example of the wrong labels in print: (1, 0, -1), not (1, -1, 0).
  const Eigenvalues e = eigenvalues({1, 0, 0, 0, 0, 0, 0, 0, -1});
  ASSERT_TRUE(e.all_real);
  EXPECT_NEAR(e.real[0], 1, 1e-15);
  EXPECT_EQ(e.real[1], 0);
  EXPECT_NEAR(e.real[2], -1, 1e-15);
  // The sign of the real eigenvalue in the complex domain is that of q: p < 0, p = 0 and p > 0.
  for (const double stretch : {2.0, -2.0}) {
    for (const double spin : {0.5, std::sqrt(3.0), 3.0}) {
      const double s = -stretch / 2;
      const Eigenvalues c = eigenvalues({s, spin, 0, -spin, s, 0, 0, 0, stretch});
      ASSERT_FALSE(c.all_real);
      EXPECT_NEAR(c.real[0], stretch, 1e-14);
      EXPECT_NEAR(c.re, s, 1e-14);
      EXPECT_NEAR(c.im, spin, 1e-14);
    }
  }
  const Eigenvalues permutation = eigenvalues({0, 1, 0, 0, 0, 1, 1, 0, 0});
  EXPECT_NEAR(permutation.real[0], 1, 1e-15);
  EXPECT_NEAR(permutation.im, std::sqrt(3.0) / 2, 1e-15);
}

// Known integer eigenvalues, conjugated so that nothing can be read off the entries. The formulas
// see exact invariants, so even defective tensors come out to rounding, where QR loses half the
// digits.
TEST(Eigenvalues, ConjugatedIntegerSpectra) {
  Random random(2);
  for (int n = 0; n < 5000; ++n) {
    std::array<double, 3> l = {oracle::integer(random, 9), oracle::integer(random, 9),
                               oracle::integer(random, 9)};
    if (n % 3 == 0) l[1] = l[0];
    if (n % 9 == 0) l[2] = l[0];
    const Tensor<double> upper = {l[0],
                                  oracle::integer(random, 3),
                                  oracle::integer(random, 3),
                                  0,
                                  l[1],
                                  oracle::integer(random, 3),
                                  0,
                                  0,
                                  l[2]};
    const Eigenvalues e = eigenvalues(oracle::similar(random, upper, 5));
    std::sort(l.begin(), l.end(), std::greater<>());
    ASSERT_TRUE(e.all_real);
    for (int i = 0; i < 3; ++i) ASSERT_NEAR(e.real[i], l[i], 1e-12);
    for (int i = 0; i < 2; ++i) ASSERT_EQ(e.real[i] == e.real[i + 1], l[i] == l[i + 1]);
  }
}

TEST(Eigenvalues, TripleDegenerate) {
  for (const Tensor<double>& t : {Tensor<double>{}, Tensor<double>{3, 0, 0, 0, 3, 0, 0, 0, 3},
                                  Tensor<double>{3, 1e300, 0, 0, 3, -1e300, 0, 0, 3},
                                  Tensor<double>{1, -1, 0, 1, -1, 0, 0, 0, 0}}) {
    const Eigenvalues e = eigenvalues(t);
    ASSERT_TRUE(e.all_real);
    for (const double x : e.real) EXPECT_EQ(x, (t[0] + t[4] + t[8]) / 3);
  }
}

// The deviator's eigenvalues satisfy their equation: l1 + l2 + l3 = 0, the sum of products is p and
// the product is q, checked in exact arithmetic on the computed values, at every size.
TEST(Eigenvalues, SatisfyVieta) {
  Random random(3);
  for (int n = 0; n < 3000; ++n) {
    Tensor<double> t = n % 3 == 0   ? oracle::double_tensor(random)
                       : n % 3 == 1 ? oracle::degenerate_tensor(random)
                                    : oracle::integer_tensor(random, 3);
    if (n % 5 == 0) {  // close to a stratum
      for (double& x : t) x += std::ldexp(oracle::integer(random, 1), -20 - n % 32);
    }
    if (n % 7 == 0) {  // strongly non-normal: invariants far smaller than the entries allow
      t[1] *= 1e8;
      t[3] *= 1e-8;
    }
    const Eigenvalues e = deviator_eigenvalues(t);
    const oracle::RationalInvariants exact = oracle::rational_invariants(t);
    ASSERT_EQ(e.all_real, exact.d >= 0);
    const double p = exact.p.get_d(), q = exact.q.get_d();
    const double size = std::max(std::sqrt(std::fabs(p)), std::cbrt(std::fabs(q)));
    const auto l = all_of(e);
    ASSERT_LE(std::abs(l[0] + l[1] + l[2]), 1e-12 * size);
    ASSERT_LE(std::abs(l[0] * l[1] + l[1] * l[2] + l[2] * l[0] - p), 1e-12 * size * size);
    ASSERT_LE(std::abs(l[0] * l[1] * l[2] - q), 1e-12 * size * size * size);
  }
}

TEST(Eigenvalues, ScaleTransposeAndNegation) {
  Random random(4);
  for (int n = 0; n < 500; ++n) {
    const Tensor<double> t =
        n % 2 == 0 ? oracle::integer_tensor(random, 9) : oracle::degenerate_tensor(random);
    const auto l = deviator_eigenvalues(t);
    for (const int k : {-1000, -333, 333, 1010}) {
      const auto scaled = deviator_eigenvalues(oracle::scaled(t, k));
      ASSERT_EQ(scaled.all_real, l.all_real);
      for (int i = 0; i < 3; ++i) ASSERT_NEAR(std::ldexp(scaled.real[i], -k), l.real[i], 1e-13);
      ASSERT_NEAR(std::ldexp(scaled.im, -k), l.im, 1e-13);
    }
    ASSERT_EQ(deviator_eigenvalues(oracle::transposed(t)).real[0], l.real[0]);
    const auto negated = deviator_eigenvalues(oracle::negated(t));
    if (l.all_real) {
      for (int i = 0; i < 3; ++i) ASSERT_EQ(negated.real[i], -l.real[2 - i]);
    } else {
      ASSERT_EQ(negated.real[0], -l.real[0]);
      ASSERT_EQ(negated.im, l.im);
    }
  }
  // Eigenvalues far below the entries: a nilpotent tensor plus very little.
  const Eigenvalues tiny = deviator_eigenvalues({0, 1, 0, 0, 0, 1, 1e-300, 0, 0});
  EXPECT_NEAR(tiny.real[0] / 1e-100, 1, 1e-12);
  EXPECT_NEAR(tiny.im / 1e-100, std::sqrt(3.0) / 2, 1e-12);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/domain.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/tensor/mode.hpp"

namespace triplex {
namespace {

using oracle::Random;

Classification sector(int k) { return {Stratum::Sector, k}; }
Classification page(int k) { return {Stratum::Page, k}; }
constexpr Classification kSpine = {Stratum::Spine, 0};

// The table of the header, read off the signs one by one.
Classification expected(const oracle::RationalInvariants& i) {
  const int p = sgn(i.p), q = sgn(i.q), d = sgn(i.d);
  if (p == 0 && q == 0) return kSpine;
  if (q == 0) return p > 0 ? page(0) : page(3);
  if (p == 0) return q > 0 ? page(1) : page(5);
  if (d == 0) return q > 0 ? page(2) : page(4);
  if (p > 0) return q > 0 ? sector(0) : sector(5);
  if (d < 0) return q > 0 ? sector(1) : sector(4);
  return q > 0 ? sector(2) : sector(3);
}

Tensor<double> diagonal(double a, double b, double c) { return {a, 0, 0, 0, b, 0, 0, 0, c}; }

TEST(Domain, Examples) {
  EXPECT_EQ(classify(diagonal(3, -1, -2)), sector(2));
  EXPECT_EQ(classify(diagonal(2, 1, -3)), sector(3));
  EXPECT_EQ(classify(diagonal(1, 0, -1)), page(3));
  EXPECT_EQ(classify(diagonal(2, -1, -1)), page(2));
  EXPECT_EQ(classify(diagonal(1, 1, -2)), page(4));
  EXPECT_EQ(classify(diagonal(5, 5, 5)), kSpine);
  EXPECT_EQ(classify({0, 1, 0, -1, 0, 0, 0, 0, 0}), page(0));
  // A permutation matrix: l^3 = 1, p = 0; and a fast or slow rotation about a stretching axis.
  EXPECT_EQ(classify({0, 1, 0, 0, 0, 1, 1, 0, 0}), page(1));
  EXPECT_EQ(classify({0, -1, 0, 0, 0, -1, -1, 0, 0}), page(5));
  EXPECT_EQ(classify({-1, 9, 0, -9, -1, 0, 0, 0, 2}), sector(0));
  EXPECT_EQ(classify({-1, 0.5, 0, -0.5, -1, 0, 0, 0, 2}), sector(1));
  EXPECT_EQ(classify({1, 0.5, 0, -0.5, 1, 0, 0, 0, -2}), sector(4));
  EXPECT_EQ(classify({1, 9, 0, -9, 1, 0, 0, 0, -2}), sector(5));
}

// a = 1, b = -1, c = 1 in the paper's Schur form is balanced with a, b not both zero, and triple
// degenerate all the same: what counts is a + b = 0.
TEST(Domain, BalancedAndNilpotent) {
  for (const double d : {0.0, 1.0, -7.0}) {
    EXPECT_EQ(classify({1, -1, d, 1, -1, 3, 0, 0, 0}), kSpine);
  }
  EXPECT_TRUE(std::isnan(mode({1, -1, 0, 1, -1, 0, 0, 0, 0}).mu));
}

// [[a, c, 0], [0, 0, 0], [0, 0, -a]]: one mode, one isotropicity, one magnitude, many eigenvalues.
TEST(Domain, ModeAndIsotropicityDoNotFixEigenvalues) {
  for (const double a : {0.1, 0.3, 0.7}) {
    const Tensor<double> t = {a, std::sqrt(1 - 2 * a * a), 0, 0, 0, 0, 0, 0, -a};
    EXPECT_EQ(classify(t), page(3));
    EXPECT_EQ(mode(t).mu, 0);
    EXPECT_NEAR(magnitude_approx(t), 1, 1e-15);
    EXPECT_EQ(isotropicity_approx(t), 0);
  }
}

TEST(Domain, AgreesWithRationalArithmeticAndLaws) {
  Random random(1);
  std::array<int, 13> seen{};
  for (int n = 0; n < 20000; ++n) {
    const Tensor<double> t = n % 4 == 0   ? oracle::integer_tensor(random, 9)
                             : n % 4 == 1 ? oracle::double_tensor(random)
                                          : oracle::degenerate_tensor(random);
    const Classification c = classify(t);
    ASSERT_EQ(c, expected(oracle::rational_invariants(t)));
    ++seen[c.stratum == Stratum::Spine ? 12 : (c.stratum == Stratum::Page ? 6 : 0) + c.number];
    ASSERT_EQ(classify(oracle::transposed(t)), c);
    const Classification reflected = c.stratum == Stratum::Sector ? sector(5 - c.number)
                                     : c.stratum == Stratum::Page ? page((6 - c.number) % 6)
                                                                  : kSpine;
    ASSERT_EQ(classify(oracle::negated(t)), reflected);
    if (n % 4 != 1) {  // integers survive any power of two, and shears exactly
      for (const int k : {-1074, -600, 600, 1000}) ASSERT_EQ(classify(oracle::scaled(t, k)), c);
      ASSERT_EQ(classify(oracle::similar(random, t)), c);
    }
    if (c.stratum != Stratum::Sector) {
      ASSERT_EQ(c.stage, Stage::Exact);
    }
  }
  for (std::size_t k = 0; k < seen.size(); ++k) EXPECT_GT(seen[k], 20) << k;
}

// One unit in the last place to either side of an exact page is told apart.
TEST(Domain, OneUlpFromAPage) {
  const double up = std::nextafter(1.0, 2.0);
  const double down = std::nextafter(1.0, 0.0);
  // p = -1 - bc with trace zero and q = 0 by a zero row and column.
  EXPECT_EQ(classify({1, up, 0, -1, -1, 0, 0, 0, 0}), page(0));
  EXPECT_EQ(classify({1, down, 0, -1, -1, 0, 0, 0, 0}), page(3));
  EXPECT_EQ(classify({1, 1, 0, -1, -1, 0, 0, 0, 0}), kSpine);
  // The block [[-1, e], [f, -1]] has D of the sign of e f.
  EXPECT_EQ(classify({-1, 1, 0, 5e-324, -1, 0, 0, 0, 2}), sector(2));
  EXPECT_EQ(classify({-1, 1, 0, -5e-324, -1, 0, 0, 0, 2}), sector(1));
  EXPECT_EQ(classify({-1, 1, 0, 0, -1, 0, 0, 0, 2}), page(2));
}

TEST(Mode, SpecialModesAndSides) {
  EXPECT_EQ(mode(diagonal(1, 0, -1)).mu, 0);
  EXPECT_EQ(mode(diagonal(2, -1, -1)).mu, 1);
  EXPECT_EQ(mode(diagonal(2, -1, -1)).sign_q, Sign::Positive);
  EXPECT_EQ(mode(diagonal(1, 1, -2)).sign_q, Sign::Negative);
  EXPECT_TRUE(std::isinf(mode({0, 1, 0, 0, 0, 1, 1, 0, 0}).mu));
  EXPECT_LT(mode({-1, 1, 0, 5e-324, -1, 0, 0, 0, 2}).mu, 1);
  EXPECT_GT(mode({-1, 1, 0, -5e-324, -1, 0, 0, 0, 2}).mu, 1);
  Random random(2);
  for (int n = 0; n < 1000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const double p = minor_approx(t), q = det_approx(t);
    const double mu = 1.5 * std::sqrt(3.0) * std::fabs(q) / std::pow(std::fabs(p), 1.5);
    for (const int k : {-900, -1, 0, 900}) {
      EXPECT_NEAR(mode(oracle::scaled(t, k)).mu / mu, 1, 1e-8);
    }
    if (mode(t).sign_p == Sign::Negative) {
      EXPECT_EQ(mode(t).mu < 1, classify(t).in_real_domain());
    }
  }
}

}  // namespace
}  // namespace triplex

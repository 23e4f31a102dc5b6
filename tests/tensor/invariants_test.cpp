// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/invariants.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"

namespace triplex {
namespace {

using oracle::Random;

// mantissa 2^exponent, exactly.
mpq_class exact_value(const ScaledReal& x) {
  mpq_class r(x.mantissa);
  if (x.exponent > 0)
    mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(x.exponent));
  if (x.exponent < 0)
    mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-x.exponent));
  return r;
}

void expect_one(const ScaledReal& actual, Sign actual_sign, const mpq_class& exact, double error) {
  ASSERT_EQ(actual_sign, oracle::sign_of(exact));
  if (exact == 0) {
    ASSERT_EQ(actual.mantissa, 0);
    return;
  }
  ASSERT_GE(std::fabs(actual.mantissa), 0.5);
  ASSERT_LT(std::fabs(actual.mantissa), 1);
  ASSERT_LE(abs(exact_value(actual) - exact), abs(exact) * mpq_class(error));
}

void expect_agrees(const Tensor<double>& t) {
  const oracle::RationalInvariants exact = oracle::rational_invariants(t);
  for (const double error : {1.0, 0x1p-30, 0x1p-45}) {
    const Invariants i = invariants(t, error);
    expect_one(i.p, i.sign_p, exact.p, error);
    expect_one(i.q, i.sign_q, exact.q, error);
    expect_one(i.discriminant, i.sign_discriminant, exact.d, error);
  }
  EXPECT_EQ(trace_sign(t), oracle::sign_of(mpq_class(t[0]) + mpq_class(t[4]) + mpq_class(t[8])));
}

TEST(Invariants, AgreeWithRationalArithmetic) {
  Random random(1);
  for (int n = 0; n < 3000; ++n) {
    expect_agrees(oracle::double_tensor(random));
    expect_agrees(oracle::integer_tensor(random, 9));
    expect_agrees(oracle::degenerate_tensor(random));
  }
}

TEST(Invariants, EverySizeOfDouble) {
  Random random(2);
  for (int exponent = -1074; exponent <= 1018; exponent += 7) {
    expect_agrees(oracle::scaled(oracle::double_tensor(random), exponent));
    expect_agrees(oracle::scaled(oracle::degenerate_tensor(random), std::min(exponent, 1010)));
  }
}

TEST(Invariants, EntriesOfDifferentSizes) {
  Random random(3);
  for (int n = 0; n < 1000; ++n) {
    Tensor<double> t = oracle::double_tensor(random);
    for (double& x : t) x = std::ldexp(x, std::uniform_int_distribution<int>(-1074, 1018)(random));
    expect_agrees(t);
    // A huge trace over a small deviator.
    Tensor<double> u = oracle::scaled(oracle::double_tensor(random), -n % 60);
    for (const int i : {0, 4, 8}) u[i] += std::ldexp(1.0, n % 200);
    expect_agrees(u);
  }
}

TEST(Invariants, NearlyDegenerateTensorsKeepTheirAccuracy) {
  Random random(4);
  for (int n = 0; n < 1000; ++n) {
    Tensor<double> t = oracle::degenerate_tensor(random);
    for (double& x : t) x += std::ldexp(oracle::integer(random, 3), -20 - n % 30);
    expect_agrees(t);
  }
}

TEST(Invariants, DecidingStage) {
  EXPECT_EQ(invariants({1, 2, 3, 4, 5, 6, 7, 8, 10}).stage, Stage::Filter);
  EXPECT_EQ(invariants({0, 1, 0, 0, 0, 1, 0, 0, 0}).stage, Stage::Exact);   // nilpotent
  EXPECT_EQ(invariants({1, 0, 0, 0, 0, 0, 0, 0, -1}).stage, Stage::Exact);  // q = 0
}

TEST(Invariants, PlainDoubles) {
  const Tensor<double> t = {2, 0, 0, 0, -1, 0, 0, 0, -1};
  EXPECT_DOUBLE_EQ(minor_approx(t), -3);
  EXPECT_DOUBLE_EQ(det_approx(t), 2);
  EXPECT_EQ(discriminant_approx(t), 0);
  EXPECT_EQ(minor_approx(oracle::scaled(t, 1000)), -HUGE_VAL);
  EXPECT_EQ(minor_approx(oracle::scaled(t, -1000)), 0);
}

TEST(Invariants, DeviatorTraceMagnitudeIsotropicity) {
  Random random(5);
  for (const int exponent : {-1040, -500, 0, 500, 1018}) {
    const Tensor<double> t = oracle::scaled(oracle::double_tensor(random), exponent);
    const double unit = std::ldexp(1.0, exponent);
    const Tensor<double> a = deviator_approx(t);
    const double tolerance = 1e-15 * unit + 2e-323;
    EXPECT_NEAR(trace_approx(a), 0, 4 * tolerance);
    for (int i = 0; i < 9; ++i) {
      EXPECT_NEAR(a[i], t[i] - (i % 4 == 0 ? trace_approx(t) / 3 : 0), 4 * tolerance);
    }
    double sum = 0;
    for (const double x : t) sum += (x / unit) * (x / unit);
    EXPECT_NEAR(magnitude_approx(t) / unit, std::sqrt(sum), 1e-8);
    EXPECT_NEAR(isotropicity_approx(t), trace_approx(t) / unit / std::sqrt(3 * sum), 1e-8);
  }
  EXPECT_EQ(isotropicity_approx({}), 0);
  EXPECT_EQ(magnitude_approx({}), 0);
  EXPECT_DOUBLE_EQ(isotropicity_approx({7e300, 0, 0, 0, 7e300, 0, 0, 0, 7e300}), 1);
  EXPECT_DOUBLE_EQ(isotropicity_approx({-5e-324, 0, 0, 0, -5e-324, 0, 0, 0, -5e-324}), -1);
  // Nothing is lost against a huge trace.
  const Tensor<double> a = deviator_approx({1e16 + 2, 1, 0, 0, 1e16, 0, 0, 0, 1e16 - 2});
  EXPECT_EQ(a[0], 2);
  EXPECT_EQ(a[4], 0);
  EXPECT_EQ(a[8], -2);
}

}  // namespace
}  // namespace triplex

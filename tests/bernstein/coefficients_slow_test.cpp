// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Certified signs in bulk: a million random and a hundred thousand degenerate simplices for each of
// minor, det and discriminant, against polynomials expanded in 128-bit integers.

#include <gtest/gtest.h>

#include "../oracle/polynomial_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/bernstein/coefficients.hpp"

namespace triplex {
namespace {

using oracle::multi_indices;
using oracle::Random;
__extension__ typedef __int128 Wide;

// Entries up to 2^12: those of the tripled deviator at all four vertices together stay below 2^17,
// so |p|, |q| <= 2^37, 2^54 and 4 |p|^3 + 27 q^2 < 2^114, intermediate sums included.
constexpr int kRange = 1 << 12;

template <int N, int Degree, class Coefficients>
void expect_signs(const Coefficients& actual, const oracle::Form<Wide, N>& expanded,
                  SignStages& stages) {
  static constexpr auto kIndices = multi_indices<N, Degree>();
  for (std::size_t n = 0; n < kIndices.size(); ++n) {
    const Wide c = expanded.coefficient(kIndices[n]);
    ASSERT_EQ(actual.signs[n], oracle::sign_of(c)) << "coefficient " << n;
  }
  stages += actual.stages;
}

struct Stages {
  SignStages minor_stages, det, discriminant;
};

template <int N, class Draw>
Stages check(int cases, const Draw& draw) {
  Stages stages;
  for (int n = 0; n < cases && !::testing::Test::HasFatalFailure(); ++n) {
    std::array<Tensor<double>, N> t;
    std::array<Tensor<Wide>, N> w;
    for (int i = 0; i < N; ++i) {
      t[i] = draw();
      for (int k = 0; k < 9; ++k) w[i][k] = static_cast<Wide>(t[i][k]);
    }
    const oracle::ExpandedInvariants<Wide, N> expanded(w);
    expect_signs<N, 2>(minor_coefficients<N>(t), expanded.p, stages.minor_stages);
    expect_signs<N, 3>(det_coefficients<N>(t), expanded.q, stages.det);
    expect_signs<N, 6>(discriminant_coefficients<N>(t), expanded.d, stages.discriminant);
  }
  return stages;
}

// Generic data hardly ever needs more than the filter; exact zeros always do.
void expect_mostly_filtered(const SignStages& s) { EXPECT_LT(s.exact * 1000, s.filter); }

TEST(BernsteinCoefficientsSlow, RandomTets) {
  Random random(101);
  const Stages s = check<4>(600000, [&] { return oracle::integer_tensor(random, kRange); });
  expect_mostly_filtered(s.minor_stages);
  expect_mostly_filtered(s.det);
  expect_mostly_filtered(s.discriminant);
}

TEST(BernsteinCoefficientsSlow, RandomTriangles) {
  Random random(102);
  check<3>(200000, [&] { return oracle::integer_tensor(random, kRange); });
}

TEST(BernsteinCoefficientsSlow, RandomEdges) {
  Random random(103);
  check<2>(200000, [&] { return oracle::integer_tensor(random, kRange); });
}

TEST(BernsteinCoefficientsSlow, RandomVertices) {
  Random random(104);
  check<1>(200000, [&] { return oracle::integer_tensor(random, kRange); });
}

TEST(BernsteinCoefficientsSlow, DegenerateTets) {
  Random random(105);
  const Stages s = check<4>(50000, [&] { return oracle::degenerate_tensor(random); });
  EXPECT_GT(s.minor_stages.exact, 10000u);
  EXPECT_GT(s.det.exact, 10000u);
  EXPECT_GT(s.discriminant.exact, 10000u);
}

TEST(BernsteinCoefficientsSlow, DegenerateTriangles) {
  Random random(106);
  check<3>(30000, [&] { return oracle::degenerate_tensor(random); });
}

TEST(BernsteinCoefficientsSlow, DegenerateEdges) {
  Random random(107);
  check<2>(50000, [&] { return oracle::degenerate_tensor(random); });
}

TEST(BernsteinCoefficientsSlow, DegenerateVertices) {
  Random random(108);
  check<1>(100000, [&] { return oracle::degenerate_tensor(random); });
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/bernstein/coefficients.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <random>

#include "../oracle/polynomial_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

using oracle::multi_indices;
using oracle::multinomial;
using oracle::Random;

mpq_class power_of_two(int e) {
  mpq_class x = 1;
  if (e > 0) mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(e));
  if (e < 0) mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-e));
  return x;
}

// Every coefficient of one kind against the expanded polynomial: sign, value and error bound.
template <int N, int Degree, class Coefficients>
void expect_agrees(const Coefficients& actual, const oracle::Form<mpq_class, N>& expanded,
                   int oracle_factor) {
  const auto indices = multi_indices<N, Degree>();
  ASSERT_EQ(actual.values.size(), indices.size());
  for (std::size_t n = 0; n < indices.size(); ++n) {
    const mpq_class exact =
        expanded.coefficient(indices[n]) / (multinomial(indices[n]) * oracle_factor);
    const Sign expected = oracle::sign_of(exact);
    ASSERT_EQ(actual.signs[n], expected) << "coefficient " << n;
    const mpq_class scaled = exact * power_of_two(-actual.exponent);
    ASSERT_LE(abs(scaled - mpq_class(actual.values[n])), mpq_class(actual.error));
    if (actual.values[n] != 0) {
      ASSERT_EQ(oracle::sign_of(actual.values[n]), expected);
    }
  }
  EXPECT_EQ(actual.stages.filter + actual.stages.exact, indices.size());
}

template <int N>
void expect_all_agree(const std::array<Tensor<double>, N>& t) {
  std::array<Tensor<mpq_class>, N> r;
  for (int i = 0; i < N; ++i) r[i] = oracle::rational(t[i]);
  const oracle::ExpandedInvariants<mpq_class, N> expanded(r);
  expect_agrees<N, 2>(minor_coefficients<N>(t), expanded.p, 9);
  expect_agrees<N, 3>(det_coefficients<N>(t), expanded.q, 27);
  expect_agrees<N, 6>(discriminant_coefficients<N>(t), expanded.d, 729);
}

template <int N, class Draw>
std::array<Tensor<double>, N> simplex(const Draw& draw) {
  std::array<Tensor<double>, N> t;
  for (auto& x : t) x = draw();
  return t;
}

template <class Draw>
void expect_all_dimensions_agree(const Draw& draw, int cases) {
  for (int n = 0; n < cases; ++n) {
    expect_all_agree<1>(simplex<1>(draw));
    expect_all_agree<2>(simplex<2>(draw));
    expect_all_agree<3>(simplex<3>(draw));
    expect_all_agree<4>(simplex<4>(draw));
  }
}

template <int N, int Degree>
void expect_documented_order() {
  const auto indices = multi_indices<N, Degree>();
  const auto& actual = kMonomials<N, Degree>;
  ASSERT_EQ(actual.exponents.size(), indices.size());
  for (std::size_t n = 0; n < indices.size(); ++n) {
    for (int i = 0; i < N; ++i) EXPECT_EQ(actual.exponents[n][i], indices[n][i]);
    EXPECT_EQ(actual.multinomial[n], multinomial(indices[n]));
  }
}

TEST(BernsteinCoefficients, CountsAndOrder) {
  EXPECT_EQ((kBernsteinCoefficients<4, 2>), 10u);
  EXPECT_EQ((kBernsteinCoefficients<4, 3>), 20u);
  EXPECT_EQ((kBernsteinCoefficients<4, 6>), 84u);
  EXPECT_EQ((kBernsteinCoefficients<3, 6>), 28u);
  EXPECT_EQ((kBernsteinCoefficients<2, 6>), 7u);
  expect_documented_order<1, 6>();
  expect_documented_order<2, 6>();
  expect_documented_order<3, 6>();
  expect_documented_order<4, 2>();
  expect_documented_order<4, 3>();
  expect_documented_order<4, 6>();
  // The same order as the index tables of the forms.
  const auto squares = multi_indices<4, 2>();
  for (std::size_t n = 0; n < squares.size(); ++n) {
    std::array<int, 4> m{};
    for (const int i : pairs<4>()[n]) m[i] += 1;
    EXPECT_EQ(m, squares[n]);
  }
  const auto cubes = multi_indices<4, 3>();
  for (std::size_t n = 0; n < cubes.size(); ++n) {
    std::array<int, 4> m{};
    for (const int i : triples<4>()[n]) m[i] += 1;
    EXPECT_EQ(m, cubes[n]);
  }
}

TEST(BernsteinCoefficients, RandomDoubles) {
  Random random(1);
  expect_all_dimensions_agree([&] { return oracle::double_tensor(random); }, 100);
}

TEST(BernsteinCoefficients, DegenerateTensors) {
  Random random(2);
  expect_all_dimensions_agree([&] { return oracle::degenerate_tensor(random); }, 100);
}

TEST(BernsteinCoefficients, EverySizeOfDouble) {
  Random random(3);
  for (const int exponent :
       {-1073, -1060, -1000, -600, -300, -101, -99, 99, 101, 400, 700, 997, 1018}) {
    expect_all_dimensions_agree(
        [&] { return oracle::scaled(oracle::double_tensor(random), exponent); }, 3);
    expect_all_dimensions_agree(
        [&] { return oracle::scaled(oracle::degenerate_tensor(random), exponent - 9); }, 3);
  }
}

TEST(BernsteinCoefficients, MixedSizesInOneTensor) {
  Random random(4);
  const auto draw = [&] {
    Tensor<double> t = oracle::double_tensor(random);
    for (double& x : t) x = std::ldexp(x, std::uniform_int_distribution<int>(-1070, 1018)(random));
    return t;
  };
  expect_all_dimensions_agree(draw, 30);
}

TEST(BernsteinCoefficients, HugeTrace) {
  Random random(5);
  for (const int exponent : {20, 60, 200, 1000}) {
    const auto draw = [&] {
      Tensor<double> t = oracle::double_tensor(random);
      const double pressure = std::ldexp(1.0, exponent);
      for (const int i : {0, 4, 8}) t[i] += pressure;
      return t;
    };
    expect_all_dimensions_agree(draw, 10);
  }
}

TEST(BernsteinCoefficients, ExponentIsZeroForModerateData) {
  Random random(6);
  for (const int exponent : {-95, 0, 95}) {
    const auto t =
        simplex<4>([&] { return oracle::scaled(oracle::double_tensor(random), exponent); });
    EXPECT_EQ(minor_coefficients<4>(t).exponent, 0);
    EXPECT_EQ(det_coefficients<4>(t).exponent, 0);
    EXPECT_EQ(discriminant_coefficients<4>(t).exponent, 0);
  }
}

TEST(BernsteinCoefficients, DecidingStage) {
  Random random(7);
  // Generic data: the filter alone. Zero data: only exact arithmetic can tell.
  SignStages generic;
  for (int n = 0; n < 100; ++n) {
    const auto t = simplex<4>([&] { return oracle::double_tensor(random); });
    generic += minor_coefficients<4>(t).stages;
    generic += det_coefficients<4>(t).stages;
    generic += discriminant_coefficients<4>(t).stages;
  }
  EXPECT_EQ(generic.exact, 0u);
  EXPECT_EQ(generic.filter, 100u * (10 + 20 + 84));
  const auto nilpotent = discriminant_coefficients<1>({Tensor<double>{0, 1, 2, 0, 0, 3, 0, 0, 0}});
  EXPECT_EQ(nilpotent.signs[0], Sign::Zero);
  EXPECT_EQ(nilpotent.stages, (SignStages{0, 0, 1}));
}

// The Bernstein sums at rational points are p, q and D of the exactly interpolated tensor.
TEST(BernsteinCoefficients, SumsReproduceTheInterpolatedTensor) {
  Random random(8);
  for (int n = 0; n < 50; ++n) {
    const auto t = simplex<4>([&] { return oracle::integer_tensor(random, 12); });
    std::array<mpq_class, 4> x;
    mpq_class sum = 0;
    for (auto& w : x) {
      w = mpq_class(std::uniform_int_distribution<int>(0, 100)(random)) + mpq_class(1, 7);
      sum += w;
    }
    Tensor<mpq_class> interpolated;
    for (int i = 0; i < 4; ++i) {
      x[i] /= sum;
      for (int k = 0; k < 9; ++k) interpolated[k] += x[i] * mpq_class(t[i][k]);
    }
    const oracle::RationalInvariants expected = oracle::rational_invariants(interpolated);
    // Integer data: 18 p, 162 q and 2916 * 720 D are integers that the values round to.
    const auto total = [&](const auto& coefficients, const auto& indices, long denominator) {
      mpq_class value = 0;
      for (std::size_t k = 0; k < indices.size(); ++k) {
        mpq_class c(std::nearbyint(coefficients.values[k] * static_cast<double>(denominator)));
        c /= denominator;
        mpq_class term = c * multinomial(indices[k]);
        for (int i = 0; i < 4; ++i)
          for (int m = 0; m < indices[k][i]; ++m) term *= x[i];
        value += term;
      }
      return value;
    };
    EXPECT_EQ(total(minor_coefficients<4>(t), multi_indices<4, 2>(), 18), expected.p);
    EXPECT_EQ(total(det_coefficients<4>(t), multi_indices<4, 3>(), 162), expected.q);
    EXPECT_EQ(total(discriminant_coefficients<4>(t), multi_indices<4, 6>(), 2916L * 720),
              expected.d);
  }
}

TEST(BernsteinCoefficients, FacesUseTheirOwnVerticesOnly) {
  Random random(9);
  const auto t = simplex<4>([&] { return oracle::degenerate_tensor(random); });
  const auto tet = discriminant_coefficients<4>(t);
  const auto tet_indices = multi_indices<4, 6>();
  const auto face = discriminant_coefficients<3>({t[0], t[2], t[3]});
  const auto face_indices = multi_indices<3, 6>();
  for (std::size_t n = 0; n < face_indices.size(); ++n) {
    const std::array<int, 4> m = {face_indices[n][0], 0, face_indices[n][1], face_indices[n][2]};
    const auto at = std::find(tet_indices.begin(), tet_indices.end(), m) - tet_indices.begin();
    EXPECT_EQ(face.signs[n], tet.signs[static_cast<std::size_t>(at)]);
  }
}

}  // namespace
}  // namespace triplex

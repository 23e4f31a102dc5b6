// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/vertex.hpp"

#include <gtest/gtest.h>

#include "../oracle/perturbed_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"

namespace triplex {
namespace {

using oracle::Random;

struct Answer {
  std::optional<Sector> sector;
  SignStages stages;
};

Answer sector_of(const Tensor<double>& t) {
  const TensorField field = oracle::scattered_field({t});
  const RefinableField refinable(field);
  Answer a;
  a.sector = sector_at(refinable, VertexId{0}, standard_features(), a.stages);
  return a;
}

// The sector of T + eps B for eps = 2^-bits, in rationals.
Sector expected(const Tensor<double>& t, unsigned bits) {
  Tensor<mpq_class> r = oracle::rational(t);
  mpq_class eps(1);
  mpq_div_2exp(eps.get_mpq_t(), eps.get_mpq_t(), bits);
  for (int i = 0; i < 9; ++i) r[i] += eps * kPerturbation[i];
  const auto i = oracle::rational_invariants(r);
  const int p = sgn(i.p), q = sgn(i.q), d = sgn(i.d);
  EXPECT_TRUE(p != 0 && q != 0 && d != 0);
  if (p > 0)
    return q > 0 ? static_cast<Sector>(Domain::InnerComplexLinear)
                 : static_cast<Sector>(Domain::InnerComplexPlanar);
  if (d > 0)
    return q > 0 ? static_cast<Sector>(Domain::RealLinear)
                 : static_cast<Sector>(Domain::RealPlanar);
  return q > 0 ? static_cast<Sector>(Domain::OuterComplexLinear)
               : static_cast<Sector>(Domain::OuterComplexPlanar);
}

TEST(VertexSector, NumbersAndSigns) {
  for (int k = 0; k < 6; ++k) {
    const auto s = static_cast<Sector>(k);
    EXPECT_EQ(standard_features().sign_p(s), k == 0 || k == 5 ? Sign::Positive : Sign::Negative);
    EXPECT_EQ(standard_features().sign_q(s), k < 3 ? Sign::Positive : Sign::Negative);
  }
}

TEST(VertexSector, GenericTensorsAreDecidedByTheFilter) {
  Random random(1);
  for (int n = 0; n < 2000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const Answer a = sector_of(t);
    ASSERT_EQ(a.sector, expected(t, 1000));
    ASSERT_EQ(a.stages.exact, 0u);
    ASSERT_GE(a.stages.filter + a.stages.interval,
              standard_features().sign_p(*a.sector) == Sign::Negative ? 3u : 2u);
  }
}

TEST(VertexSector, ExactZerosAreDecidedByTheExactStage) {
  Random random(2);
  for (int n = 0; n < 3000; ++n) {
    const Tensor<double> t = oracle::degenerate_tensor(random);
    const Answer a = sector_of(t);
    ASSERT_EQ(a.sector, expected(t, 200));
    const auto i = oracle::rational_invariants(t);
    const bool asks_d = a.sector && standard_features().sign_p(*a.sector) == Sign::Negative;
    const unsigned zeros =
        (i.p == 0 ? 1u : 0u) + (i.q == 0 ? 1u : 0u) + (asks_d && i.d == 0 ? 1u : 0u);
    ASSERT_GE(a.stages.exact, zeros);
    if (i.p == 0 && i.q == 0) {
      ASSERT_EQ(a.stages.filter, 0u);
    }
  }
}

TEST(VertexSector, EverySizeOfDouble) {
  Random random(3);
  for (int exponent = -1074; exponent <= 1000; exponent += 17) {
    // Scaling changes nothing, exact zeros included: their perturbation is infinitesimal at any
    // scale.
    const Tensor<double> t = oracle::degenerate_tensor(random);
    EXPECT_EQ(sector_of(oracle::scaled(t, exponent)).sector, expected(t, 200)) << exponent;
    const Tensor<double> u = oracle::scaled(oracle::double_tensor(random), exponent);
    EXPECT_EQ(sector_of(u).sector, expected(u, 10000)) << exponent;
  }
  for (int n = 0; n < 200; ++n) {
    Tensor<double> t = oracle::double_tensor(random);
    for (double& x : t) x = std::ldexp(x, std::uniform_int_distribution<int>(-1074, 1000)(random));
    EXPECT_EQ(sector_of(t).sector, expected(t, 20000));
  }
}

// A vertex whose own data are tiny in a field of large data.
TEST(VertexSector, TinyTensorInALargeField) {
  Random random(4);
  for (int n = 0; n < 200; ++n) {
    const Tensor<double> tiny = oracle::scaled(oracle::degenerate_tensor(random), -1074 + n);
    const TensorField field =
        oracle::scattered_field({oracle::scaled(oracle::double_tensor(random), n % 3 * 500), tiny});
    const RefinableField refinable(field);
    SignStages stages;
    EXPECT_EQ(sector_at(refinable, VertexId{1}, standard_features(), stages),
              expected(tiny, 20000));
  }
}

TEST(VertexSector, LawsForNonzeroSigns) {
  Random random(5);
  for (int n = 0; n < 1000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const auto s = sector_of(t).sector;
    ASSERT_TRUE(s);
    EXPECT_EQ(sector_of(oracle::transposed(t)).sector, s);
    EXPECT_EQ(index(*sector_of(oracle::negated(t)).sector), 5 - index(*s));
  }
}

// A midpoint's sector is that of the exact mean of its ends.
TEST(VertexSector, Midpoints) {
  Random random(6);
  for (int n = 0; n < 500; ++n) {
    const Tensor<double> a =
        n % 2 == 0 ? oracle::double_tensor(random) : oracle::degenerate_tensor(random);
    const Tensor<double> b =
        n % 2 == 0 ? oracle::double_tensor(random) : oracle::degenerate_tensor(random);
    const TensorField field = oracle::scattered_field({a, b});
    RefinableField refinable(field);
    const auto half = refinable.add_midpoint(VertexId{0}, VertexId{1});
    ASSERT_TRUE(half);
    const auto quarter = refinable.add_midpoint(*half, VertexId{1});
    ASSERT_TRUE(quarter);
    Tensor<mpq_class> exact;
    for (int i = 0; i < 9; ++i) {
      exact[i] = (mpq_class(a[i]) + 3 * mpq_class(b[i])) / 4;
      mpq_class eps(kPerturbation[i]);
      mpq_div_2exp(eps.get_mpq_t(), eps.get_mpq_t(), 1000);
      exact[i] += eps;
    }
    const auto i = oracle::rational_invariants(exact);
    SignStages stages;
    const auto s = sector_at(refinable, *quarter, standard_features(), stages);
    ASSERT_TRUE(s);
    EXPECT_EQ(standard_features().sign_p(*s), oracle::sign_of(i.p));
    EXPECT_EQ(standard_features().sign_q(*s), oracle::sign_of(i.q));
    if (sgn(i.p) < 0) {
      EXPECT_EQ(*s == static_cast<Sector>(Domain::RealLinear) ||
                    *s == static_cast<Sector>(Domain::RealPlanar),
                sgn(i.d) > 0);
    }
  }
}

}  // namespace
}  // namespace triplex

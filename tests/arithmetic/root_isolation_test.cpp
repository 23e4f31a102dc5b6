// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/root_isolation.hpp"

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/CORE_BigInt.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "triplex/arithmetic/exact_conversion.hpp"

namespace triplex {
namespace {

using Oracle = CGAL::Algebraic_kernel_d_1<CORE::BigInt>;
using OraclePolynomial = Oracle::Polynomial_1;
using OracleRoot = Oracle::Algebraic_real_1;

mpq_class value(const mpz_class& numerator, unsigned exponent) {
  mpq_class q(numerator);
  mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), exponent);
  return q;
}

OraclePolynomial oracle_polynomial(const IntegerPolynomial& f) {
  std::vector<CORE::BigInt> c;
  for (const mpz_class& x : f) c.emplace_back(x.get_str());
  return OraclePolynomial(c.begin(), c.end());
}

Oracle::Bound bound(const mpz_class& numerator, unsigned exponent) {
  const mpz_class denominator = mpz_class(1) << exponent;
  return Oracle::Bound(CORE::BigInt(numerator.get_str()), CORE::BigInt(denominator.get_str()));
}

// Bernstein coefficients on [0,1] of a product of power-basis polynomials.
IntegerPolynomial product(const std::vector<IntegerPolynomial>& factors) {
  IntegerPolynomial r = {1};
  for (const IntegerPolynomial& f : factors) {
    IntegerPolynomial next(r.size() + f.size() - 1);
    for (std::size_t i = 0; i < r.size(); ++i) {
      for (std::size_t j = 0; j < f.size(); ++j) next[i + j] += r[i] * f[j];
    }
    r = std::move(next);
  }
  return r;
}

// The laws of RootIsolation against CGAL's algebraic kernel.
void expect_agrees(const std::vector<mpz_class>& bernstein, unsigned bits) {
  RootIsolation isolation{bernstein};
  ASSERT_FALSE(isolation.identically_zero());
  const Oracle kernel;
  std::vector<std::pair<OracleRoot, int>> all;
  const OraclePolynomial f = oracle_polynomial(isolation.polynomial());
  if (isolation.polynomial().size() > 1) kernel.solve_1_object()(f, std::back_inserter(all));
  std::vector<std::pair<OracleRoot, int>> expected;
  for (const auto& root : all) {
    if (root.first >= OracleRoot(0) && root.first <= OracleRoot(1)) expected.push_back(root);
  }
  for (const bool refined : {false, true}) {
    const auto& roots = isolation.roots();
    ASSERT_EQ(roots.size(), expected.size());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      EXPECT_EQ(roots[i].multiplicity, expected[i].second);
      const auto lo =
          kernel.compare_1_object()(expected[i].first, bound(roots[i].lo, roots[i].exponent));
      const auto hi =
          kernel.compare_1_object()(expected[i].first, bound(roots[i].hi, roots[i].exponent));
      EXPECT_EQ(lo, roots[i].is_point() ? CGAL::EQUAL : CGAL::LARGER);
      EXPECT_EQ(hi, roots[i].is_point() ? CGAL::EQUAL : CGAL::SMALLER);
      EXPECT_GE(roots[i].lo, 0);
      EXPECT_LE(value(roots[i].hi, roots[i].exponent), 1);
      if (i > 0) {
        EXPECT_LT(value(roots[i - 1].hi, roots[i - 1].exponent),
                  value(roots[i].lo, roots[i].exponent));
      }
      if (refined) {
        EXPECT_LE(value(roots[i].hi - roots[i].lo, roots[i].exponent), value(1, bits));
      }
    }
    if (!refined) {
      for (std::size_t i = 0; i < roots.size(); ++i) isolation.refine(i, bits);
    }
  }
}

TEST(RootIsolation, ConstantsAndZero) {
  EXPECT_TRUE(RootIsolation(std::vector<mpz_class>{0, 0, 0, 0, 0, 0, 0}).identically_zero());
  EXPECT_TRUE(RootIsolation(std::vector<mpz_class>{0}).identically_zero());
  EXPECT_FALSE(RootIsolation(std::vector<mpz_class>{-3, -3, -3}).identically_zero());
  EXPECT_TRUE(RootIsolation(std::vector<mpz_class>{-3, -3, -3}).roots().empty());
}

TEST(RootIsolation, SmallIntegersOfEveryDegree) {
  std::mt19937_64 random(20240101);
  for (int degree = 1; degree <= 6; ++degree) {
    for (const int range : {1, 2, 5, 1000}) {
      std::uniform_int_distribution<int> coefficient(-range, range);
      for (int n = 0; n < 120; ++n) {
        std::vector<mpz_class> b(static_cast<std::size_t>(degree) + 1);
        for (mpz_class& c : b) c = coefficient(random);
        if (RootIsolation(b).identically_zero()) continue;
        expect_agrees(b, 40);
      }
    }
  }
}

TEST(RootIsolation, DoublesOfAllSizes) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 60);
  for (int n = 0; n < 300; ++n) {
    std::vector<double> b(7);
    for (double& c : b) c = std::ldexp(mantissa(random), exponent(random));
    expect_agrees(to_integers(b), 60);
  }
}

TEST(RootIsolation, MultipleDyadicAndEndPointRoots) {
  // (4 t - k) for k = 0..4 to random powers, times a random quadratic.
  std::mt19937_64 random(11);
  std::uniform_int_distribution<int> power(0, 2), coefficient(-20, 20);
  for (int n = 0; n < 500; ++n) {
    std::vector<IntegerPolynomial> factors;
    std::size_t degree = 0;
    for (int k = 0; k <= 4; ++k) {
      for (int m = power(random); m > 0 && degree < 5; --m, ++degree) factors.push_back({-k, 4});
    }
    if (degree < 5) {
      factors.push_back({coefficient(random), coefficient(random), 2 * coefficient(random) + 1});
    }
    expect_agrees(to_bernstein(product(factors), 0, 1, 0), 30);
  }
}

TEST(RootIsolation, MultipleRootsThatAreNotDyadic) {
  // Rational (a t - b)^m and irrational (a t^2 + b t + c)^m.
  std::mt19937_64 random(13);
  std::uniform_int_distribution<int> numerator(1, 30), power(1, 3), coefficient(-9, 9);
  for (int n = 0; n < 500; ++n) {
    std::vector<IntegerPolynomial> factors;
    for (int k = 0; k < 2; ++k) {
      const IntegerPolynomial linear = {-numerator(random), numerator(random)};
      for (int m = power(random); m > 0; --m) factors.push_back(linear);
    }
    expect_agrees(to_bernstein(product(factors), 0, 1, 0), 30);
    const IntegerPolynomial quadratic = {coefficient(random), coefficient(random),
                                         2 * coefficient(random) + 1};
    const int m = power(random);
    expect_agrees(to_bernstein(product(std::vector<IntegerPolynomial>(m, quadratic)), 0, 1, 0), 30);
  }
}

TEST(RootIsolation, ClusteredRoots) {
  // Roots at distance 2^-k, down to far below what a double could tell.
  for (unsigned k : {3u, 20u, 31u, 32u, 33u, 60u, 200u, 1000u}) {
    const mpz_class big = mpz_class(1) << k;
    const IntegerPolynomial a = {-big, 3 * big};                            // 1/3
    const IntegerPolynomial b = {-big - 1, 3 * big};                        // 1/3 + 2^-k / 3
    const IntegerPolynomial c = {-2 * big + 3, 6 * big};                    // 1/3 - 2^-k / 2
    const IntegerPolynomial mignotte = {-1, 2 * big, -big * big, 0, 0, 1};  // two near 2^-k
    expect_agrees(to_bernstein(product({a, b}), 0, 1, 0), 10);
    expect_agrees(to_bernstein(product({a, b, c}), 0, 1, 0), 10);
    expect_agrees(to_bernstein(product({a, a, b, c, c}), 0, 1, 0), 10);
    expect_agrees(to_bernstein(mignotte, 0, 1, 0), 10);
  }
}

TEST(RootIsolation, ScaleDoesNotMatter) {
  const std::vector<double> b = {1, -2, 0.5, 3, -1, -0.25, 2};
  const RootIsolation reference{std::span<const double>(b)};
  ASSERT_FALSE(reference.roots().empty());
  for (const int shift : {-1070, -500, 500, 1020}) {
    std::vector<double> scaled = b;
    for (double& c : scaled) c = std::ldexp(c, shift);
    const RootIsolation isolation{std::span<const double>(scaled)};
    ASSERT_EQ(isolation.roots().size(), reference.roots().size());
    for (std::size_t i = 0; i < reference.roots().size(); ++i) {
      EXPECT_EQ(isolation.roots()[i].lo, reference.roots()[i].lo);
      EXPECT_EQ(isolation.roots()[i].hi, reference.roots()[i].hi);
    }
  }
}

TEST(RootIsolation, SignsAndOrderOfOtherPolynomialsAgainstOracle) {
  std::mt19937_64 random(17);
  std::uniform_int_distribution<int> coefficient(-4, 4), share(0, 1);
  const Oracle kernel;
  const auto draw = [&](std::size_t degree) {
    IntegerPolynomial f(degree + 1);
    for (mpz_class& c : f) c = coefficient(random);
    f.back() = 3;
    return f;
  };
  int zeros = 0, signs = 0, equal = 0;
  for (int n = 0; n < 1000; ++n) {
    const IntegerPolynomial common = share(random) != 0 ? draw(2) : IntegerPolynomial{1};
    const IntegerPolynomial f = product({common, draw(3)});
    const IntegerPolynomial g = product({common, draw(2)});
    RootIsolation a(to_bernstein(f, 0, 1, 0));
    RootIsolation b(to_bernstein(g, 0, 1, 0));
    std::vector<OracleRoot> roots_a, roots_b;
    const auto keep = [&](const IntegerPolynomial& h, std::vector<OracleRoot>& out) {
      std::vector<std::pair<OracleRoot, int>> all;
      kernel.solve_1_object()(oracle_polynomial(h), std::back_inserter(all));
      for (const auto& root : all) {
        if (root.first >= OracleRoot(0) && root.first <= OracleRoot(1)) out.push_back(root.first);
      }
    };
    keep(f, roots_a);
    keep(g, roots_b);
    ASSERT_EQ(roots_a.size(), a.roots().size());
    ASSERT_EQ(roots_b.size(), b.roots().size());
    for (std::size_t i = 0; i < roots_a.size(); ++i) {
      const auto expected = kernel.sign_at_1_object()(oracle_polynomial(g), roots_a[i]);
      EXPECT_EQ(static_cast<int>(a.sign_at_root(g, i)), static_cast<int>(expected));
      ++(expected == CGAL::ZERO ? zeros : signs);
      for (std::size_t j = 0; j < roots_b.size(); ++j) {
        const int order = compare_roots(a, i, b, j);
        const int reversed = compare_roots(b, j, a, i);
        EXPECT_EQ(order, static_cast<int>(kernel.compare_1_object()(roots_a[i], roots_b[j])));
        EXPECT_EQ(reversed, -order);
        equal += static_cast<int>(order == 0);
      }
    }
  }
  EXPECT_GT(zeros, 20);
  EXPECT_GT(signs, 200);
  EXPECT_GT(equal, 20);
}

TEST(IntegerPolynomial, BernsteinRoundTripAndValues) {
  std::mt19937_64 random(19);
  std::uniform_int_distribution<int> coefficient(-100, 100);
  for (int n = 0; n < 200; ++n) {
    IntegerPolynomial f(7);
    for (mpz_class& c : f) c = coefficient(random);
    f.back() = 5;
    const std::vector<mpz_class> b = to_bernstein(f, 0, 1, 0);
    EXPECT_EQ(primitive_part(from_bernstein(b)), primitive_part(f));
    // On [3/8, 5/8] the ends of the Bernstein coefficients have the signs of the end points.
    const std::vector<mpz_class> part = to_bernstein(f, 3, 5, 3);
    EXPECT_EQ(static_cast<Sign>(sgn(part.front())), sign_at(f, {3, 3}));
    EXPECT_EQ(static_cast<Sign>(sgn(part.back())), sign_at(f, {5, 3}));
  }
}

}  // namespace
}  // namespace triplex

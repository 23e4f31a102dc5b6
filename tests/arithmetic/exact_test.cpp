// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/exact.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <limits>
#include <random>

#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/interval.hpp"

namespace triplex {
namespace {

mpq_class rational(const Exact& x) {
  mpq_class q;
  x.export_to_mpq_t(q.get_mpq_t());
  return q;
}

// Doubles of every size, with denormals, powers of two and the extremes among them.
class Doubles {
 public:
  explicit Doubles(unsigned long seed) : random_(seed) {}
  double operator()() {
    switch (std::uniform_int_distribution<int>(0, 9)(random_)) {
      case 0:
        return 0;
      case 1:
        return sign() * std::numeric_limits<double>::denorm_min();
      case 2:
        return sign() * DBL_MAX;
      case 3:
        return sign() * DBL_MIN;
      case 4:
        return sign() * 1e300;
      case 5:
        return sign() * std::ldexp(1.0, exponent_(random_));
      case 6:
        return std::ldexp(mantissa_(random_), -1060);
      default:
        return std::ldexp(mantissa_(random_), exponent_(random_));
    }
  }

 private:
  double sign() { return mantissa_(random_) < 0 ? -1 : 1; }
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> mantissa_{-1, 1};
  std::uniform_int_distribution<int> exponent_{-1074, 1023};
};

TEST(Exact, RingOperationsAgreeWithRationals) {
  Doubles draw(1);
  for (int n = 0; n < 20000; ++n) {
    const double a = draw(), b = draw(), c = draw(), d = draw();
    const Exact x(a), y(b), z(c), w(d);
    const mpq_class p(a), q(b), r(c), s(d);
    ASSERT_EQ(rational(x), p);
    ASSERT_EQ(rational(x + y), p + q);
    ASSERT_EQ(rational(x - y), p - q);
    ASSERT_EQ(rational(x * y), p * q);
    ASSERT_EQ(rational(-x), -p);
    const mpq_class difference = p * q - r * s;
    const Exact exact = x * y - z * w;
    ASSERT_EQ(rational(exact), difference);
    ASSERT_EQ(static_cast<int>(sign(exact)), sgn(difference));
    ASSERT_EQ(x < y, p < q);
    ASSERT_EQ(x == y, p == q);
  }
}

TEST(Exact, RingLaws) {
  Doubles draw(2);
  for (int n = 0; n < 5000; ++n) {
    const Exact x(draw()), y(draw()), z(draw());
    ASSERT_EQ((x + y) + z, x + (y + z));
    ASSERT_EQ((x * y) * z, x * (y * z));
    ASSERT_EQ(x * (y + z), x * y + x * z);
    ASSERT_EQ(x * y, y * x);
    ASSERT_EQ(x + y, y + x);
    ASSERT_EQ(sign(x - x), Sign::Zero);
    ASSERT_EQ(sign(x * y), sign(x) * sign(y));
    ASSERT_EQ(sign(-x), -sign(x));
  }
}

TEST(Exact, SixFactorsOfAnySize) {
  Doubles draw(3);
  for (int n = 0; n < 2000; ++n) {
    Exact product(1);
    mpq_class expected = 1;
    for (int k = 0; k < 6; ++k) {
      const double a = draw(), b = draw();
      product = product * (Exact(a) + Exact(b));
      expected *= mpq_class(a) + mpq_class(b);
    }
    ASSERT_EQ(rational(product), expected);
  }
}

TEST(ExactConversion, Integers) {
  Doubles draw(4);
  for (int n = 0; n < 2000; ++n) {
    std::vector<double> c(5);
    for (double& x : c) x = draw();
    const std::vector<mpz_class> z = to_integers(c);
    for (std::size_t i = 0; i < c.size(); ++i) {
      ASSERT_EQ(sgn(z[i]), sgn(mpq_class(c[i])));
      for (std::size_t j = 0; j < c.size(); ++j) {
        ASSERT_EQ(mpq_class(z[i]) * mpq_class(c[j]), mpq_class(z[j]) * mpq_class(c[i]));
      }
    }
  }
}

TEST(ExactConversion, DoublesAndExponents) {
  Doubles draw(5);
  for (int n = 0; n < 5000; ++n) {
    const double a = draw(), b = draw();
    ASSERT_EQ(to_double_approx(Exact(a)), a);
    if (a == 0 || b == 0) continue;
    int e = 0;
    std::frexp(a, &e);
    ASSERT_EQ(binary_exponent(Exact(a)), e);
    // A product beyond the range of doubles, brought back by its exponent.
    const Exact x = Exact(a) * Exact(b);
    const int k = binary_exponent(x);
    const double f = to_double_approx(x, -k);
    ASSERT_GE(std::fabs(f), 0.5);
    ASSERT_LT(std::fabs(f), 1);
    mpq_class expected = mpq_class(a) * mpq_class(b);
    if (k > 0)
      mpq_div_2exp(expected.get_mpq_t(), expected.get_mpq_t(), static_cast<mp_bitcnt_t>(k));
    if (k < 0)
      mpq_mul_2exp(expected.get_mpq_t(), expected.get_mpq_t(), static_cast<mp_bitcnt_t>(-k));
    ASSERT_LE(abs(mpq_class(f) - expected), abs(expected) * mpq_class(0x1p-52));
  }
}

// Intervals hold the exact value of what was computed with them, over- and underflow included.
TEST(Interval, ContainsTheExactValue) {
  Doubles draw(6);
  for (int n = 0; n < 20000; ++n) {
    const double a = draw(), b = draw(), c = draw(), d = draw();
    double lo = 0, hi = 0;
    {
      const IntervalRounding protect;
      const Interval x = Interval(a) * Interval(b) - (Interval(c) + Interval(d)) * Interval(a);
      lo = x.inf();
      hi = x.sup();
    }
    const mpq_class exact =
        mpq_class(a) * mpq_class(b) - (mpq_class(c) + mpq_class(d)) * mpq_class(a);
    if (std::isfinite(lo)) {
      ASSERT_LE(mpq_class(lo), exact);
    }
    if (std::isfinite(hi)) {
      ASSERT_GE(mpq_class(hi), exact);
    }
    ASSERT_FALSE(lo > 0 && exact <= 0);
    ASSERT_FALSE(hi < 0 && exact >= 0);
  }
}

TEST(Interval, RoundingIsRestored) {
  { const IntervalRounding protect; }
  volatile double one = 1, tiny = 0x1p-60;
  EXPECT_EQ(one + tiny, 1);
  EXPECT_EQ(-one - tiny, -1);
}

// gamma(n) bounds (1 + u)^n - 1 and 1 - (1 - u)^n, with room for the bound's own roundings.
TEST(Filter, GammaBoundsRoundings) {
  mpq_class u(1);
  mpq_div_2exp(u.get_mpq_t(), u.get_mpq_t(), 53);
  EXPECT_EQ(mpq_class(kRoundoff), u);
  mpq_class up = 1;
  for (int n = 1; n <= 64; ++n) {
    up *= 1 + u;
    EXPECT_GT(mpq_class(gamma(n)), (up - 1) * (1 + 16 * u));
    EXPECT_LT(gamma(n), (n + 0.01) * kRoundoff);
  }
}

}  // namespace
}  // namespace triplex

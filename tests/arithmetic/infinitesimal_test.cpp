// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/infinitesimal.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "triplex/arithmetic/exact_conversion.hpp"

namespace triplex {
namespace {

mpq_class rational(const Exact& x) {
  mpq_class q;
  x.export_to_mpq_t(q.get_mpq_t());
  return q;
}

// Polynomials in eps over the rationals, never truncated.
using Polynomial = std::vector<mpq_class>;
Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial r(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  return r;
}
Polynomial plus(Polynomial a, const Polynomial& b, int s) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += s * b[i];
  return a;
}

struct Pair {
  Perturbed<4> series;
  Polynomial polynomial;
};

void expect_same(const Pair& x) {
  for (int k = 0; k < 7; ++k) {
    const auto i = static_cast<std::size_t>(k);
    ASSERT_EQ(rational(x.series.coefficient(k)),
              i < x.polynomial.size() ? x.polynomial[i] : mpq_class(0));
  }
}

class Infinitesimal : public ::testing::Test {
 protected:
  Pair draw() {
    const double a = std::ldexp(mantissa_(random_), exponent_(random_));
    const double b = small_(random_);
    const double c = small_(random_) == 0 ? 0 : a;
    return {Perturbed<4>(Exact(c), Exact(b)), {mpq_class(c), mpq_class(b)}};
  }
  std::mt19937_64 random_{1};
  std::uniform_real_distribution<double> mantissa_{-1, 1};
  std::uniform_int_distribution<int> exponent_{-1074, 1000}, small_{-2, 2};
};

TEST_F(Infinitesimal, AgreesWithUntruncatedPolynomials) {
  for (int n = 0; n < 3000; ++n) {
    Pair x = draw();
    for (int k = 0; k < 6; ++k) {
      const Pair y = draw();
      switch (small_(random_)) {
        case 0:
          x = {x.series + y.series, plus(x.polynomial, y.polynomial, 1)};
          break;
        case 1:
          x = {x.series - y.series, plus(x.polynomial, y.polynomial, -1)};
          break;
        case 2:
          x = {-x.series, plus({}, x.polynomial, -1)};
          break;
        default:
          x = {x.series * y.series, times(x.polynomial, y.polynomial)};
          break;
      }
    }
    expect_same(x);
  }
}

TEST_F(Infinitesimal, RingLaws) {
  const auto same = [](const Perturbed<4>& a, const Perturbed<4>& b) {
    for (int k = 0; k < 7; ++k) {
      if (!(a.coefficient(k) == b.coefficient(k))) return false;
    }
    return true;
  };
  for (int n = 0; n < 500; ++n) {
    const Perturbed<4> x = draw().series, y = draw().series, z = draw().series;
    ASSERT_TRUE(same((x * y) * z, x * (y * z)));
    ASSERT_TRUE(same(x * (y + z), x * y + x * z));
    ASSERT_TRUE(same(x * y, y * x));
    ASSERT_TRUE(same(x - x, Perturbed<4>(0)));
    ASSERT_TRUE(same(x * Perturbed<4>(1), x));
    ASSERT_EQ(sign(-x), -sign(x));
    ASSERT_EQ(sign(x * y), sign(x) * sign(y));  // degree two: nothing is cut off
  }
}

TEST_F(Infinitesimal, LowestCoefficientDecides) {
  const Perturbed<4> eps(Exact(0), Exact(1));
  Perturbed<4> power(1);
  for (int k = 0; k < 7; ++k) {
    EXPECT_EQ(sign(power), Sign::Positive);
    EXPECT_EQ(sign(Perturbed<4>(-1) * power), Sign::Negative);
    EXPECT_EQ(sign(Perturbed<4>(0x1p-1074) - Perturbed<4>(1e300) * power),
              k == 0 ? Sign::Negative : Sign::Positive);
    power = power * eps;
  }
  EXPECT_EQ(sign(power), Sign::Zero);  // eps^7 is cut off
}

// The sign is that at every small enough rational eps: here 2^-20000, far below all the data.
TEST_F(Infinitesimal, IsTheSignAtASmallNumber) {
  for (int n = 0; n < 500; ++n) {
    Pair x = draw();
    for (int k = 0; k < 3; ++k) {
      const Pair y = draw();
      x = {x.series * y.series - y.series,
           plus(times(x.polynomial, y.polynomial), y.polynomial, -1)};
    }
    mpq_class eps(1), value(0);
    mpq_div_2exp(eps.get_mpq_t(), eps.get_mpq_t(), 20000);
    for (std::size_t k = x.polynomial.size(); k-- > 0;) value = value * eps + x.polynomial[k];
    ASSERT_EQ(static_cast<int>(sign(x.series)), sgn(value));
  }
}

TEST(Perturbation, IsGeneric) {
  // It has a trace, is not symmetric, and its deviator lies on no page: p, q and D are not zero.
  const auto& b = kPerturbation;
  const long trace = b[0] + b[4] + b[8];
  EXPECT_NE(trace, 0);
  EXPECT_TRUE(b[1] != b[3] && b[2] != b[6] && b[5] != b[7]);
  std::array<long, 9> a;
  for (std::size_t i = 0; i < 9; ++i) a[i] = 3L * b[i] - (i % 4 == 0 ? trace : 0);
  const mpz_class p =
      a[0] * a[4] - a[1] * a[3] + a[4] * a[8] - a[5] * a[7] + a[8] * a[0] - a[2] * a[6];
  const mpz_class q = a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
                      a[2] * (a[3] * a[7] - a[4] * a[6]);
  EXPECT_NE(p, 0);
  EXPECT_NE(q, 0);
  EXPECT_NE(4 * p * p * p + 27 * q * q, 0);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/exact_range.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "triplex/arithmetic/exact_conversion.hpp"

namespace triplex {
namespace {

bool is_between(const Exact& low, const Exact& x, const Exact& high) {
  return sign(x - low) != Sign::Negative && sign(high - x) != Sign::Negative;
}
bool contains(const ExactRange& r, const Exact& x) { return is_between(r.lo, x, r.hi); }

class ExactRangeTest : public testing::Test {
 protected:
  ExactRange range() {
    const double a = number_(random_), b = number_(random_);
    return {Exact(std::min(a, b)), Exact(std::max(a, b))};
  }
  static std::array<Exact, 3> members(const ExactRange& r) {
    return {r.lo, r.hi, (r.lo + r.hi) * Exact(0.5)};
  }

  std::mt19937_64 random_{20240611};
  std::uniform_real_distribution<double> number_{-2, 2};
};

TEST_F(ExactRangeTest, SumsDifferencesAndProductsEncloseThoseOfMembers) {
  for (int n = 0; n < 500; ++n) {
    const ExactRange a = range(), b = range();
    for (const Exact& x : members(a))
      for (const Exact& y : members(b)) {
        EXPECT_TRUE(contains(a + b, x + y));
        EXPECT_TRUE(contains(a - b, x - y));
        EXPECT_TRUE(contains(a * b, x * y));
        EXPECT_TRUE(contains(-a, -x));
        EXPECT_TRUE(contains(abs(a), sign(x) == Sign::Negative ? -x : x));
      }
  }
}

TEST_F(ExactRangeTest, QuotientsEncloseThoseOfMembersClosely) {
  int divided = 0;
  for (int n = 0; n < 500; ++n) {
    const ExactRange a = range(), b = range();
    if (sign(b.lo) != sign(b.hi)) continue;
    ++divided;
    const ExactRange q = a / b;
    for (const Exact& x : members(a))
      for (const Exact& y : members(b)) {
        // q.lo <= x / y <= q.hi, without a division.
        const Exact low = q.lo * y, high = q.hi * y;
        EXPECT_TRUE(sign(y) == Sign::Positive ? is_between(low, x, high)
                                              : is_between(high, x, low));
      }
    // Each end is the quotient of two ends, up to 2^-512.
    const ExactRange point = ExactRange(a.lo) / ExactRange(b.lo);
    EXPECT_NE(sign(Exact(0x1p-511) - (point.hi - point.lo)), Sign::Negative);
  }
  EXPECT_GT(divided, 100);
}

TEST_F(ExactRangeTest, RootsEncloseClosely) {
  for (int n = 0; n < 200; ++n) {
    const Exact x(std::fabs(number_(random_)));
    const ExactRange r = sqrt(ExactRange(x * x * x));
    EXPECT_TRUE(is_between(r.lo * r.lo, x * x * x, r.hi * r.hi));
    EXPECT_TRUE(contains(sqrt(ExactRange(x * x)), x));
    EXPECT_NE(sign(Exact(0x1p-510) - (r.hi - r.lo)), Sign::Negative);
  }
  const ExactRange below = sqrt(ExactRange(Exact(-1), Exact(4)));
  EXPECT_TRUE(contains(below, Exact(0)));
  EXPECT_TRUE(contains(below, Exact(2)));
}

TEST(ToExact, KeepsSignAndZero) {
  EXPECT_TRUE(to_exact(mpz_class(0)).is_zero());
  for (const char* digits :
       {"1", "-1", "18446744073709551616", "-340282366920938463463374607431768211457"}) {
    const mpz_class n(digits);
    const auto back = to_integers(std::span<const Exact>(std::array{to_exact(n), Exact(1)}));
    EXPECT_EQ(back[0], n * back[1]);
  }
}

}  // namespace
}  // namespace triplex

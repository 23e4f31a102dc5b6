// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/exact_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "triplex/arithmetic/exact_conversion.hpp"

namespace triplex {
namespace {

const Exact& least(const Exact& a, const Exact& b) { return sign(a - b) == Sign::Positive ? b : a; }
const Exact& most(const Exact& a, const Exact& b) { return sign(a - b) == Sign::Positive ? a : b; }

/// n 2^-kRangeBits.
Exact from_fixed_point(const mpz_class& n) {
  return to_exact(n) * Exact(std::ldexp(1.0, -static_cast<int>(kRangeBits)));
}

/// a / b, rounded downwards and upwards. \pre b > 0.
ExactRange quotient(const Exact& a, const Exact& b) {
  const auto integers = to_integers(std::span<const Exact>(std::array{a, b}));
  const mpz_class numerator = integers[0] << kRangeBits;
  mpz_class low, high;
  mpz_fdiv_q(low.get_mpz_t(), numerator.get_mpz_t(), integers[1].get_mpz_t());
  mpz_cdiv_q(high.get_mpz_t(), numerator.get_mpz_t(), integers[1].get_mpz_t());
  return {from_fixed_point(low), from_fixed_point(high)};
}

/// floor(x 2^(2 kRangeBits)). \pre x >= 0.
mpz_class fixed_point(const Exact& x) {
  const auto integers = to_integers(std::span<const Exact>(std::array{x, Exact(1)}));
  const mpz_class scaled = integers[0] << (2 * kRangeBits);
  mpz_class result;
  mpz_fdiv_q(result.get_mpz_t(), scaled.get_mpz_t(), integers[1].get_mpz_t());
  return result;
}

}  // namespace

ExactRange operator*(const ExactRange& a, const ExactRange& b) {
  if (sign(a.lo) == Sign::Positive && sign(b.lo) == Sign::Positive)
    return {a.lo * b.lo, a.hi * b.hi};
  if (sign(a.hi) == Sign::Negative) return -((-a) * b);
  if (sign(b.hi) == Sign::Negative) return -(a * (-b));
  const std::array<Exact, 4> p = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
  return {least(least(p[0], p[1]), least(p[2], p[3])), most(most(p[0], p[1]), most(p[2], p[3]))};
}

ExactRange operator/(const ExactRange& a, const ExactRange& b) {
  if (sign(b.hi) == Sign::Negative) return -a / -b;
  // Of positive divisors the extreme quotients belong to one end each.
  const Exact& below = sign(a.lo) == Sign::Negative ? b.lo : b.hi;
  const Exact& above = sign(a.hi) == Sign::Negative ? b.hi : b.lo;
  return {quotient(a.lo, below).lo, quotient(a.hi, above).hi};
}

ExactRange sqrt(const ExactRange& x) {
  mpz_class low, high;
  if (sign(x.lo) == Sign::Positive) mpz_sqrt(low.get_mpz_t(), fixed_point(x.lo).get_mpz_t());
  mpz_sqrt(high.get_mpz_t(), mpz_class(fixed_point(x.hi) + 1).get_mpz_t());
  return {from_fixed_point(low), from_fixed_point(high + 1)};
}

ExactRange abs(const ExactRange& x) {
  if (sign(x.lo) != Sign::Negative) return x;
  if (sign(x.hi) != Sign::Positive) return -x;
  return {Exact(0), most(x.hi, -x.lo)};
}

}  // namespace triplex

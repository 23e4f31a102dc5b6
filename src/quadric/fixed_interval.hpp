// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/quadric/quadric_form.hpp"

namespace triplex::detail {

using triplex::known_sign;

/// An enclosure [lo, hi] / 2^Bits: where intervals of doubles are too wide, and no ring of exact
/// numbers has the roots at hand. Guarantee: every operation encloses the exact result.
template <unsigned Bits>
struct FixedInterval {
  mpz_class lo, hi;

  FixedInterval() = default;
  /// \pre a multiple of 2^-Bits below 2^400.
  explicit FixedInterval(double x) : lo(std::ldexp(x, Bits)), hi(lo) {}
  FixedInterval(mpz_class l, mpz_class h) : lo(std::move(l)), hi(std::move(h)) {}

  friend FixedInterval operator+(const FixedInterval& a, const FixedInterval& b) {
    return {a.lo + b.lo, a.hi + b.hi};
  }
  friend FixedInterval operator-(const FixedInterval& a, const FixedInterval& b) {
    return {a.lo - b.hi, a.hi - b.lo};
  }
  FixedInterval operator-() const { return {-hi, -lo}; }
  friend FixedInterval operator*(const FixedInterval& a, const FixedInterval& b) {
    const std::array<mpz_class, 4> c = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    const auto [least, most] = std::minmax_element(c.begin(), c.end());
    FixedInterval r;
    mpz_fdiv_q_2exp(r.lo.get_mpz_t(), least->get_mpz_t(), Bits);
    mpz_cdiv_q_2exp(r.hi.get_mpz_t(), most->get_mpz_t(), Bits);
    return r;
  }
};

/// Exact numbers times one power of two, which brings the largest to about 1.
template <unsigned Bits>
std::vector<FixedInterval<Bits>> to_fixed(std::span<const Exact> exact) {
  const std::vector<mpz_class> n = to_integers(exact);
  std::size_t size = 0;
  for (const mpz_class& x : n)
    if (x != 0) size = std::max(size, mpz_sizeinbase(x.get_mpz_t(), 2));
  std::vector<FixedInterval<Bits>> r;
  for (const mpz_class& x : n) {
    FixedInterval<Bits>& to = r.emplace_back();
    mpz_class shifted;
    mpz_mul_2exp(shifted.get_mpz_t(), x.get_mpz_t(), Bits);
    mpz_fdiv_q_2exp(to.lo.get_mpz_t(), shifted.get_mpz_t(), size);
    mpz_cdiv_q_2exp(to.hi.get_mpz_t(), shifted.get_mpz_t(), size);
  }
  return r;
}

template <unsigned Bits>
std::optional<Sign> known_sign(const FixedInterval<Bits>& x) {
  if (x.lo > 0) return Sign::Positive;
  if (x.hi < 0) return Sign::Negative;
  if (x.lo == 0 && x.hi == 0) return Sign::Zero;
  return std::nullopt;
}

/// Of a number that is not negative, however it is enclosed.
template <unsigned Bits>
FixedInterval<Bits> root_of(const FixedInterval<Bits>& x) {
  const auto root = [](const mpz_class& n) {
    mpz_class shifted, r;
    mpz_mul_2exp(shifted.get_mpz_t(), n.get_mpz_t(), Bits);
    mpz_sqrt(r.get_mpz_t(), shifted.get_mpz_t());
    return r;
  };
  return {x.lo > 0 ? root(x.lo) : mpz_class(0),
          x.hi > 0 ? mpz_class(root(x.hi) + 1) : mpz_class(0)};
}
inline Interval root_of(const Interval& x) {
  return CGAL::sqrt(Interval(x.inf() > 0 ? x.inf() : 0, x.sup() > 0 ? x.sup() : 0));
}

template <unsigned Bits>
double middle_of(const FixedInterval<Bits>& x) {
  long exponent = 0;
  const mpz_class sum = x.lo + x.hi;
  const double m = mpz_get_d_2exp(&exponent, sum.get_mpz_t());
  return std::ldexp(m, static_cast<int>(exponent) - static_cast<int>(Bits) - 1);
}
inline double middle_of(const Interval& x) { return x.inf() / 2 + x.sup() / 2; }

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/exact_conversion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace triplex {
namespace {

// x = numerator / 2^exponent. The limbs of an Exact are private; its conversion to a canonical
// fraction is not.
Dyadic to_dyadic(const Exact& x) {
  mpq_class fraction;
  x.export_to_mpq_t(fraction.get_mpq_t());
  const auto exponent = static_cast<unsigned>(mpz_sizeinbase(fraction.get_den_mpz_t(), 2) - 1);
  return {std::move(fraction.get_num()), exponent};
}

// |x| = f 2^e with 1/2 <= |f| < 1, f rounded towards zero.
std::pair<double, int> mantissa_and_exponent(const Exact& x) {
  const Dyadic d = to_dyadic(x);
  signed long e = 0;
  const double f = mpz_get_d_2exp(&e, d.numerator.get_mpz_t());
  return {f, static_cast<int>(e) - static_cast<int>(d.exponent)};
}

}  // namespace

std::vector<mpz_class> to_integers(std::span<const Exact> c) {
  std::vector<Dyadic> dyadics;
  dyadics.reserve(c.size());
  unsigned finest = 0;
  for (const Exact& x : c) {
    dyadics.push_back(to_dyadic(x));
    finest = std::max(finest, dyadics.back().exponent);
  }
  std::vector<mpz_class> r(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) {
    mpz_mul_2exp(r[i].get_mpz_t(), dyadics[i].numerator.get_mpz_t(), finest - dyadics[i].exponent);
  }
  return r;
}

std::vector<mpz_class> to_integers(std::span<const double> c) {
  std::vector<Exact> exact;
  exact.reserve(c.size());
  for (const double x : c) exact.emplace_back(x);
  return to_integers(std::span<const Exact>(exact));
}

Exact to_exact(const mpz_class& n) {
  // CGAL 5.5's conversion of an integer loses its sign, and does not know zero.
  if (sgn(n) == 0) return Exact(0);
  const Exact size{mpz_class(abs(n))};
  return sgn(n) > 0 ? size : -size;
}

double to_double_approx(const Exact& x, int shift) {
  if (x.is_zero()) return 0.0;
  const auto [f, e] = mantissa_and_exponent(x);
  return std::ldexp(f, e + shift);
}

int binary_exponent(const Exact& x) { return mantissa_and_exponent(x).second; }

}  // namespace triplex

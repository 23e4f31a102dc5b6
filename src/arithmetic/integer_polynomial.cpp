// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/integer_polynomial.hpp"

#include <utility>

namespace triplex {
namespace {

void trim(IntegerPolynomial& f) {
  while (!f.empty() && sgn(f.back()) == 0) f.pop_back();
}

mpz_class binomial(std::size_t n, std::size_t k) {
  mpz_class r;
  mpz_bin_uiui(r.get_mpz_t(), n, k);
  return r;
}

mpz_class shifted_left(const mpz_class& x, std::size_t bits) {
  mpz_class r;
  mpz_mul_2exp(r.get_mpz_t(), x.get_mpz_t(), bits);
  return r;
}

// Divides f by g with factors of g's leading coefficient put in: a f = q g + r, deg r < deg g.
// Leaves r in f and returns q. \pre g is not zero.
IntegerPolynomial pseudo_divide(IntegerPolynomial& f, const IntegerPolynomial& g) {
  IntegerPolynomial q;
  if (f.size() >= g.size()) q.resize(f.size() - g.size() + 1);
  const mpz_class& leading = g.back();
  while (f.size() >= g.size()) {
    const std::size_t shift = f.size() - g.size();
    const mpz_class top = f.back();
    for (mpz_class& c : f) c *= leading;
    for (mpz_class& c : q) c *= leading;
    for (std::size_t i = 0; i < g.size(); ++i) f[i + shift] -= top * g[i];
    q[shift] += top;
    trim(f);  // the leading term cancels
  }
  trim(q);
  return q;
}

}  // namespace

IntegerPolynomial from_bernstein(std::span<const mpz_class> b) {
  if (b.empty()) return {};
  // f = sum_j C(n,j) (Delta^j b)_0 t^j with forward differences Delta.
  std::vector<mpz_class> difference(b.begin(), b.end());
  const std::size_t n = b.size() - 1;
  IntegerPolynomial f(n + 1);
  for (std::size_t j = 0; j <= n; ++j) {
    f[j] = binomial(n, j) * difference[0];
    for (std::size_t i = 0; i + j < n; ++i) difference[i] = difference[i + 1] - difference[i];
  }
  trim(f);
  return f;
}

std::vector<mpz_class> to_bernstein(const IntegerPolynomial& f, const mpz_class& lo,
                                    const mpz_class& hi, unsigned exponent) {
  if (f.empty()) return {};
  const std::size_t n = f.size() - 1;
  // a(s) = 2^(n e) f(s / 2^e), then a(lo + s) by Horner's shifts, then s = (hi - lo) t.
  IntegerPolynomial a(n + 1);
  for (std::size_t j = 0; j <= n; ++j) a[j] = shifted_left(f[j], (n - j) * exponent);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = n; j-- > k;) a[j] += lo * a[j + 1];
  }
  const mpz_class width = hi - lo;
  mpz_class power = 1;
  mpz_class common = 1;
  for (std::size_t j = 0; j <= n; ++j) {
    a[j] *= power;
    power *= width;
    common = lcm(common, binomial(n, j));
  }
  // b_i = sum_{j<=i} C(i,j) / C(n,j) a_j, times the common multiple of all C(n,j).
  std::vector<mpz_class> b(n + 1);
  for (std::size_t j = 0; j <= n; ++j) {
    const mpz_class weight = common / binomial(n, j) * a[j];
    for (std::size_t i = j; i <= n; ++i) b[i] += binomial(i, j) * weight;
  }
  return b;
}

Sign sign_at(const IntegerPolynomial& f, const Dyadic& x) {
  if (f.empty()) return Sign::Zero;
  mpz_class sum = f.back();  // Horner: 2^(e k) times the value of the top k + 1 coefficients
  std::size_t shift = 0;
  for (std::size_t j = f.size() - 1; j-- > 0;) {
    shift += x.exponent;
    sum = sum * x.numerator + shifted_left(f[j], shift);
  }
  return static_cast<Sign>(sgn(sum));
}

IntegerPolynomial derivative(const IntegerPolynomial& f) {
  IntegerPolynomial d;
  for (std::size_t j = 1; j < f.size(); ++j) d.push_back(f[j] * static_cast<unsigned long>(j));
  return d;
}

IntegerPolynomial primitive_part(IntegerPolynomial f) {
  if (f.empty()) return f;
  mpz_class content = 0;
  for (const mpz_class& c : f) content = ::gcd(content, c);
  if (sgn(f.back()) < 0) content = -content;
  for (mpz_class& c : f) mpz_divexact(c.get_mpz_t(), c.get_mpz_t(), content.get_mpz_t());
  return f;
}

IntegerPolynomial gcd(IntegerPolynomial f, IntegerPolynomial g) {
  // Euclid with primitive remainders. Dividing by contents changes nothing over the rationals.
  f = primitive_part(std::move(f));
  g = primitive_part(std::move(g));
  while (!g.empty()) {
    pseudo_divide(f, g);
    f = primitive_part(std::move(f));
    std::swap(f, g);
  }
  return f;
}

IntegerPolynomial quotient(IntegerPolynomial f, const IntegerPolynomial& g) {
  return primitive_part(pseudo_divide(f, g));
}

std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& f) {
  std::vector<IntegerPolynomial> factors;
  // `once` holds each root of multiplicity >= m once, `rest` holds it m' - m times.
  IntegerPolynomial rest = gcd(f, derivative(f));
  IntegerPolynomial once = quotient(f, rest);
  while (once.size() > 1) {
    IntegerPolynomial again = gcd(once, rest);
    factors.push_back(quotient(once, again));
    rest = quotient(std::move(rest), again);
    once = std::move(again);
  }
  return factors;
}

}  // namespace triplex

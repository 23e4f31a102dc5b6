// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <span>
#include <vector>

#include "triplex/arithmetic/sign.hpp"

namespace triplex {

/// The dyadic rational numerator / 2^exponent.
struct Dyadic {
  mpz_class numerator;
  unsigned exponent = 0;
};

/// A polynomial in one variable with integer coefficients in the power basis, constant term first.
/// The last coefficient is not zero; the zero polynomial has no coefficients.
using IntegerPolynomial = std::vector<mpz_class>;

/// From Bernstein coefficients of degree n = size - 1 on [0,1]: the same polynomial.
IntegerPolynomial from_bernstein(std::span<const mpz_class> b);
/// Bernstein coefficients of a positive multiple, of the polynomial's own degree, on
/// [lo, hi] / 2^exponent.
std::vector<mpz_class> to_bernstein(const IntegerPolynomial& f, const mpz_class& lo,
                                    const mpz_class& hi, unsigned exponent);

/// The certified sign of f at x.
Sign sign_at(const IntegerPolynomial& f, const Dyadic& x);

IntegerPolynomial derivative(const IntegerPolynomial& f);
/// f over the greatest common divisor of its coefficients; leading coefficient made positive.
IntegerPolynomial primitive_part(IntegerPolynomial f);
/// The primitive greatest common divisor over the rationals; the zero polynomial if both are zero.
IntegerPolynomial gcd(IntegerPolynomial f, IntegerPolynomial g);
/// The primitive part of f / g. \pre g divides f over the rationals and is not zero.
IntegerPolynomial quotient(IntegerPolynomial f, const IntegerPolynomial& g);
/// Yun's decomposition: the primitive part of f is the product of r[m-1]^m, each r[m-1] square-free
/// and all coprime. \pre f is not zero.
std::vector<IntegerPolynomial> square_free_factors(const IntegerPolynomial& f);

}  // namespace triplex

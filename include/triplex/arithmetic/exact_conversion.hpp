// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <span>
#include <vector>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/integer_polynomial.hpp"

namespace triplex {

/// The integers c_i 2^k for one power of two that makes all c_i integers; same signs and ratios.
/// Shape: one integer per input. Guarantee: exact, k is the same for all.
std::vector<mpz_class> to_integers(std::span<const Exact> c);
/// \pre every c_i is finite.
std::vector<mpz_class> to_integers(std::span<const double> c);

/// An integer as an exact number.
Exact to_exact(const mpz_class& n);

/// x 2^shift as a double. Guarantee: relative error below 2^-52 where the result is a normal
/// double; beyond that it overflows to infinity or underflows as IEEE doubles do.
double to_double_approx(const Exact& x, int shift = 0);

/// Exponent e with 2^(e-1) <= |x| < 2^e. \pre x is not zero.
int binary_exponent(const Exact& x);

}  // namespace triplex

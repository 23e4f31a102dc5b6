// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/filter.hpp"

namespace triplex {

/// Error of a Bernstein coefficient of 2 P^3 + 3 Q^2 computed in doubles by `minus_discriminant`;
/// times its multinomial, of the monomial coefficient. With the monomial form of P bounded
/// coefficientwise by |P| (sum of lambda)^2 and that of Q by |Q| (sum of lambda)^3, it is at most
///   2 ((|P| + dP)^3 - |P|^3) + 3 ((|Q| + dQ)^2 - |Q|^2) + gamma(kDepth) (2 |P|^3 + 3 |Q|^2),
/// where kDepth counts the roundings on one term: scaling 1, products 2, sums of at most 10 terms
/// in P^2 and 10 in P^3 (or 20 in Q^2), and 2 more. Source: proofs/filter.md.
inline double discriminant_coefficient_error(const FormBounds& b) {
  constexpr int kDepth = 1 + 2 + 10 + 10 + 2;
  const double p = b.p_magnitude, dp = b.p_error, q = b.q_magnitude, dq = b.q_error;
  return (1 + 0x1p-20) * (2 * dp * (3 * p * p + 3 * p * dp + dp * dp) + 3 * dq * (2 * q + dq) +
                          gamma(kDepth) * (2 * p * p * p + 3 * q * q));
}

}  // namespace triplex

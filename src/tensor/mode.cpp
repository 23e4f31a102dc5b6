// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/mode.hpp"

#include <cmath>
#include <limits>

namespace triplex {

Mode mode(const Tensor<double>& t) { return mode(invariants(t)); }

Mode mode(const Invariants& i) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Mode m{0, i.sign_p, i.sign_q};
  if (i.sign_p == Sign::Zero) {
    m.mu = i.sign_q == Sign::Zero ? std::numeric_limits<double>::quiet_NaN() : kInfinity;
    return m;
  }
  if (i.sign_q == Sign::Zero) return m;
  // |p| = f 2^(2k) with f in [1/4, 1): then |p|^(3/2) = f^(3/2) 2^(3k).
  const int k = (i.p.exponent + (i.p.exponent & 1)) / 2;
  const double f = std::fabs(i.p.scaled(-2 * k));
  const double ratio = 1.5 * std::sqrt(3.0) * std::fabs(i.q.mantissa) / (f * std::sqrt(f));
  m.mu = std::ldexp(ratio, i.q.exponent - 3 * k);
  if (i.sign_p == Sign::Negative) {
    if (i.sign_discriminant == Sign::Zero) m.mu = 1;
    if (i.sign_discriminant == Sign::Positive) m.mu = std::fmin(m.mu, std::nextafter(1.0, 0.0));
    if (i.sign_discriminant == Sign::Negative) m.mu = std::fmax(m.mu, std::nextafter(1.0, 2.0));
  }
  // Neither zero nor infinite here: keep it so beyond the range of doubles.
  m.mu = std::fmax(m.mu, std::numeric_limits<double>::denorm_min());
  m.mu = std::fmin(m.mu, std::numeric_limits<double>::max());
  return m;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

// The equation l^3 + p l = q of |q| (the sign is put back at the end), scaled by a power of two so
// that the larger of |p|^(1/2) and |q|^(1/3) is of size one, with D = -4 p^3 - 27 q^2.
struct Cubic {
  double third_of_p;  // |p| / 3
  double half_of_q;   // |q| / 2
  double root_of_d;   // sqrt(|D| / 108): D / 108 = (|p|/3)^3 - (q/2)^2 for p < 0
  int exponent;       // eigenvalues are 2^exponent times those of the scaled equation

  explicit Cubic(const Invariants& i) {
    // p = f 2^e has a square root below 2^ceil(e/2), q a cube root below 2^ceil(e/3).
    const auto ceil_div = [](int a, int b) { return a >= 0 ? (a + b - 1) / b : -((-a) / b); };
    const bool has_p = i.sign_p != Sign::Zero;
    const bool has_q = i.sign_q != Sign::Zero;
    exponent = 0;
    if (has_p) exponent = ceil_div(i.p.exponent, 2);
    if (has_q) {
      const int by_q = ceil_div(i.q.exponent, 3);
      exponent = has_p ? std::max(exponent, by_q) : by_q;
    }
    third_of_p = std::fabs(i.p.scaled(-2 * exponent)) / 3;
    half_of_q = std::fabs(i.q.scaled(-3 * exponent)) / 2;
    // 2^(-6 exponent) D may be below the range of doubles, but its square root is not: halve the
    // exponents.
    const int odd = i.discriminant.exponent & 1;
    root_of_d = std::ldexp(std::sqrt(std::fabs(std::ldexp(i.discriminant.mantissa, odd)) / 108),
                           (i.discriminant.exponent - odd) / 2 - 3 * exponent);
  }
};

// D >= 0, q >= 0: w = sqrt(-p/3), cos 3 theta = (q/2) / w^3, sin 3 theta = sqrt(D/108) / w^3,
// l = 2 w cos(theta + 2 pi k / 3). theta lies in [0, pi/6]. With 3 phi = pi/2 - 3 theta the medium
// eigenvalue is -2 w sin(phi), accurate near the real neutral surface where it vanishes.
std::array<double, 3> real_roots(const Cubic& c, bool degenerate) {
  const double w = std::sqrt(c.third_of_p);
  if (degenerate) return {2 * w, -w, -w};
  const double theta = std::atan2(c.root_of_d, c.half_of_q) / 3;
  const double phi = std::atan2(c.half_of_q, c.root_of_d) / 3;
  const double major_value = 2 * w * std::cos(theta);
  const double medium = -2 * w * std::sin(phi);
  const double minor_value = -w * (std::cos(theta) + std::numbers::sqrt3 * std::sin(theta));
  return {major_value, std::max(medium, minor_value), std::min(medium, minor_value)};
}

struct ComplexRoots {
  double real;  // the real root; the others are -real/2 +- i im
  double im;
};

// D < 0, q >= 0. With Cardano's u^3 = q/2 + sqrt(-D/108) and v = (|p|/3) / u the roots are u + v
// (p <= 0) or u - v (p > 0) and im = sqrt(3)/2 times the other one of the two. The difference
// cancels near u = v; there u = w e^t, v = w e^-t with w = sqrt(|p|/3) and
//   p < 0: u + v = 2 w cosh t, u - v = 2 w sinh t, sinh 3t = sqrt(-D/108) / w^3,
//   p > 0: u - v = 2 w sinh t, u + v = 2 w cosh t, sinh 3t = (q/2) / w^3.
ComplexRoots complex_roots(const Cubic& c, Sign sign_p) {
  constexpr double kHalfRoot3 = std::numbers::sqrt3 / 2;
  const double w = std::sqrt(c.third_of_p);
  const double w_cubed = w * c.third_of_p;
  const double sinh_of_3t = sign_p == Sign::Positive ? c.half_of_q : c.root_of_d;  // times w^3
  double sum = 0;
  double difference = 0;
  if (sinh_of_3t < w_cubed) {
    const double t = std::asinh(sinh_of_3t / w_cubed) / 3;
    sum = 2 * w * std::cosh(t);
    difference = 2 * w * std::sinh(t);
  } else {
    const double u = std::cbrt(c.half_of_q + c.root_of_d);
    const double v = c.third_of_p / u;
    sum = u + v;
    difference = u - v;
  }
  return sign_p == Sign::Positive ? ComplexRoots{difference, kHalfRoot3 * sum}
                                  : ComplexRoots{sum, kHalfRoot3 * difference};
}

}  // namespace

Eigenvalues deviator_eigenvalues(const Tensor<double>& t) {
  return deviator_eigenvalues(invariants(t, kEigenvalueAccuracy));
}

Eigenvalues deviator_eigenvalues(const Invariants& i, int shift) {
  Eigenvalues e;
  e.all_real = i.sign_discriminant != Sign::Negative;
  if (i.sign_p == Sign::Zero && i.sign_q == Sign::Zero) return e;
  const Cubic cubic(i);
  const int exponent = cubic.exponent + shift;
  const bool negative = i.sign_q == Sign::Negative;
  if (e.all_real && i.sign_q == Sign::Zero) {  // l^3 + p l = 0
    const double root = std::ldexp(std::sqrt(3 * cubic.third_of_p), exponent);
    e.real = {root, 0, -root};
  } else if (e.all_real) {
    e.real = real_roots(cubic, i.sign_discriminant == Sign::Zero);
    if (negative) e.real = {-e.real[2], -e.real[1], -e.real[0]};
    for (double& x : e.real) x = std::ldexp(x, exponent);
  } else {
    const ComplexRoots roots = complex_roots(cubic, i.sign_p);
    e.real[0] = std::ldexp(negative ? -roots.real : roots.real, exponent);
    e.re = -e.real[0] / 2;
    e.im = std::ldexp(roots.im, exponent);
  }
  return e;
}

Eigenvalues eigenvalues(const Tensor<double>& t) {
  Eigenvalues e = deviator_eigenvalues(t);
  const double mean = trace_approx(t) / 3;
  e.real[0] += mean;
  if (e.all_real) {
    e.real[1] += mean;
    e.real[2] += mean;
  } else {
    e.re += mean;
  }
  return e;
}

}  // namespace triplex

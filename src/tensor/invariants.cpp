// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/invariants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

int exponent_of(double x) {
  int e = 0;
  std::frexp(x, &e);
  return e;
}

double largest_entry(const Tensor<double>& t) {
  double m = 0;
  for (const double x : t) m = std::fmax(m, std::fabs(x));
  return m;
}

Tensor<double> scaled(Tensor<double> t, int exponent) {
  for (double& x : t) x = std::ldexp(x, exponent);
  return t;
}

ScaledReal scaled_real(double x, int exponent) {
  ScaledReal r;
  r.mantissa = std::frexp(x, &r.exponent);
  r.exponent = x == 0 ? 0 : r.exponent + exponent;
  return r;
}

ScaledReal scaled_real(const Exact& x, double divisor) {
  if (x.is_zero()) return {};
  const int e = binary_exponent(x);
  return scaled_real(to_double_approx(x, -e) / divisor, e);
}

// P = -tr(A'^2), Q = 6 det(A') and S = 2 P^3 + 3 Q^2 = -4 D(A') of the tripled deviator A', in
// doubles, with error bounds. The tensor is scaled so that the entries of A' are at most 8 and the
// largest is at least 1/2.
struct Filtered {
  double p, q, s;
  double p_error, q_error, s_error;
};

// Let X = |xx - yy| + |xx - zz| and so on as computed: the diagonal entry of A' has two roundings
// on either difference, so its error is at most gamma(2) X, as |3 t| gamma(1) off the diagonal.
// With these magnitudes in place of the entries, let |P| and |Q| be the sums of the absolute values
// of all terms, as computed. Then
//   P: two entries with 2 roundings each, a product, doubling is exact, 5 sums: 10,
//      and as many again in |P| itself, covered by gamma's factor: error <= gamma(10) |P|;
//   Q: three entries with 2 each, two products, a difference, 2 sums, a factor 6: 12,
//      error <= gamma(12) |Q|;
//   S: 6 (P + e_P)^2 e_P + 6 (Q + e_Q) e_Q from the data, and 5 roundings of 2 |P|^3 + 3 Q^2.
// A product may underflow: kTiny is more than all such losses, and far below every bound in use.
Filtered filtered(const Tensor<double>& t, const Tensor<double>& a) {
  constexpr double kTiny = 0x1p-1000;
  const double xy = std::fabs(t[0] - t[4]);
  const double yz = std::fabs(t[4] - t[8]);
  const double zx = std::fabs(t[8] - t[0]);
  Tensor<double> m;
  for (int i = 0; i < 9; ++i) m[i] = std::fabs(a[i]);
  m[0] = xy + zx;
  m[4] = xy + yz;
  m[8] = yz + zx;

  Filtered f{};
  f.p =
      -((a[0] * a[0] + a[4] * a[4] + a[8] * a[8]) + 2 * (a[1] * a[3] + a[2] * a[6] + a[5] * a[7]));
  f.p_error = gamma(10) * ((m[0] * m[0] + m[4] * m[4] + m[8] * m[8]) +
                           2 * (m[1] * m[3] + m[2] * m[6] + m[5] * m[7])) +
              kTiny;
  f.q = 6 * (a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
             a[2] * (a[3] * a[7] - a[4] * a[6]));
  f.q_error = gamma(12) * 6 *
                  (m[0] * (m[4] * m[8] + m[5] * m[7]) + m[1] * (m[3] * m[8] + m[5] * m[6]) +
                   m[2] * (m[3] * m[7] + m[4] * m[6])) +
              kTiny;
  f.s = 2 * (f.p * f.p * f.p) + 3 * (f.q * f.q);
  const double p_high = std::fabs(f.p) + f.p_error;
  const double q_high = std::fabs(f.q) + f.q_error;
  f.s_error = (6 * p_high * p_high * f.p_error + 6 * q_high * f.q_error) * (1 + 0x1p-20) +
              gamma(5) * (2 * p_high * p_high * p_high + 3 * q_high * q_high) + kTiny;
  return f;
}

// From P, Q and S to p, q and D: see `Forms`.
constexpr double kMinorDivisor = 18;
constexpr double kDetDivisor = 162;
constexpr double kDiscriminantDivisor = -4 * 729;

struct ExactForms {
  Exact p, q, s;
  explicit ExactForms(const Tensor<double>& t) {
    Tensor<Exact> exact;
    for (int i = 0; i < 9; ++i) exact[i] = Exact(t[i]);
    const Forms<Exact, 1> f = forms_of<Exact, 1>({triple_deviator(exact)});
    p = f.p[0];
    q = f.q[0];
    s = Exact(2) * (p * p * p) + Exact(3) * (q * q);
  }
};

}  // namespace

double ScaledReal::value() const { return std::ldexp(mantissa, exponent); }
double ScaledReal::scaled(int shift) const { return std::ldexp(mantissa, exponent + shift); }

Invariants invariants(const Tensor<double>& t, double relative_error) {
  Invariants r;
  std::optional<Filtered> filter;
  // First bring the tensor to size one (losing at most denormals, which kTiny covers as long as the
  // deviator is not itself that small), then the deviator, which may be much smaller.
  const int first = exponent_of(largest_entry(t));
  Tensor<double> unit = scaled(t, -first);
  const int second = exponent_of(largest_entry(triple_deviator(unit)));
  constexpr int kSmallestDeviator = -60;  // 2^-1074 of the scaling / 2^-60 is far below gamma(1)
  if (second > kSmallestDeviator && largest_entry(unit) > 0) {
    unit = scaled(unit, -second);
    filter = filtered(unit, triple_deviator(unit));
  }
  const int exponent = first + second;

  std::optional<ExactForms> exact;
  const auto decide = [&](double value, double error, int degree, double divisor, auto member,
                          ScaledReal& out, Sign& out_sign) {
    // |value - true| <= error, and value - error >= error / r bounds the relative error by r; one
    // more rounding for the division leaves r / 2 to spare.
    if (filter && std::fabs(value) > error * (1 + 2 / relative_error)) {
      out = scaled_real(value / divisor, degree * exponent);
      out_sign = out.mantissa > 0 ? Sign::Positive : Sign::Negative;
      return;
    }
    if (!exact) exact.emplace(t);
    r.stage = Stage::Exact;
    out = scaled_real((*exact).*member, divisor);
    out_sign = sign((*exact).*member) * (divisor > 0 ? Sign::Positive : Sign::Negative);
  };
  const Filtered f = filter.value_or(Filtered{});
  decide(f.p, f.p_error, 2, kMinorDivisor, &ExactForms::p, r.p, r.sign_p);
  decide(f.q, f.q_error, 3, kDetDivisor, &ExactForms::q, r.q, r.sign_q);
  decide(f.s, f.s_error, 6, kDiscriminantDivisor, &ExactForms::s, r.discriminant,
         r.sign_discriminant);
  return r;
}

double trace_approx(const Tensor<double>& t) {
  const int e =
      exponent_of(std::fmax(std::fmax(std::fabs(t[0]), std::fabs(t[4])), std::fabs(t[8])));
  return std::ldexp(std::ldexp(t[0], -e) + std::ldexp(t[4], -e) + std::ldexp(t[8], -e), e);
}

Sign trace_sign(const Tensor<double>& t) { return sign(Exact(t[0]) + Exact(t[4]) + Exact(t[8])); }

Tensor<double> deviator_approx(const Tensor<double>& t) {
  // A third of the tripled deviator: no cancellation against a large trace. Scaled to size one, so
  // that nothing overflows.
  const int e = exponent_of(largest_entry(t));
  Tensor<double> a = triple_deviator(scaled(t, -e));
  for (double& x : a) x = std::ldexp(x / 3, e);
  for (const int i : {1, 2, 3, 5, 6, 7}) a[i] = t[i];
  return a;
}

double minor_approx(const Tensor<double>& t) { return invariants(t).p.value(); }
double det_approx(const Tensor<double>& t) { return invariants(t).q.value(); }
double discriminant_approx(const Tensor<double>& t) { return invariants(t).discriminant.value(); }

double magnitude_approx(const Tensor<double>& t) {
  const int e = exponent_of(largest_entry(t));
  double sum = 0;
  for (const double x : scaled(t, -e)) sum += x * x;
  return std::ldexp(std::sqrt(sum), e);
}

double isotropicity_approx(const Tensor<double>& t) {
  const int e = exponent_of(largest_entry(t));
  const Tensor<double> unit = scaled(t, -e);
  const double magnitude = magnitude_approx(unit);
  if (magnitude == 0) return 0;
  return std::clamp(trace_approx(unit) / (std::sqrt(3.0) * magnitude), -1.0, 1.0);
}

}  // namespace triplex

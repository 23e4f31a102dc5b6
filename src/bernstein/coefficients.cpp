// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/bernstein/coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

// From the forms P = 18 p and Q = 162 q of the tripled deviator, and with D(3A) = 729 D(A) from
// 4 D(3A) = -(2 P^3 + 3 Q^2), to p, q and D.
constexpr double kMinorDivisor = 18;
constexpr double kDetDivisor = 162;
constexpr double kDiscriminantDivisor = 4 * 729;

// Exponents within which results are given unscaled: the sixth power of 2^100 is far from overflow,
// and so is 2^-100 from underflow, 6 * 100 + 53 < 1022.
constexpr int kUnscaled = 100;
// Exponents within which `triple_deviator` is taken of the tensor as it is.
constexpr int kModerate = 500;

int exponent_of(double x) {  // 2^(e-1) <= |x| < 2^e; 0 for zero
  int e = 0;
  std::frexp(x, &e);
  return e;
}

// The tripled deviators times 2^-exponent in doubles, and how well they are known.
template <int N>
struct ScaledSimplex {
  std::array<Tensor<double>, N> a;
  EntryBounds bounds;
  int exponent = 0;

  explicit ScaledSimplex(const std::array<Tensor<double>, N>& tensors) {
    double largest = 0;
    for (const auto& t : tensors)
      for (const double x : t) largest = std::fmax(largest, std::fabs(x));
    const int before = std::abs(exponent_of(largest)) > kModerate ? exponent_of(largest) : 0;
    for (int i = 0; i < N; ++i) {
      Tensor<double> t = tensors[i];
      for (double& x : t) x = std::ldexp(x, -before);
      a[i] = triple_deviator(t);
      for (const double x : a[i]) bounds.magnitude = std::fmax(bounds.magnitude, std::fabs(x));
      bounds.error = std::fmax(bounds.error, deviator_error(t));
    }
    exponent = before + exponent_of(bounds.magnitude);
    if (std::abs(exponent) <= kUnscaled || bounds.magnitude == 0) exponent = 0;
    const int shift = before - exponent;
    if (shift == 0) return;
    for (auto& t : a)
      for (double& x : t) x = std::ldexp(x, shift);
    bounds.magnitude = std::ldexp(bounds.magnitude, shift);
    bounds.error = std::ldexp(bounds.error, shift) + kUnderflow;
  }

  // A diagonal entry is (t_i - t_j) + (t_i - t_k): two roundings on either difference, and both are
  // comparable with the deviator even where the trace is huge. Off the diagonal: 3 t, one rounding.
  static double deviator_error(const Tensor<double>& t) {
    const double xy = std::fabs(t[0] - t[4]);
    const double yz = std::fabs(t[4] - t[8]);
    const double zx = std::fabs(t[8] - t[0]);
    double off_diagonal = 0;
    for (const int i : {1, 2, 3, 5, 6, 7}) off_diagonal = std::fmax(off_diagonal, std::fabs(t[i]));
    return gamma(3) * std::fmax(std::fmax(xy + yz, yz + zx), zx + xy) +
           3 * gamma(2) * off_diagonal + kUnderflow;
  }
  // Scaling loses at most half of the smallest denormal, 2^-1075, per entry; tripled and summed.
  static constexpr double kUnderflow = 0x1p-1070;
};

// The same forms exactly, in the units of the tensors, computed when first asked for.
template <int N>
class LazyExactForms {
 public:
  explicit LazyExactForms(const std::array<Tensor<double>, N>& tensors) : tensors_(tensors) {}

  const Forms<Exact, N>& operator()() {
    if (!forms_) {
      std::array<Tensor<Exact>, N> a;
      for (int i = 0; i < N; ++i) {
        Tensor<Exact> t;
        for (int k = 0; k < 9; ++k) t[k] = Exact(tensors_[i][k]);
        a[i] = triple_deviator(t);
      }
      forms_ = forms_of<Exact, N>(a);
    }
    return *forms_;
  }

 private:
  const std::array<Tensor<double>, N>& tensors_;
  std::optional<Forms<Exact, N>> forms_;
};

// One coefficient up the ladder: `value` with error at most `error`, both before the division;
// `exact()` is the exact value times 2^(Degree * scale.exponent), as an Exact.
template <std::size_t Count, class ExactValue>
void decide(CertifiedCoefficients<Count>& r, std::size_t n, bool usable, double value, double error,
            double divisor, ExactValue exact) {
  if (usable && std::fabs(value) > error) {
    r.signs[n] = value > 0 ? Sign::Positive : Sign::Negative;
    r.values[n] = value / divisor;
    r.error = std::fmax(r.error, (error + gamma(1) * std::fabs(value)) / divisor);
    r.stages.count(Stage::Filter);
    return;
  }
  const Exact x = exact();
  r.signs[n] = sign(x);
  r.values[n] = to_double_approx(x, -r.exponent) / divisor;
  // Below 2^-52 for the conversion and 2^-53 for the division, and an underflow of either.
  r.error = std::fmax(r.error, gamma(4) * std::fabs(r.values[n]) + 0x1p-1073);
  r.stages.count(Stage::Exact);
}

}  // namespace

template <int N>
MinorCoefficients<N> minor_coefficients(const std::array<Tensor<double>, N>& tensors) {
  const ScaledSimplex<N> simplex(tensors);
  const Forms<double, N> f = forms_of<double, N>(simplex.a);
  const FormBounds bounds(simplex.bounds);
  LazyExactForms<N> exact(tensors);
  MinorCoefficients<N> r;
  r.exponent = 2 * simplex.exponent;
  for (std::size_t n = 0; n < r.values.size(); ++n) {
    decide(r, n, simplex.bounds.usable(), f.p[n], bounds.p_error, kMinorDivisor,
           [&] { return exact().p[n]; });
  }
  return r;
}

template <int N>
DetCoefficients<N> det_coefficients(const std::array<Tensor<double>, N>& tensors) {
  const ScaledSimplex<N> simplex(tensors);
  const Forms<double, N> f = forms_of<double, N>(simplex.a);
  const FormBounds bounds(simplex.bounds);
  LazyExactForms<N> exact(tensors);
  DetCoefficients<N> r;
  r.exponent = 3 * simplex.exponent;
  for (std::size_t n = 0; n < r.values.size(); ++n) {
    decide(r, n, simplex.bounds.usable(), f.q[n], bounds.q_error, kDetDivisor,
           [&] { return exact().q[n]; });
  }
  return r;
}

// The bound of the filter. Let P, Q bound the computed forms and e_P, e_Q their errors. A Bernstein
// coefficient of P^3 is an average, with multinomial weights, of products P_a P_b P_c; so
//   data:     2 ((P + e_P)^3 - P^3) + 3 ((Q + e_Q)^2 - Q^2) <= 6 (P + e_P)^2 e_P + 6 (Q + e_Q) e_Q
//   rounding: weights 1, 2 are exact; a product and at most 10 terms in P^2; the same in P^3;
//             the factor 2 is exact: 20 roundings. Weights 3 and 6 of q: 1 on either side, a
//             product, at most 20 terms, the factor 3: 23. The last sum: at most 24 in all,
//             gamma(24) (2 P^3 + 3 Q^2).
// Multiplied by the multinomial, as the sums are. Underflow is far below e_P^3 >= 2^-800.
template <int N>
DiscriminantCoefficients<N> discriminant_coefficients(
    const std::array<Tensor<double>, N>& tensors) {
  static constexpr auto kWeight6 = kMonomials<N, 6>.multinomial;
  const ScaledSimplex<N> simplex(tensors);
  const Forms<double, N> f = forms_of<double, N>(simplex.a);
  const FormBounds bounds(simplex.bounds);
  double p = 0;
  double q = 0;
  for (const double x : f.p) p = std::fmax(p, std::fabs(x));
  for (const double x : f.q) q = std::fmax(q, std::fabs(x));
  const double p_high = p + bounds.p_error;
  const double q_high = q + bounds.q_error;
  const double error =
      (6 * p_high * p_high * bounds.p_error + 6 * q_high * bounds.q_error) * (1 + 0x1p-20) +
      gamma(24) * (2 * p * p * p + 3 * q * q);

  const auto sextic = minus_discriminant<double, N>(f);
  LazyExactForms<N> exact(tensors);
  std::optional<std::array<Exact, kBernsteinCoefficients<N, 6>>> exact_sextic;
  DiscriminantCoefficients<N> r;
  r.exponent = 6 * simplex.exponent;
  for (std::size_t n = 0; n < r.values.size(); ++n) {
    decide(r, n, simplex.bounds.usable(), -sextic[n], kWeight6[n] * error,
           kWeight6[n] * kDiscriminantDivisor, [&] {
             if (!exact_sextic) exact_sextic = minus_discriminant<Exact, N>(exact());
             return -(*exact_sextic)[n];
           });
  }
  return r;
}

template MinorCoefficients<1> minor_coefficients<1>(const std::array<Tensor<double>, 1>&);
template MinorCoefficients<2> minor_coefficients<2>(const std::array<Tensor<double>, 2>&);
template MinorCoefficients<3> minor_coefficients<3>(const std::array<Tensor<double>, 3>&);
template MinorCoefficients<4> minor_coefficients<4>(const std::array<Tensor<double>, 4>&);
template DetCoefficients<1> det_coefficients<1>(const std::array<Tensor<double>, 1>&);
template DetCoefficients<2> det_coefficients<2>(const std::array<Tensor<double>, 2>&);
template DetCoefficients<3> det_coefficients<3>(const std::array<Tensor<double>, 3>&);
template DetCoefficients<4> det_coefficients<4>(const std::array<Tensor<double>, 4>&);
template DiscriminantCoefficients<1> discriminant_coefficients<1>(
    const std::array<Tensor<double>, 1>&);
template DiscriminantCoefficients<2> discriminant_coefficients<2>(
    const std::array<Tensor<double>, 2>&);
template DiscriminantCoefficients<3> discriminant_coefficients<3>(
    const std::array<Tensor<double>, 3>&);
template DiscriminantCoefficients<4> discriminant_coefficients<4>(
    const std::array<Tensor<double>, 4>&);

}  // namespace triplex

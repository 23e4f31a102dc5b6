// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/vertex.hpp"

#include "triplex/certify/simplex.hpp"

namespace triplex {
namespace {

/// 4 D = -(2 P^3 + 3 Q^2); the sign of D as one rung sees it.
/// Error of the doubles: with |dP| <= a, |dQ| <= b the value moves by at most
/// 2 (3 P^2 a + 3 |P| a^2 + a^3) + 3 (2 |Q| b + b^2); its 6 roundings add gamma(6) (2 |P|^3 + 3
/// Q^2).
double discriminant_error(double P, double Q, const FormBounds& bounds) {
  const double p = std::fabs(P), a = bounds.p_error, q = std::fabs(Q), b = bounds.q_error;
  constexpr double kSlack = 1 + 0x1p-20;  // the roundings of this very line
  return kSlack * (2 * a * (3 * p * p + 3 * p * a + a * a) + 3 * b * (2 * q + b) +
                   gamma(6) * (2 * p * p * p + 3 * q * q));
}
template <class NT>
double discriminant_error(const NT&, const NT&, const FormBounds&) {
  return 0;
}

template <class NT>
Certainty discriminant(const NT& P, const NT& Q, const FormBounds& bounds) {
  const NT minus_4d = NT(2) * P * P * P + NT(3) * Q * Q;
  return certainty(-minus_4d, discriminant_error(P, Q, bounds));
}

Verdict to_verdict(Certainty c) {
  return c == Certainty::Positive   ? Verdict::Yes
         : c == Certainty::Negative ? Verdict::No
                                    : Verdict::Unknown;
}

/// A sign of the perturbed field, or nothing if all its coefficients in eps vanish.
template <class Quantity>
std::optional<bool> is_positive(const Simplex<1>& vertex, const Quantity& quantity,
                                SignStages& stages) {
  const auto test = [&](bool positive) {
    return [&quantity, positive](const auto& f, const FormBounds& bounds) {
      const Certainty c = quantity(f.p[0], f.q[0], bounds);
      return to_verdict(positive ? c : static_cast<Certainty>(-static_cast<int>(c)));
    };
  };
  if (vertex.decide(test(true), stages)) return true;
  SignStages not_counted_twice;
  if (vertex.decide(test(false), not_counted_twice)) return false;
  return std::nullopt;
}

}  // namespace

std::optional<Sector> sector_at(const RefinableField& field, VertexId v, SignStages& stages) {
  const Simplex<1> vertex(field, {v});
  const auto p = is_positive(
      vertex,
      [](const auto& P, const auto&, const FormBounds& b) { return certainty(P, b.p_error); },
      stages);
  const auto q = is_positive(
      vertex,
      [](const auto&, const auto& Q, const FormBounds& b) { return certainty(Q, b.q_error); },
      stages);
  if (!p || !q) return std::nullopt;
  if (*p) return *q ? Sector::InnerComplexLinear : Sector::InnerComplexPlanar;

  const auto real = is_positive(
      vertex,
      [](const auto& P, const auto& Q, const FormBounds& b) { return discriminant(P, Q, b); },
      stages);
  if (!real) return std::nullopt;
  if (*q) return *real ? Sector::RealLinear : Sector::OuterComplexLinear;
  return *real ? Sector::RealPlanar : Sector::OuterComplexPlanar;
}

}  // namespace triplex

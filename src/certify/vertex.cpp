// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/vertex.hpp"

#include "triplex/certify/mode_page.hpp"
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
struct IsPositive {
  const Quantity& quantity;
  bool positive;
  template <class NT>
  Verdict operator()(const Forms<NT, 1>& f, const FormBounds& bounds) const {
    const Certainty c = quantity(f.p[0], f.q[0], bounds);
    return to_verdict(positive ? c : static_cast<Certainty>(-static_cast<int>(c)));
  }
};
template <class Quantity>
std::optional<bool> is_positive(const Simplex<1>& vertex, const Quantity& quantity,
                                SignStages& stages, const ModeMap& map = {}) {
  using Test = Mapped<IsPositive<Quantity>>;
  if (vertex.decide(Test{map, {quantity, true}}, stages)) return true;
  SignStages not_counted_twice;
  if (vertex.decide(Test{map, {quantity, false}}, not_counted_twice)) return false;
  return std::nullopt;
}

/// The sector from the signs of p and q, which name a quadrant, and the side of its curved pages:
/// `below_page(map)` says whether D of the mapped forms is positive, the mode less than the page's.
/// Counter-clockwise the mode rises where p and q have one sign and falls elsewhere.
template <class BelowPage>
std::optional<Sector> locate(const FeatureTable& table, bool p, bool q,
                             const BelowPage& below_page) {
  // The quadrant lies between two of the four flat pages; its sectors begin at the first.
  const int first = p ? (q ? 0 : table.position(Feature::BalancedPlanar))
                      : table.position(q ? Feature::BalancedLinear : Feature::NeutralReal);
  const int last = p ? (q ? table.position(Feature::BalancedLinear) : table.page_count())
                     : table.position(q ? Feature::NeutralReal : Feature::BalancedPlanar);
  int passed = 0;
  for (int k = first + 1; k < last; ++k) {
    const std::optional<bool> below = below_page(table.sheet(table.page(k)).map);
    if (!below) return std::nullopt;
    passed += *below != (p == q);
  }
  return static_cast<Sector>(first + passed);
}

}  // namespace

std::optional<Sector> sector_at(const RefinableField& field, VertexId v, const FeatureTable& table,
                                SignStages& stages) {
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
  return locate(table, *p, *q, [&](const ModeMap& map) {
    return is_positive(
        vertex,
        [](const auto& P, const auto& Q, const FormBounds& b) { return discriminant(P, Q, b); },
        stages, map);
  });
}

Sector sector_approx(const RefinableField& field, VertexId v, const FeatureTable& table) {
  const Simplex<1> vertex(field, {v});
  const double p = vertex.approximate().p[0], q = vertex.approximate().q[0];
  const auto sector = locate(table, p >= 0, q >= 0, [&](const ModeMap& map) {
    const double P = map.p_factor * p, Q = map.q_factor * q;
    return std::optional<bool>(2 * P * P * P + 3 * Q * Q < 0);
  });
  return *sector;
}

VanishingInvariants vanishing_at(const RefinableField& field, VertexId v) {
  const Simplex<1> vertex(field, {v});
  VanishingInvariants zero;
  // Unknown: of a double, too near to zero to tell; of an exact number, zero.
  const auto narrow = [&](const auto& forms) {
    const auto &P = forms.p[0], &Q = forms.q[0];
    const FormBounds& bounds = vertex.bounds();
    zero.p = zero.p && certainty(P, bounds.p_error) == Certainty::Unknown;
    zero.q = zero.q && certainty(Q, bounds.q_error) == Certainty::Unknown;
    zero.discriminant = zero.discriminant && discriminant(P, Q, bounds) == Certainty::Unknown;
  };
  if (vertex.filter_usable()) narrow(vertex.approximate());
  if (zero.p || zero.q || zero.discriminant) narrow(forms_of<Exact, 1>(vertex.exact_tensors()));
  return zero;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/edge_side.hpp"

#include "triplex/certify/simplex.hpp"

namespace triplex {
namespace {

Certainty operator*(Certainty a, Certainty b) {
  return static_cast<Certainty>(static_cast<int>(a) * static_cast<int>(b));
}

/// In x = t / (1 - t), P = a x^2 + b x + c has one positive root x*, and a^2 Q = alpha x + beta
/// modulo P. If alpha and beta differ in sign, then x0 = -beta / alpha > 0 is compared with x*:
/// x* > x0 exactly if P(x0) has the sign of c, and alpha^2 P(x0) = a beta^2 - b alpha beta + c
/// alpha^2.
template <class NT>
Certainty sign_by_remainder(const Forms<NT, 2>& f) {
  const NT& a = f.P(1, 1);
  const NT b = NT(2) * f.P(0, 1);
  const NT& c = f.P(0, 0);
  const NT& k3 = f.Q(1, 1, 1);
  const NT k2 = NT(3) * f.Q(0, 1, 1);
  const NT k1 = NT(3) * f.Q(0, 0, 1);
  const NT& k0 = f.Q(0, 0, 0);
  const NT alpha = k3 * (b * b - a * c) - k2 * a * b + k1 * a * a;
  const NT beta = k3 * b * c - k2 * a * c + k0 * a * a;
  const Certainty sa = certainty(alpha, 0);
  const Certainty sb = certainty(beta, 0);
  if (sa == Certainty::Unknown) {
    // An exact zero of alpha leaves beta; for intervals nothing is known.
    return Certainty::Unknown;
  }
  if (sb == sa) return sa;
  if (sb == Certainty::Unknown) return Certainty::Unknown;
  const NT at_x0 = a * beta * beta - b * alpha * beta + c * alpha * alpha;
  return certainty(at_x0, 0) * certainty(c, 0) * sa;
}

struct SideTest {
  Certainty wanted;

  Verdict operator()(const Forms<double, 2>& f, const FormBounds& bounds) const {
    // The filter: all coefficients of Q on one side.
    Certainty side = certainty(f.q[0], bounds.q_error);
    for (const double q : f.q) {
      if (certainty(q, bounds.q_error) != side) return Verdict::Unknown;
    }
    return verdict(side);
  }
  template <class NT>
  Verdict operator()(const Forms<NT, 2>& f, const FormBounds&) const {
    return verdict(sign_by_remainder(f));
  }
  Verdict verdict(Certainty side) const {
    return side == Certainty::Unknown ? Verdict::Unknown
           : side == wanted           ? Verdict::Yes
                                      : Verdict::No;
  }
};

}  // namespace

std::optional<Sign> q_at_root_of_p(const RefinableField& field, VertexId a, VertexId b,
                                   SignStages& stages) {
  const Simplex<2> edge(field, {std::min(a, b), std::max(a, b)});
  if (edge.decide(SideTest{Certainty::Positive}, stages)) return Sign::Positive;
  SignStages not_counted_twice;
  if (edge.decide(SideTest{Certainty::Negative}, not_counted_twice)) return Sign::Negative;
  return std::nullopt;
}

std::optional<int> rotation_along(const RefinableField& field, VertexId a, VertexId b,
                                  Sector sector_a, Sector sector_b, const FeatureTable& table,
                                  SignStages& stages) {
  const int i = index(sector_a);
  const int j = index(sector_b);
  if (i == j) return 0;
  const Sign p_a = table.sign_p(sector_a);
  Sign side = Sign::Positive;  // where p keeps its positive sign, counting as through q > 0 serves
  if (p_a == table.sign_p(sector_b)) {
    if (p_a == Sign::Negative) return j - i;
  } else {
    side = table.sign_q(sector_a);
    if (side != table.sign_q(sector_b)) {
      const auto decided = q_at_root_of_p(field, a, b, stages);
      if (!decided) return std::nullopt;
      side = *decided;
    }
  }
  // Through q > 0 the sectors of p > 0, q < 0 count from below zero; through q < 0 those of p > 0,
  // q > 0 count beyond the others.
  const int pages = table.page_count();
  const auto unrolled = [&](int sector) {
    if (side == Sign::Positive)
      return sector >= table.position(Feature::BalancedPlanar) ? sector - pages : sector;
    return sector < table.position(Feature::BalancedLinear) ? sector + pages : sector;
  };
  return unrolled(j) - unrolled(i);
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/exclusion.hpp"

#include <algorithm>
#include <cmath>

#include "error_bounds.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/mode_page.hpp"
#include "triplex/certify/witness.hpp"

namespace triplex {
namespace {

Certainty flip(Certainty c) { return static_cast<Certainty>(-static_cast<int>(c)); }
Certainty oriented(Certainty c, Sign s) { return s == Sign::Negative ? flip(c) : c; }

/// A control point of the curve (p, q): p raised to degree three, kept as R = 3 P_ijk.
template <class NT, int N>
NT tripled_p(const Forms<NT, N>& f, const std::array<int, 3>& t) {
  return f.P(t[0], t[1]) + f.P(t[1], t[2]) + f.P(t[0], t[2]);
}
/// Three errors of P, plus two roundings of a sum below 3 |P|.
double tripled_p_error(const FormBounds& b) { return 3 * b.p_error + gamma(3) * 3 * b.p_magnitude; }

/// All coefficients of p (of q) have sign s.
struct UniformP {
  Sign s;
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    AllPositive all;
    for (const NT& p : f.p)
      if (!all.add(oriented(certainty(p, bounds.p_error), s))) break;
    return all.verdict();
  }
};
struct UniformQ {
  Sign s;
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    AllPositive all;
    for (const NT& q : f.q)
      if (!all.add(oriented(certainty(q, bounds.q_error), s))) break;
    return all.verdict();
  }
};

/// Above the page's curve, for s = +1: Q > 0, and R > 0 or 2 R^3 + 81 Q^2 > 0 (with P = R / 3 this
/// is 27 (2 P^3 + 3 Q^2) = -108 D > 0).
struct BeyondCurve {
  Sign s;

  static double sextic_error(double r, double q, const FormBounds& b) {
    const double R = std::fabs(r), dr = tripled_p_error(b), Q = std::fabs(q), dq = b.q_error;
    constexpr double kSlack = 1 + 0x1p-20;
    return kSlack * (2 * dr * (3 * R * R + 3 * R * dr + dr * dr) + 81 * dq * (2 * Q + dq) +
                     gamma(6) * (2 * R * R * R + 81 * Q * Q));
  }
  template <class NT>
  static double sextic_error(const NT&, const NT&, const FormBounds&) {
    return 0;
  }

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    AllPositive all;
    for (int n = 0; n < kTriples<N>; ++n) {
      const NT& Q = f.q[n];
      if (!all.add(oriented(certainty(Q, bounds.q_error), s))) break;
      const NT R = tripled_p(f, triples<N>()[n]);
      if (certainty(R, tripled_p_error(bounds)) == Certainty::Positive) continue;
      // For R >= 0 and Q != 0 the sextic is positive too, so an unknown R needs no case.
      const NT sextic = NT(2) * R * R * R + NT(81) * Q * Q;
      if (!all.add(certainty(sextic, sextic_error(R, Q, bounds)))) break;
    }
    return all.verdict();
  }
};

/// On the inner side of the tangent at P = -6 v^2, for s = +1: Q + v R + 6 v^3 < 0. The curve is
/// convex (as the graph of q over p), so the page lies on the other side of every tangent or on it.
struct InsideTangent {
  Sign s;
  double v;

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    const NT V(v);
    const NT offset = NT(6) * V * V * V;
    // Errors of Q and v R; then at most 3 roundings of the sum and 4 of the offset.
    const double error =
        bounds.q_error + v * tripled_p_error(bounds) +
        gamma(6) * (bounds.q_magnitude + 3 * v * bounds.p_magnitude + 6 * v * v * v);
    AllPositive all;
    for (int n = 0; n < kTriples<N>; ++n) {
      const NT Q = s == Sign::Positive ? f.q[n] : -f.q[n];
      const NT value = Q + V * tripled_p(f, triples<N>()[n]) + offset;
      if (!all.add(flip(certainty(value, error)))) break;
    }
    return all.verdict();
  }
};

/// The tangent that leaves most room, for the doubles: the largest slack over the control points is
/// convex in v, so its minimum is bisected, from the tangent at the mean of p on; stops at the
/// first v that serves.
template <int N>
double best_tangent(const Forms<double, N>& f, Sign s) {
  std::array<double, kTriples<N>> q, r;
  double lowest = 0, sum = 0;
  for (int n = 0; n < kTriples<N>; ++n) {
    q[n] = s == Sign::Positive ? f.q[n] : -f.q[n];
    r[n] = tripled_p(f, triples<N>()[n]);
    lowest = std::min(lowest, r[n]);
    sum += r[n];
  }
  double low = 0, high = std::sqrt(-lowest / 18);
  double v = few_bits(std::sqrt(std::max(0.0, -sum / (18 * kTriples<N>))));
  const auto worst = [&](double at, double& slope) {
    double value = -INFINITY;
    for (int n = 0; n < kTriples<N>; ++n) {
      const double x = q[n] + at * r[n];
      if (x > value) {
        value = x;
        slope = r[n] + 18 * at * at;
      }
    }
    return value + 6 * at * at * at;
  };
  constexpr int kSteps = 12;  // a quality limit only
  for (int step = 0; step < kSteps; ++step) {
    double slope = 0;
    if (worst(v, slope) < 0) break;
    (slope > 0 ? high : low) = v;
    v = few_bits((low + high) / 2);
  }
  return v;
}

/// All coefficients of D have sign s.
struct UniformDiscriminant {
  Sign s;

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    const double error = discriminant_coefficient_error(bounds);
    const auto minus_d = minus_discriminant(f);
    AllPositive all;
    for (std::size_t n = 0; n < minus_d.size(); ++n) {
      const Certainty c = certainty(minus_d[n], kMonomials<N, 6>.multinomial[n] * error);
      if (!all.add(oriented(flip(c), s))) break;
    }
    return all.verdict();
  }
};

/// a R_ijk + b Q_ijk > 0 for all control points.
struct InHalfPlane {
  double a, b;
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    const double error =
        std::fabs(a) * tripled_p_error(bounds) + std::fabs(b) * bounds.q_error +
        gamma(4) * (3 * std::fabs(a) * bounds.p_magnitude + std::fabs(b) * bounds.q_magnitude);
    AllPositive all;
    for (int n = 0; n < kTriples<N>; ++n) {
      const NT value = NT(a) * tripled_p(f, triples<N>()[n]) + NT(b) * f.q[n];
      if (!all.add(certainty(value, error))) break;
    }
    return all.verdict();
  }
};

/// Asks for the sign of the largest coefficient; for the other one only if that sign was in doubt.
template <class Test, int N, std::size_t Count>
Sign uniform_sign(const Simplex<N>& simplex, const std::array<double, Count>& coefficients,
                  double error, SignStages& stages) {
  double largest = 0;
  for (const double c : coefficients)
    if (std::fabs(c) > std::fabs(largest)) largest = c;
  const Sign likely = largest < 0 ? Sign::Negative : Sign::Positive;
  if (simplex.decide(Test{likely}, stages)) return likely;
  if (simplex.filter_usable() && std::fabs(largest) > error) return Sign::Zero;
  return simplex.decide(Test{-likely}, stages) ? -likely : Sign::Zero;
}

}  // namespace

template <int N>
Sign uniform_sign_of_p(const Simplex<N>& simplex, SignStages& stages) {
  return uniform_sign<UniformP>(simplex, simplex.approximate().p, simplex.bounds().p_error, stages);
}
template <int N>
Sign uniform_sign_of_q(const Simplex<N>& simplex, SignStages& stages) {
  return uniform_sign<UniformQ>(simplex, simplex.approximate().q, simplex.bounds().q_error, stages);
}

template <int N>
bool excludes_page(const Simplex<N>& simplex, const Sheet& sheet, SignStages& stages) {
  const Sign s = sheet.sign_q;
  // The sign of q at a corner says which of the two can hold at all.
  const double q = simplex.approximate().q[0];
  if ((s == Sign::Positive ? q : -q) > 0 &&
      simplex.decide(Mapped<BeyondCurve>{sheet.map, {s}}, stages))
    return true;
  const double v = with_mapped_doubles(
      simplex, sheet.map, [s](const auto& f, const FormBounds&) { return best_tangent(f, s); });
  return simplex.decide(Mapped<InsideTangent>{sheet.map, {s, v}}, stages);
}

template <int N>
Sign uniform_sign_of_discriminant(const Simplex<N>& simplex, const ModeMap& map,
                                  SignStages& stages) {
  const Sign likely = with_mapped_doubles(simplex, map, [](const auto& f, const FormBounds&) {
    const double corner = -(2 * f.p[0] * f.p[0] * f.p[0] + 3 * f.q[0] * f.q[0]);
    return corner < 0 ? Sign::Negative : Sign::Positive;
  });
  return simplex.decide(Mapped<UniformDiscriminant>{map, {likely}}, stages) ? likely : Sign::Zero;
}

template <int N>
bool excludes_spine(const Simplex<N>& simplex, SignStages& stages) {
  const auto& f = simplex.approximate();
  double size_r = 0, size_q = 0;
  for (int n = 0; n < kTriples<N>; ++n) {
    size_r = std::max(size_r, std::fabs(tripled_p(f, triples<N>()[n])));
    size_q = std::max(size_q, std::fabs(f.q[n]));
  }
  const double weight_r = size_r > 0 ? std::exp2(-std::ilogb(size_r)) : 1;
  const double weight_q = size_q > 0 ? std::exp2(-std::ilogb(size_q)) : 1;
  std::array<std::array<double, 3>, kTriples<N>> control;
  for (int n = 0; n < kTriples<N>; ++n)
    control[n] = {tripled_p(f, triples<N>()[n]) * weight_r, f.q[n] * weight_q, 0};
  const auto d = separating_direction(control);
  if (d[0] == 0 && d[1] == 0) return false;
  return simplex.decide(InHalfPlane{d[0] * weight_r, d[1] * weight_q}, stages);
}

#define TRIPLEX_INSTANTIATE(N)                                                                   \
  template Sign uniform_sign_of_p<N>(const Simplex<N>&, SignStages&);                            \
  template Sign uniform_sign_of_q<N>(const Simplex<N>&, SignStages&);                            \
  template bool excludes_page<N>(const Simplex<N>&, const Sheet&, SignStages&);                  \
  template Sign uniform_sign_of_discriminant<N>(const Simplex<N>&, const ModeMap&, SignStages&); \
  template bool excludes_spine<N>(const Simplex<N>&, SignStages&);
TRIPLEX_INSTANTIATE(2)
TRIPLEX_INSTANTIATE(3)
TRIPLEX_INSTANTIATE(4)
#undef TRIPLEX_INSTANTIATE

}  // namespace triplex

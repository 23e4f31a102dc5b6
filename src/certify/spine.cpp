// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/spine.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "triplex/certify/witness.hpp"

namespace triplex {
namespace {

/// Coefficient ij of the Jacobian of (p, q) on a triangle, rows up to positive factors.
template <class NT>
std::array<NT, 4> jacobian(const Forms<NT, 3>& f, int i, int j) {
  const auto p = [&](int a) { return (f.P(i, a) - f.P(i, 0)) + (f.P(j, a) - f.P(j, 0)); };
  const auto q = [&](int a) { return f.Q(i, j, a) - f.Q(i, j, 0); };
  return {p(1), p(2), q(1), q(2)};
}

/// m11 > 0 and 4 m11 m22 - (m12 + m21)^2 > 0 for M = C J_ij, all six coefficients.
struct PositiveDefinite {
  std::array<double, 4> c;

  template <class NT>
  Verdict operator()(const Forms<NT, 3>& f, const FormBounds& bounds) const {
    // An entry of M is c_1 (4 values P) + c_2 (2 values Q): 2 + 1 + 1 roundings at most. With
    // entries below m and errors below e the determinant moves by at most 4 (2 m e + e^2) + 4 (2 m
    // e + e^2) and its own 5 roundings act on at most 4 m^2 + 4 m^2.
    const double c1 = std::max(std::fabs(c[0]), std::fabs(c[2]));
    const double c2 = std::max(std::fabs(c[1]), std::fabs(c[3]));
    constexpr double kSlack = 1 + 0x1p-20;
    const double m = (c1 * 4 * bounds.p_magnitude + c2 * 2 * bounds.q_magnitude) * kSlack;
    const double e = (c1 * 4 * bounds.p_error + c2 * 2 * bounds.q_error) * kSlack + gamma(5) * m;
    const double determinant_error = (8 * (2 * m * e + e * e) + gamma(6) * 8 * m * m) * kSlack;

    const std::array<NT, 4> C = {NT(c[0]), NT(c[1]), NT(c[2]), NT(c[3])};
    AllPositive all;
    for (const auto& [i, j] : pairs<3>()) {
      const auto J = jacobian(f, i, j);
      const NT m11 = C[0] * J[0] + C[1] * J[2];
      const NT m12 = C[0] * J[1] + C[1] * J[3];
      const NT m21 = C[2] * J[0] + C[3] * J[2];
      const NT m22 = C[2] * J[1] + C[3] * J[3];
      if (!all.add(certainty(m11, e))) break;
      const NT determinant = NT(4) * m11 * m22 - (m12 + m21) * (m12 + m21);
      if (!all.add(certainty(determinant, determinant_error))) break;
    }
    return all.verdict();
  }
};

template <class NT>
using Vector = std::array<NT, 3>;

template <class NT>
Vector<NT> p_gradient(const Forms<NT, 4>& f, int i) {
  return {f.P(i, 1) - f.P(i, 0), f.P(i, 2) - f.P(i, 0), f.P(i, 3) - f.P(i, 0)};
}
template <class NT>
Vector<NT> q_gradient(const Forms<NT, 4>& f, int i, int j) {
  return {f.Q(i, j, 1) - f.Q(i, j, 0), f.Q(i, j, 2) - f.Q(i, j, 0), f.Q(i, j, 3) - f.Q(i, j, 0)};
}
template <class NT>
void add_cross(Vector<NT>& sum, const Vector<NT>& a, const Vector<NT>& b) {
  sum[0] = sum[0] + (a[1] * b[2] - a[2] * b[1]);
  sum[1] = sum[1] + (a[2] * b[0] - a[0] * b[2]);
  sum[2] = sum[2] + (a[0] * b[1] - a[1] * b[0]);
}
/// Bernstein coefficient ijk of grad p x grad q, up to a positive factor.
template <class NT>
Vector<NT> tangent(const Forms<NT, 4>& f, const std::array<int, 3>& t) {
  Vector<NT> sum{NT(0), NT(0), NT(0)};
  add_cross(sum, p_gradient(f, t[0]), q_gradient(f, t[1], t[2]));
  add_cross(sum, p_gradient(f, t[1]), q_gradient(f, t[0], t[2]));
  add_cross(sum, p_gradient(f, t[2]), q_gradient(f, t[0], t[1]));
  return sum;
}

struct TangentAdvances {
  std::array<double, 3> d;
  template <class NT>
  Verdict operator()(const Forms<NT, 4>& f, const FormBounds& bounds) const {
    // Differences: |dP| <= 2 |P| with error 2 e_P + one rounding, likewise Q. A component is three
    // times two products; the deepest term takes 1 + 1 + 3 roundings, the dot product 3 more.
    const double p = 2 * bounds.p_magnitude * (1 + 0x1p-20);
    const double q = 2 * bounds.q_magnitude * (1 + 0x1p-20);
    const double dp = 2 * bounds.p_error + gamma(2) * p;
    const double dq = 2 * bounds.q_error + gamma(2) * q;
    const double norm = std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]);
    const double error =
        norm * 6 * (p * dq + q * dp + dp * dq + gamma(9) * (p + dp) * (q + dq)) * (1 + 0x1p-20);
    const Vector<NT> D{NT(d[0]), NT(d[1]), NT(d[2])};
    AllPositive all;
    for (const auto& t : triples<4>()) {
      const auto c = tangent(f, t);
      const NT value = D[0] * c[0] + D[1] * c[1] + D[2] * c[2];
      if (!all.add(certainty(value, error))) break;
    }
    return all.verdict();
  }
};

/// The witness: the inverse of the mean Jacobian, if it has one.
std::optional<std::array<double, 4>> inverse_mean_jacobian(const Forms<double, 3>& f) {
  std::array<double, 4> mean{};
  for (const auto& [i, j] : pairs<3>()) {
    const auto J = jacobian(f, i, j);
    for (int k = 0; k < 4; ++k) mean[k] += J[k] / 6;
  }
  const double determinant = mean[0] * mean[3] - mean[1] * mean[2];
  if (determinant == 0 || !std::isfinite(1 / determinant)) return std::nullopt;
  std::array<double, 4> c = {mean[3] / determinant, -mean[1] / determinant, -mean[2] / determinant,
                             mean[0] / determinant};
  for (double& x : c) x = few_bits(x);
  return c;
}

}  // namespace

bool certifies_injective(const Simplex<3>& face, SignStages& stages) {
  const auto c = inverse_mean_jacobian(face.approximate());
  return c && face.decide(PositiveDefinite{*c}, stages);
}

bool certifies_injective(const Forms<Interval, 3>& forms) {
  Forms<double, 3> lower;
  for (std::size_t n = 0; n < forms.p.size(); ++n) lower.p[n] = forms.p[n].inf();
  for (std::size_t n = 0; n < forms.q.size(); ++n) lower.q[n] = forms.q[n].inf();
  const auto c = inverse_mean_jacobian(lower);
  return c && PositiveDefinite{*c}(forms, FormBounds()) == Verdict::Yes;
}

bool certifies_monotone_spine(const Simplex<4>& cell, SignStages& stages) {
  std::array<std::array<double, 3>, kTriples<4>> tangents;
  for (int n = 0; n < kTriples<4>; ++n) tangents[n] = tangent(cell.approximate(), triples<4>()[n]);
  const auto d = separating_direction(tangents);
  if (d[0] == 0 && d[1] == 0 && d[2] == 0) return false;
  return cell.decide(TangentAdvances{d}, stages);
}

}  // namespace triplex

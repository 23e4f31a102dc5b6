// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/mode_order.hpp"

#include "sign_changes.hpp"
#include "triplex/certify/mode_page.hpp"

namespace triplex {
namespace {

/// Q (-P)^(-3/2) has the derivative (-P)^(-5/2) W / 2 with W = 3 Q P' - 2 Q' P, of degree four.
struct MonotoneMode {
  template <class NT>
  Verdict operator()(const Forms<NT, 2>& f, const FormBounds& bounds) const {
    LayerSign q;
    for (const NT& x : f.q) q.add(certainty(x, bounds.q_error));
    SignChanges p;
    for (const NT& x : f.p) p.add(certainty(x, bounds.p_error));
    LayerSign w;
    const double error = error_of_w(bounds);
    for (const NT& x : coefficients_of_w(f)) w.add(certainty(x, error));

    if (q.is_mixed() || w.is_mixed() || p.at_most_one() == Verdict::No) return Verdict::No;
    const bool known = !q.has_unknown() && !w.has_unknown() && p.at_most_one() == Verdict::Yes;
    return known ? Verdict::Yes : Verdict::Unknown;
  }

  /// W / 6 by powers of t and 1 - t: Q and P' / 2, Q' / 3 and P times their binomials.
  template <class NT>
  static std::array<NT, 5> coefficients_of_w(const Forms<NT, 2>& f) {
    const std::array<NT, 2> dp = {f.p[1] - f.p[0], f.p[2] - f.p[1]};
    const std::array<NT, 3> dq = {f.q[1] - f.q[0], NT(2) * (f.q[2] - f.q[1]), f.q[3] - f.q[2]};
    const std::array<NT, 3> p = {f.p[0], NT(2) * f.p[1], f.p[2]};
    const std::array<NT, 4> q = {f.q[0], NT(3) * f.q[1], NT(3) * f.q[2], f.q[3]};
    std::array<NT, 5> w;
    for (NT& x : w) x = NT(0);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 2; ++j) w[i + j] = w[i + j] + q[i] * dp[j];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) w[i + j] = w[i + j] - dq[i] * p[j];
    return w;
  }
  /// A coefficient sums products of a P and a Q, with weights of at most C(4, 2) (1 + 1) in Q dP
  /// and as many in dQ P. Roundings on one of them: difference, binomials and product 1 + 2 + 1,
  /// sums 5.
  static double error_of_w(const FormBounds& b) {
    constexpr double kWeights = 2 * 6 * 2;
    const double p = b.p_magnitude, dp = b.p_error, q = b.q_magnitude, dq = b.q_error;
    return kWeights * (p * dq + q * dp + dp * dq + gamma(9) * p * q) * (1 + 0x1p-20);
  }
};

}  // namespace

bool certifies_monotone_mode(const Simplex<2>& edge, const Sheet& sheet, SignStages& stages) {
  return edge.decide(Mapped<MonotoneMode>{sheet.map, {}}, stages);
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/lanes.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {

/// Exclusion on the filter's rung, for W simplices at a time. The tests are those of exclusion.cpp,
/// the bounds too or larger ones: the proof is proofs/exclusion.md. A lane that a test leaves open
/// stays open.

template <int W>
using LaneBounds = FormBoundsOf<Lanes<W>>;

/// The signs that p and q keep on a simplex.
template <int W>
struct LaneSigns {
  LaneMask<W> p_positive, p_negative, q_positive, q_negative;
};

template <int W, int N>
LaneSigns<W> uniform_signs(const Forms<Lanes<W>, N>& f, const LaneBounds<W>& bounds) {
  Lanes<W> p_least = f.p[0], p_most = f.p[0], q_least = f.q[0], q_most = f.q[0];
  for (const auto& p : f.p) p_least = min(p_least, p), p_most = max(p_most, p);
  for (const auto& q : f.q) q_least = min(q_least, q), q_most = max(q_most, q);
  return {p_least > bounds.p_error, p_most<-bounds.p_error, q_least> bounds.q_error,
          q_most < -bounds.q_error};
}

/// Which degenerate pages miss a simplex.
template <int W>
struct LanePages {
  LaneMask<W> no_linear, no_planar;
};

/// All control points beyond the curve, for both pages at once: where q has one sign, |Q| stands
/// for s Q. One error for all coefficients, at the largest of them.
template <int W, int N>
LaneMask<W> beyond_curve(const Forms<Lanes<W>, N>& f,
                         const std::array<Lanes<W>, kTriples<N>>& tripled_p,
                         const LaneBounds<W>& b) {
  using L = Lanes<W>;
  const L dr = 3 * b.p_error + gamma(3) * 3 * b.p_magnitude;
  const L R = 3 * b.p_magnitude + dr, Q = b.q_magnitude, dq = b.q_error;
  constexpr double kSlack = 1 + 0x1p-20;
  const L error = kSlack * (2 * dr * (3 * R * R + 3 * R * dr + dr * dr) + 81 * dq * (2 * Q + dq) +
                            gamma(6) * (2 * R * R * R + 81 * Q * Q));
  L least(1.0), scale(0.0);
  for (int n = 0; n < kTriples<N>; ++n) {
    const L& r = tripled_p[n];
    const L sextic = 2 * r * r * r + 81 * f.q[n] * f.q[n];
    // Above the error or not is all that counts.
    least = select((r > dr) | (sextic > error), least, scale);
  }
  return least > scale;
}

/// The pages that miss a simplex: p > 0, q of the other sign, beyond the curve, or inside a
/// tangent.
template <int W, int N>
LanePages<W> absent_pages(const Forms<Lanes<W>, N>& f, const LaneBounds<W>& b,
                          const LaneSigns<W>& signs) {
  using L = Lanes<W>;
  LanePages<W> absent = {signs.p_positive | signs.q_negative, signs.p_positive | signs.q_positive};
  std::array<L, kTriples<N>> r;
  L lowest(0.0), sum(0.0);
  for (int n = 0; n < kTriples<N>; ++n) {
    const auto [i, j, k] = triples<N>()[n];
    r[n] = f.P(i, j) + f.P(j, k) + f.P(i, k);
    lowest = min(lowest, r[n]);
    sum = sum + r[n];
  }
  // Tangents: the one at the mean of p first, then by bisection for the page on q's side.
  L low(0.0), high = sqrt(-lowest * (1.0 / 18));
  L v = min(sqrt(max(L(0.0), -sum * (1.0 / (18 * kTriples<N>)))), high);
  const auto is_planar = f.q[0] < L(0.0);
  constexpr int kSteps = 5;
  for (int step = 0; step < kSteps; ++step) {
    const L offset = 6 * v * v * v;
    const L error = b.q_error + v * (3 * b.p_error + gamma(3) * 3 * b.p_magnitude) +
                    gamma(6) * (b.q_magnitude + 3 * v * b.p_magnitude + offset);
    L linear(-INFINITY), planar(-INFINITY), r_linear(0.0), r_planar(0.0);
    for (int n = 0; n < kTriples<N>; ++n) {
      const L vr = v * r[n], above = f.q[n] + vr, below = vr - f.q[n];
      r_linear = select(above > linear, r[n], r_linear);
      r_planar = select(below > planar, r[n], r_planar);
      linear = max(linear, above);
      planar = max(planar, below);
    }
    absent.no_linear = absent.no_linear | (linear + offset < -error);
    absent.no_planar = absent.no_planar | (planar + offset < -error);
    if (all(absent.no_linear & absent.no_planar)) return absent;
    if (step == 0) {
      const auto beyond = beyond_curve<W, N>(f, r, b);
      absent.no_linear = absent.no_linear | (signs.q_positive & beyond);
      absent.no_planar = absent.no_planar | (signs.q_negative & beyond);
      if (all(absent.no_linear & absent.no_planar)) return absent;
    }
    const auto too_high = select(is_planar, r_planar, r_linear) + 18 * v * v > L(0.0);
    high = select(too_high, v, high);
    low = select(too_high, low, v);
    v = (low + high) * 0.5;
  }
  return absent;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sweep_exclusion.hpp"

namespace triplex {

/// The sheets of the standard pages.
enum class SweptSheet : std::uint8_t { Balanced, Neutral, DegenerateLinear, DegeneratePlanar };
inline constexpr int kSweptSheets = 4;

/// A sheet as the sweep sees it: derivatives of Q + 3 s v P at both ends of a range of v that holds
/// on the whole tet (degenerate sheets), of Q (neutral), of P (balanced).
template <int W>
struct LaneSheet {
  SweptSheet sheet;
  std::array<Lanes<W>, 2> sv{Lanes<W>(0.0), Lanes<W>(0.0)};
  Lanes<W> unit_error;  ///< of d . grad at one coefficient, for a direction of one-norm one

  bool degenerate() const { return sheet != SweptSheet::Balanced && sheet != SweptSheet::Neutral; }
};

/// The sheet and the lanes in which its range of v is certain. Bounds and errors as in graph.cpp.
template <int W>
LaneMask<W> prepare_sheet(const Forms<Lanes<W>, 4>& f, const LaneBounds<W>& b,
                          LaneSheet<W>& sheet) {
  using L = Lanes<W>;
  constexpr double kSlack = 1 + 0x1p-20;
  const auto everywhere = L(0.0) <= L(0.0);
  if (sheet.sheet == SweptSheet::Balanced) {
    sheet.unit_error = (2 * b.p_error + gamma(5) * 2 * b.p_magnitude) * kSlack;
    return everywhere;
  }
  L high(0.0), low(0.0);
  LaneMask<W> certain = everywhere;
  if (sheet.degenerate()) {
    L least = f.p[0], most = f.p[0];
    for (const auto& p : f.p) least = min(least, p), most = max(most, p);
    const L margin = 4 * b.p_error + gamma(16) * b.p_magnitude;
    high = sqrt(max(L(0.0), margin - least) * (1.0 / 6)) * (1 + 0x1p-20);
    low = sqrt(max(L(0.0), -most - margin) * (1.0 / 6)) * (1 - 0x1p-20);
    const L error = b.p_error + gamma(4) * (b.p_magnitude + 6 * high * high);
    certain =
        (least + 6 * high * high > error) & ((low <= L(0.0)) | (-(most + 6 * low * low) > error));
    const double s = sheet.sheet == SweptSheet::DegenerateLinear ? 1 : -1;
    sheet.sv = {s * low, s * high};
  }
  sheet.unit_error = kSlack * (2 * b.q_error + 4 * high * b.p_error +
                               gamma(8) * (2 * b.q_magnitude + 4 * high * b.p_magnitude));
  return certain;
}

/// Coefficients of the gradient of a sheet, as derivatives along the edges from vertex 0.
template <int W, int N>
struct LaneGradients {
  std::array<std::array<Lanes<W>, N - 1>, 2 * kPairs<N>> g;
  int count = 0;
};

template <int W, int N>
void take_gradients(const Forms<Lanes<W>, N>& f, const LaneSheet<W>& sheet,
                    LaneGradients<W, N>& out) {
  out.count = 0;
  if (sheet.sheet == SweptSheet::Balanced) {
    for (int i = 0; i < N; ++i, ++out.count)
      for (int a = 1; a < N; ++a) out.g[out.count][a - 1] = f.P(i, a) - f.P(i, 0);
    return;
  }
  for (const auto& [i, j] : pairs<N>()) {
    for (int a = 1; a < N; ++a) {
      const Lanes<W> dq = f.Q(i, j, a) - f.Q(i, j, 0);
      out.g[out.count][a - 1] = dq;
      if (!sheet.degenerate()) continue;
      const Lanes<W> dp = (f.P(i, a) - f.P(i, 0)) + (f.P(j, a) - f.P(j, 0));
      out.g[out.count][a - 1] = dq + sheet.sv[0] * dp;
      out.g[out.count + 1][a - 1] = dq + sheet.sv[1] * dp;
    }
    out.count += sheet.degenerate() ? 2 : 1;
  }
}

template <class L, std::size_t D>
L dot(const std::array<L, D>& a, const std::array<L, D>& b) {
  L s = a[0] * b[0];
  for (std::size_t k = 1; k < D; ++k) s = s + a[k] * b[k];
  return s;
}

/// Whether all gradients have a positive product with some direction: the mean of the gradients
/// first; then, in lanes not `done`, a few steps towards the point of their hull that is nearest to
/// the origin (Frank and Wolfe).
template <int W, int N>
LaneMask<W> grows(const LaneGradients<W, N>& gradients, const Lanes<W>& unit_error, int steps,
                  const LaneMask<W>& done) {
  using L = Lanes<W>;
  constexpr std::size_t D = N - 1;
  std::array<L, D> z = gradients.g[0];
  for (int n = 1; n < gradients.count; ++n)
    for (std::size_t k = 0; k < D; ++k) z[k] = z[k] + gradients.g[n][k];
  for (L& x : z) x = x * (1.0 / gradients.count);
  LaneMask<W> found = L(0.0) > L(0.0);
  for (int step = 0;; ++step) {
    // The largest component becomes one; 0 / 0 passes no test.
    L largest = abs(z[0]), norm(0.0);
    for (std::size_t k = 1; k < D; ++k) largest = max(largest, abs(z[k]));
    std::array<L, D> d;
    for (std::size_t k = 0; k < D; ++k) {
      d[k] = z[k] / largest;
      norm = norm + abs(d[k]);
    }
    L least = dot(d, gradients.g[0]);
    std::array<L, D> worst = gradients.g[0];
    for (int n = 1; n < gradients.count; ++n) {
      const L value = dot(d, gradients.g[n]);
      const auto lower = value < least;
      for (std::size_t k = 0; k < D; ++k) worst[k] = select(lower, gradients.g[n][k], worst[k]);
      least = select(lower, value, least);
    }
    found = found | (least > norm * unit_error);
    if (step >= steps || all(found | done)) return found;
    std::array<L, D> back;
    for (std::size_t k = 0; k < D; ++k) back[k] = z[k] - worst[k];
    const L length = dot(back, back);
    const L t = select(length > L(0.0), min(max(dot(z, back) / length, L(0.0)), L(1.0)), L(0.0));
    for (std::size_t k = 0; k < D; ++k) z[k] = z[k] - t * back[k];
  }
}

/// At most one sign change along an edge, all signs certain.
template <int W, std::size_t Count>
LaneMask<W> changes_once(const std::array<Lanes<W>, Count>& c, const Lanes<W>& error) {
  LaneMask<W> certain = abs(c[0]) > error;
  LaneMask<W> changed = Lanes<W>(0.0) > Lanes<W>(0.0), again = changed;
  for (std::size_t n = 1; n < Count; ++n) {
    certain = certain & (abs(c[n]) > error);
    const LaneMask<W> here =
        ((c[n - 1] > error) & (c[n] < -error)) | ((c[n - 1] < -error) & (c[n] > error));
    again = again | (changed & here);
    changed = changed | here;
  }
  return certain & ~again;
}

/// The sheet misses a face or an edge.
template <int W, int N>
LaneMask<W> lacks_sheet(const Forms<Lanes<W>, N>& f, const LaneBounds<W>& b, SweptSheet sheet) {
  const LaneSigns<W> signs = uniform_signs<W, N>(f, b);
  if (sheet == SweptSheet::Balanced) return signs.p_positive | signs.p_negative;
  if (sheet == SweptSheet::Neutral) return signs.q_positive | signs.q_negative;
  const LanePages<W> pages = absent_pages<W, N>(f, b, signs);
  return sheet == SweptSheet::DegenerateLinear ? pages.no_linear : pages.no_planar;
}

template <int W>
LaneMask<W> certifies_face(const Forms<Lanes<W>, 3>& f, const LaneBounds<W>& b,
                           const LaneSheet<W>& sheet, const LaneMask<W>& done) {
  constexpr int kSteps = 4;
  LaneGradients<W, 3> gradients;
  take_gradients<W, 3>(f, sheet, gradients);
  LaneMask<W> passed = grows<W, 3>(gradients, sheet.unit_error, 0, done) | done;
  if (all(passed)) return passed;
  passed = passed | lacks_sheet<W, 3>(f, b, sheet.sheet);
  if (all(passed)) return passed;
  return passed | grows<W, 3>(gradients, sheet.unit_error, kSteps, passed);
}

template <int W>
LaneMask<W> certifies_edge(const Forms<Lanes<W>, 2>& f, const LaneBounds<W>& b,
                           const LaneSheet<W>& sheet, const LaneMask<W>& done) {
  LaneMask<W> passed = done;
  if (sheet.sheet == SweptSheet::Balanced) passed = passed | changes_once<W>(f.p, b.p_error);
  if (sheet.sheet == SweptSheet::Neutral) passed = passed | changes_once<W>(f.q, b.q_error);
  if (all(passed)) return passed;
  LaneGradients<W, 2> gradients;
  take_gradients<W, 2>(f, sheet, gradients);
  passed = passed | grows<W, 2>(gradients, sheet.unit_error, 0, done);
  if (all(passed)) return passed;
  return passed | lacks_sheet<W, 2>(f, b, sheet.sheet);
}

/// The sheet is a graph in the tet; absent or a graph on its faces; crossed at most once on its
/// edges. What `certify_cell` asks of a sheet where there is no spine.
template <int W>
LaneMask<W> certifies_sheet(const Forms<Lanes<W>, 4>& f, const LaneBounds<W>& b, SweptSheet which) {
  constexpr std::array<std::array<int, 3>, 4> kFaces = {
      {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
  constexpr std::array<std::array<int, 2>, 6> kEdges = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  constexpr int kSteps = 4;
  LaneSheet<W> sheet{};
  sheet.sheet = which;
  LaneMask<W> passed = prepare_sheet<W>(f, b, sheet);
  LaneGradients<W, 4> gradients;
  take_gradients<W, 4>(f, sheet, gradients);
  passed = passed & grows<W, 4>(gradients, sheet.unit_error, kSteps, ~passed);
  // Lanes that failed are not worth the steps of the others.
  for (const auto& face : kFaces)
    passed = passed & certifies_face<W>(restrict_to<3>(f, face), b, sheet, ~passed);
  for (const auto& edge : kEdges)
    passed = passed & certifies_edge<W>(restrict_to<2>(f, edge), b, sheet, ~passed);
  return passed;
}

}  // namespace triplex

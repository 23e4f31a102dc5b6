// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/graph.hpp"

#include <cmath>

#include "range_of_v.hpp"
#include "triplex/certify/mode_page.hpp"
#include "triplex/certify/witness.hpp"

namespace triplex {
namespace {

/// d as weights of the vertices, summing to zero: d_0 = -(d_1 + ... ) is implied.
template <class NT, int N>
std::array<NT, N - 1> direction_in(const std::array<double, 3>& d) {
  std::array<NT, N - 1> r;
  for (int a = 1; a < N; ++a) r[a - 1] = NT(d[a - 1]);
  return r;
}

double one_norm(const std::array<double, 3>& d) {
  return std::fabs(d[0]) + std::fabs(d[1]) + std::fabs(d[2]);
}

/// Coefficient i of half the derivative of P along the edge from vertex 0 to vertex a.
template <class NT, int N>
NT p_derivative(const Forms<NT, N>& f, int i, int a) {
  return f.P(i, a) - f.P(i, 0);
}
/// Coefficient ij of a third of the derivative of Q + 3 s v P (v held fixed) along the same edge.
template <class NT, int N>
NT sheet_derivative(const Forms<NT, N>& f, int i, int j, int a, const NT& sv) {
  return (f.Q(i, j, a) - f.Q(i, j, 0)) + sv * (p_derivative(f, i, a) + p_derivative(f, j, a));
}

struct PIncreases {
  std::array<double, 3> d;
  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    // Per component: two errors of P; the dot product of three takes 1 + 1 + 2 roundings.
    const double error =
        one_norm(d) * (2 * bounds.p_error + gamma(5) * 2 * bounds.p_magnitude) * (1 + 0x1p-20);
    const auto w = direction_in<NT, N>(d);
    AllPositive all;
    for (int i = 0; i < N; ++i) {
      NT value = w[0] * p_derivative(f, i, 1);
      for (int a = 2; a < N; ++a) value = value + w[a - 1] * p_derivative(f, i, a);
      if (!all.add(certainty(value, error))) break;
    }
    return all.verdict();
  }
};

/// d . grad (Q + 3 s v P) > 0 at both ends of a range of v; v = 0 alone is the neutral sheet.
struct SheetIncreases {
  std::array<double, 3> d;
  std::array<double, 2> sv;  // s v at the two bounds
  int ends;                  // 1 or 2

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    const auto w = direction_in<NT, N>(d);
    AllPositive all;
    for (int end = 0; end < ends; ++end) {
      // Per component: two errors of Q and four of P times v; the deepest term, v times a sum of
      // differences inside the dot product, takes 2 + 1 + 1 + 1 + 2 roundings.
      const double v = std::fabs(sv[end]);
      const double error = one_norm(d) * (1 + 0x1p-20) *
                           (2 * bounds.q_error + 4 * v * bounds.p_error +
                            gamma(8) * (2 * bounds.q_magnitude + 4 * v * bounds.p_magnitude));
      const NT v_end(sv[end]);
      for (const auto& [i, j] : pairs<N>()) {
        NT value = w[0] * sheet_derivative(f, i, j, 1, v_end);
        for (int a = 2; a < N; ++a) value = value + w[a - 1] * sheet_derivative(f, i, j, a, v_end);
        if (!all.add(certainty(value, error))) return all.verdict();
      }
    }
    return all.verdict();
  }
};

template <int N>
std::array<double, 3> direction_for_p(const Forms<double, N>& f) {
  std::array<std::array<double, 3>, N> g{};
  for (int i = 0; i < N; ++i)
    for (int a = 1; a < N; ++a) g[i][a - 1] = p_derivative(f, i, a);
  return separating_direction(g);
}

template <int N>
std::array<double, 3> direction_for(const Forms<double, N>& f, const std::array<double, 2>& sv,
                                    int ends) {
  std::array<std::array<double, 3>, 2 * kPairs<N>> g{};
  std::size_t n = 0;
  for (int end = 0; end < ends; ++end)
    for (const auto& [i, j] : pairs<N>()) {
      for (int a = 1; a < N; ++a) g[n][a - 1] = sheet_derivative(f, i, j, a, sv[end]);
      ++n;
    }
  return separating_direction(std::span(g.data(), n));
}

bool is_zero(const std::array<double, 3>& d) { return d[0] == 0 && d[1] == 0 && d[2] == 0; }

/// Bounds on v and a direction for a curved sheet, found among the mapped doubles.
struct CurvedWitness {
  BoundsV range;
  SheetIncreases increases;
};
template <int N>
CurvedWitness curved_witness(const Forms<double, N>& f, const FormBounds& bounds, Sign sign_q) {
  const BoundsV range = range_of_v(f, bounds);
  const double s = sign_q == Sign::Positive ? 1 : -1;
  const std::array<double, 2> sv = {s * range.low, s * range.high};
  return {range, {direction_for(f, sv, 2), sv, 2}};
}

}  // namespace

template <int N>
bool certifies_graph(const Simplex<N>& simplex, const Sheet& sheet, SignStages& stages) {
  switch (sheet.kind) {
    case Sheet::Kind::Balanced: {
      const auto d = direction_for_p(simplex.approximate());
      return !is_zero(d) && simplex.decide(PIncreases{d}, stages);
    }
    case Sheet::Kind::Neutral: {
      const auto d = direction_for(simplex.approximate(), {}, 1);
      return !is_zero(d) && simplex.decide(SheetIncreases{d, {}, 1}, stages);
    }
    case Sheet::Kind::Curved: {
      const CurvedWitness w =
          with_mapped_doubles(simplex, sheet.map, [&](const auto& f, const FormBounds& bounds) {
            return curved_witness(f, bounds, sheet.sign_q);
          });
      return !is_zero(w.increases.d) &&
             simplex.decide(Mapped<BoundsV>{sheet.map, w.range}, stages) &&
             simplex.decide(Mapped<SheetIncreases>{sheet.map, w.increases}, stages);
    }
  }
  return false;
}

template bool certifies_graph<2>(const Simplex<2>&, const Sheet&, SignStages&);
template bool certifies_graph<3>(const Simplex<3>&, const Sheet&, SignStages&);
template bool certifies_graph<4>(const Simplex<4>&, const Sheet&, SignStages&);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/zero_face.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "range_of_v.hpp"
#include "triplex/certify/mode_page.hpp"
#include "triplex/certify/witness.hpp"

namespace triplex {
namespace {

/// Indices of a Bernstein coefficient of p (two) or q (three).
template <int N, std::size_t Degree>
constexpr const auto& multi_indices() {
  if constexpr (Degree == 2)
    return pairs<N>();
  else
    return triples<N>();
}
template <class NT, int N>
const NT& coefficient(const Forms<NT, N>& f, const std::array<int, 2>& i) {
  return f.P(i[0], i[1]);
}
template <class NT, int N>
const NT& coefficient(const Forms<NT, N>& f, const std::array<int, 3>& i) {
  return f.Q(i[0], i[1], i[2]);
}
/// The same coefficient with one index replaced.
template <class NT, int N, std::size_t Degree>
const NT& with_index(const Forms<NT, N>& f, std::array<int, Degree> i, std::size_t at, int a) {
  i[at] = a;
  return coefficient(f, i);
}

/// Coefficient i of the derivative of f from vertex `from` to vertex `to`, raised to f's degree:
/// the sum of the differences over the places of the index.
template <class NT, int N, std::size_t Degree>
NT raised_derivative(const Forms<NT, N>& f, const std::array<int, Degree>& i, int from, int to) {
  NT sum = with_index(f, i, 0, to) - with_index(f, i, 0, from);
  for (std::size_t at = 1; at < Degree; ++at)
    sum = sum + (with_index(f, i, at, to) - with_index(f, i, at, from));
  return sum;
}

/// Two or three vertices, the first of which directions start from.
struct ZeroFace {
  std::array<int, 3> vertices{};
  int size = 0;

  template <std::size_t Degree>
  bool contains(const std::array<int, Degree>& i) const {
    return std::ranges::all_of(i, [this](int v) {
      return std::find(vertices.begin(), vertices.begin() + size, v) != vertices.begin() + size;
    });
  }
};

/// What coefficient i of the growth is made of: its factors of the two components of d and of m.
template <class NT, int N, std::size_t Degree>
std::array<NT, 3> factors(const Forms<NT, N>& f, const std::array<int, Degree>& i,
                          const ZeroFace& face, double sv) {
  const auto from = face.vertices[0];
  std::array<NT, 3> g{NT(0), NT(0), NT(3) * coefficient(f, i)};
  for (std::size_t a = 1; a < static_cast<std::size_t>(face.size); ++a)
    g[a - 1] = raised_derivative(f, i, from, face.vertices[a]);
  if constexpr (Degree == 3) {
    if (sv == 0) return g;
    const NT weight(2 * sv);
    g[2] = g[2] + weight * (f.P(i[0], i[1]) + f.P(i[1], i[2]) + f.P(i[0], i[2]));
    for (std::size_t a = 1; a < static_cast<std::size_t>(face.size); ++a) {
      const int to = face.vertices[a];
      NT sum = f.P(i[0], to) - f.P(i[0], from);
      for (std::size_t at = 1; at < Degree; ++at) sum = sum + (f.P(i[at], to) - f.P(i[at], from));
      g[a - 1] = g[a - 1] + weight * sum;
    }
  }
  return g;
}

/// d . grad f + 3 m f > 0, d towards the face's second and third vertex from its first; f is P, or
/// Q, or for a curved sheet, at both bounds of v, the C^1 function G whose growth is affine in v.
template <std::size_t Degree>
struct GrowsAlong {
  ZeroFace face;
  std::array<double, 2> d{};
  double m = 0;
  std::array<double, 2> sv{};  // s v at the two bounds
  int ends = 1;                // 1: v = 0 throughout

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    AllPositive all;
    for (int end = 0; end < ends; ++end) {
      const double error = error_of(bounds, std::fabs(sv[static_cast<std::size_t>(end)]));
      for (const auto& i : multi_indices<N, Degree>()) {
        const auto g = factors(f, i, face, sv[static_cast<std::size_t>(end)]);
        NT value = NT(m) * g[2];
        for (std::size_t a = 0; a + 1 < static_cast<std::size_t>(face.size); ++a)
          value = value + NT(d[a]) * g[a];
        if (!all.add(certainty(value, error))) return all.verdict();
      }
    }
    return all.verdict();
  }

  /// Per direction 2 Degree coefficients of f and 6 of P times 2 v, each with its error; 3 of both
  /// with m. Roundings: differences 1, their sum 2, times 2 v 1, with Q 1, product 1, sum of
  /// three 2.
  double error_of(const FormBounds& b, double v) const {
    const bool q = Degree == 3;
    const double f = gamma(8) * (q ? b.q_magnitude : b.p_magnitude) + (q ? b.q_error : b.p_error);
    const double p = gamma(8) * b.p_magnitude + b.p_error;
    const double directions = std::fabs(d[0]) + std::fabs(d[1]);
    return (directions * (2 * Degree * f + 12 * v * p) + 3 * std::fabs(m) * (f + 2 * v * p)) *
           (1 + 0x1p-20);
  }
};

/// The part of first order in eps of the forms of T + eps B, up to a positive factor: the forms
/// with B in place of one of the tensors, summed over the places.
template <int N>
Forms<double, N> first_order(const Simplex<N>& simplex) {
  std::array<Tensor<double>, N + 1> a;
  for (std::size_t i = 0; i < N; ++i) a[i] = simplex.field().approximate(simplex.vertices()[i]).a;
  for (std::size_t k = 0; k < 9; ++k) a[N][k] = kPerturbation[k];
  a[N] = triple_deviator(a[N]);
  const auto with_b = forms_of<double, N + 1>(a);
  Forms<double, N> f;
  for (int n = 0; n < kPairs<N>; ++n) {
    const auto& [i, j] = pairs<N>()[n];
    f.p[n] = with_b.P(i, N) + with_b.P(j, N);
  }
  for (int n = 0; n < kTriples<N>; ++n) {
    const auto& [i, j, k] = triples<N>()[n];
    f.q[n] = with_b.Q(i, j, N) + with_b.Q(i, k, N) + with_b.Q(j, k, N);
  }
  return f;
}

/// Of unit size, as only the sign of the scalar product with (d, m) matters; zero if not above
/// `noise`.
std::array<double, 3> normalised(std::array<double, 3> g, double noise) {
  const double size = std::max({std::fabs(g[0]), std::fabs(g[1]), std::fabs(g[2])});
  if (size <= noise || !std::isfinite(1 / size)) return {};
  for (double& x : g) x /= size;
  return g;
}

/// A direction in the face and a multiplier that leave no coefficient without a reason to be
/// positive: coefficients that vanish ask for those of first order.
template <std::size_t Degree, int N>
GrowsAlong<Degree> witness(const Forms<double, N>& f, const Forms<double, N>& first,
                           GrowsAlong<Degree> growth, double noise) {
  std::array<std::array<double, 3>, 2 * multi_indices<N, Degree>().size()> g;
  std::size_t count = 0;
  for (int end = 0; end < growth.ends; ++end) {
    const double sv = growth.sv[static_cast<std::size_t>(end)];
    for (const auto& i : multi_indices<N, Degree>()) {
      g[count] = normalised(factors(f, i, growth.face, sv), 2 * Degree * noise);
      if (g[count] == std::array<double, 3>{})
        g[count] = normalised(factors(first, i, growth.face, sv), 0);
      ++count;
    }
  }
  const auto d = separating_direction(std::span(g.data(), count));
  growth.d = {d[0], d[1]};
  growth.m = d[2];
  return growth;
}

/// The edges and faces of a simplex on which no coefficient is clear of zero, faces first.
template <std::size_t Degree, int N>
std::array<ZeroFace, 10> zero_faces(const Forms<double, N>& f, double noise) {
  std::array<ZeroFace, 10> faces{};
  std::size_t count = 0;
  for (const int size : {3, 2}) {
    for (unsigned mask = 0; mask < 1u << N; ++mask) {
      if (std::popcount(mask) != size) continue;
      ZeroFace face;
      for (int v = 0; v < N; ++v)
        if (mask >> v & 1u) face.vertices[static_cast<std::size_t>(face.size++)] = v;
      const bool zero = std::ranges::all_of(multi_indices<N, Degree>(), [&](const auto& i) {
        return !face.contains(i) || std::fabs(coefficient(f, i)) <= noise;
      });
      if (zero) faces[count++] = face;
    }
  }
  return faces;
}

/// `sign_q` is that of a curved sheet, which asks for bounds on v; else zero.
template <std::size_t Degree, int N>
bool certify(const Simplex<N>& simplex, const ModeMap& map, Sign sign_q, SignStages& stages) {
  const double noise = Degree == 3 ? simplex.bounds().q_error : simplex.bounds().p_error;
  const auto faces = zero_faces<Degree>(simplex.approximate(), noise);
  if (faces[0].size == 0) return false;

  const Forms<double, N> f = mapped(simplex.approximate(), map);
  const Forms<double, N> first = mapped(first_order(simplex), map);
  GrowsAlong<Degree> growth;
  if (sign_q != Sign::Zero) {
    const BoundsV range = range_of_v(f, mapped(simplex.bounds(), map));
    if (!simplex.decide(Mapped<BoundsV>{map, range}, stages)) return false;
    const double s = sign_q == Sign::Positive ? 1 : -1;
    growth.sv = {s * range.low, s * range.high};
    growth.ends = 2;
  }
  for (const ZeroFace& face : faces) {
    if (face.size == 0) return false;
    growth.face = face;
    growth = witness<Degree>(f, first, growth, std::fabs(map.q_factor) * noise);
    const bool found = growth.d[0] != 0 || growth.d[1] != 0;
    if (found && simplex.decide(Mapped<GrowsAlong<Degree>>{map, growth}, stages)) return true;
  }
  return false;
}

}  // namespace

template <int N>
bool certifies_graph_beside_zeros(const Simplex<N>& simplex, const Sheet& sheet,
                                  SignStages& stages) {
  return sheet.kind == Sheet::Kind::Balanced ? certify<2>(simplex, sheet.map, Sign::Zero, stages)
                                             : certify<3>(simplex, sheet.map, sheet.sign_q, stages);
}

template bool certifies_graph_beside_zeros<2>(const Simplex<2>&, const Sheet&, SignStages&);
template bool certifies_graph_beside_zeros<3>(const Simplex<3>&, const Sheet&, SignStages&);
template bool certifies_graph_beside_zeros<4>(const Simplex<4>&, const Sheet&, SignStages&);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_on_edge.hpp"

#include "surd.hpp"

namespace triplex::detail {
namespace {

template <class NT>
NT cubic_at(const Forms<NT, 2>& f, const std::array<NT, 2>& x) {
  const NT three(3), x00 = x[0] * x[0], x11 = x[1] * x[1];
  return x00 * (f.Q(0, 0, 0) * x[0] + three * f.Q(0, 0, 1) * x[1]) +
         x11 * (three * f.Q(0, 1, 1) * x[0] + f.Q(1, 1, 1) * x[1]);
}

// At (x0, x1) = (c, u + s sqrt(d)) with u = -b the cubic is U + V sqrt(d).
Sign exact_sign(const Forms<Exact, 2>& f, const EdgeCut& edge, int k) {
  const Exact c = f.P(1, 1), u = -f.P(0, 1), d = u * u - f.P(0, 0) * c;
  const Exact s(has_plus(edge, k) ? 1 : -1), three(3), uu = u * u, cc = c * c;
  const Exact U = f.Q(0, 0, 0) * cc * c + three * f.Q(0, 0, 1) * cc * u +
                  three * f.Q(0, 1, 1) * c * (uu + d) + f.Q(1, 1, 1) * u * (uu + three * d);
  const Exact V = s * (three * f.Q(0, 0, 1) * cc + Exact(6) * f.Q(0, 1, 1) * c * u +
                       f.Q(1, 1, 1) * (three * uu + d));
  return edge.ends[1] * sign_of_surd(U, V, d);
}

}  // namespace

std::array<Sign, 2> spine_signs(const TensorField& field, const std::array<VertexId, 2>& vertices,
                                const EdgeCut& edge) {
  std::array<Sign, 2> signs{};
  std::array<std::optional<Sign>, 2> known{};
  {
    const IntervalRounding rounding;
    const auto f = forms_on<Interval>(field, vertices);
    for (int k = 0; k < edge.roots; ++k)
      known[k] = known_sign(cubic_at(f, root_vector(f.P(0, 0), f.P(0, 1), f.P(1, 1), edge, k)));
  }
  for (int k = 0; k < edge.roots; ++k)
    signs[k] = known[k] ? *known[k] : exact_sign(forms_on<Exact>(field, vertices), edge, k);
  return signs;
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cusp.hpp"

#include <algorithm>
#include <cmath>

#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

/// Below this part of 2 |P|^3, the largest at a vertex, 3 Q^2 counts as small. A choice, by trial.
constexpr double kSmall = 1.0 / 64;
/// An edge is long enough if P varies along it by this part of the most. A choice.
constexpr double kLong = 0.5;

}  // namespace

std::optional<std::array<VertexId, 2>> edge_across_cusp(const RefinableField& field,
                                                        const Leaf& leaf) {
  const auto& v = leaf.vertices;
  std::array<double, 4> p, q;
  for (std::size_t i = 0; i < 4; ++i) {
    if (field.is_enclosed(v[i]) || field.is_isotropic(v[i])) return {};
    const Forms<double, 1> f = forms_of<double, 1>({field.approximate(v[i]).a});
    p[i] = f.p[0];
    q[i] = f.q[0];
  }
  const auto largest = [](const std::array<double, 4>& x) {
    const auto [lo, hi] = std::ranges::minmax(x);
    return std::max(hi, -lo);
  };
  const auto [lowest, highest] = std::ranges::minmax(p);
  if (!(lowest < 0 && highest > 0)) return {};
  if (std::ranges::min(q) < 0 && std::ranges::max(q) > 0) return {};
  const double most_p = largest(p), most_q = largest(q);
  if (!(3 * most_q * most_q < kSmall * 2 * most_p * most_p * most_p)) return {};
  std::optional<std::array<VertexId, 2>> edge;
  double best_p = 0, best_q = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double along_p = std::fabs(p[i] - p[j]), along_q = std::fabs(q[i] - q[j]);
      if (!(along_p >= kLong * (highest - lowest))) continue;
      const double gain = best_q * along_p - along_q * best_p;
      if (edge && !(gain > 0 || (gain == 0 && along_p > best_p))) continue;
      best_p = along_p;
      best_q = along_q;
      edge = {v[i], v[j]};
    }
  return edge;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wedge.hpp"

#include <algorithm>
#include <cmath>

namespace triplex {
namespace {

/// What counts as further, as a part of the opening. A choice, by trial.
constexpr double kFurther = 0.5;

/// The tensor beside an axis k: chi = det(M - e) of the 2 x 2 block M and the number e on the axis,
/// and the opening 2 sqrt|s K| of the surface |chi| = 2 sqrt(s K), to first order, where
/// K = c adj(M - e) b is what the couplings b and c make of it and s = -tr(M - e).
struct Block {
  double chi = 0, opening = 0;

  Block(const Tensor<double>& t, std::size_t k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const double e = t[4 * k], ii = t[4 * i] - e, jj = t[4 * j] - e, ij = t[3 * i + j],
                 ji = t[3 * j + i];
    const double bi = t[3 * i + k], bj = t[3 * j + k], ci = t[3 * k + i], cj = t[3 * k + j];
    chi = ii * jj - ij * ji;
    opening = 2 * std::sqrt(std::fabs((ii + jj) *
                                      (ci * bi * jj + cj * bj * ii - ci * bj * ij - cj * bi * ji)));
  }
};

Tensor<double> mean(const Tensor<double>& a, const Tensor<double>& b) {
  Tensor<double> m;
  for (std::size_t k = 0; k < 9; ++k) m[k] = (a[k] + b[k]) / 2;
  return m;
}

}  // namespace

std::optional<std::array<VertexId, 2>> edge_across_wedge(const RefinableField& field,
                                                         const Leaf& leaf) {
  const auto& v = leaf.vertices;
  const auto is_special = [&](VertexId u) { return field.is_enclosed(u) || field.is_isotropic(u); };
  if (std::ranges::any_of(v, is_special)) return {};
  std::array<unsigned, 4> zero;
  for (std::size_t i = 0; i < 4; ++i) zero[i] = field.zero_couplings(v[i]);
  std::optional<std::array<VertexId, 2>> edge;
  double furthest = 0;
  for (unsigned n = 0; n < 6; ++n) {
    const auto is_in_plane = [&](std::size_t i) { return (zero[i] >> n & 1u) != 0; };
    double opening = 0;
    int in_plane = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (is_in_plane(i))
        ++in_plane;
      else
        opening = std::max(opening, Block(field.approximate(v[i]).a, n % 3).opening);
    if (in_plane < 2 || in_plane == 4) continue;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (!is_in_plane(i) || !is_in_plane(j)) continue;
        const Tensor<double>&a = field.approximate(v[i]).a, &b = field.approximate(v[j]).a;
        const double start = Block(a, n % 3).chi, end = Block(b, n % 3).chi,
                     middle = Block(mean(a, b), n % 3).chi;
        const double departure = std::fabs(start + end - 2 * middle) / 2;
        const double nearest = std::min({std::fabs(start), std::fabs(middle), std::fabs(end)});
        if (departure > kFurther * opening && nearest < departure + opening &&
            departure > furthest) {
          furthest = departure;
          edge = {v[i], v[j]};
        }
      }
  }
  return edge;
}

}  // namespace triplex

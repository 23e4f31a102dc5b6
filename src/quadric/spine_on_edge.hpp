// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "fixed_interval.hpp"
#include "triplex/quadric/edge_cut.hpp"

namespace triplex::detail {

/// p and q on a simplex of a field, as Bernstein coefficients up to positive factors.
template <class NT, std::size_t N>
Forms<NT, static_cast<int>(N)> forms_on(const TensorField& field,
                                        const std::array<VertexId, N>& vertices) {
  std::array<Tensor<NT>, N> t;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < 9; ++k) t[i][k] = NT(field.tensors[index(vertices[i])][k]);
  for (auto& x : t) x = triple_deviator(x);
  return forms_of<NT, static_cast<int>(N)>(t);
}

/// Whether root k of p on an edge is (-b + sqrt(d)) / c and not (-b - sqrt(d)) / c, as the ratio of
/// the coordinates of vertex 1 and vertex 0.
inline bool has_plus(const EdgeCut& edge, int k) {
  const bool larger = edge.roots == 1 || k == 1;
  return larger == (edge.ends[1] == Sign::Positive);
}

/// A vector at root k of a x0^2 + 2 b x0 x1 + c x1^2, with positive coordinates, whose enclosure
/// does not suffer from cancellation.
template <class NT>
std::array<NT, 2> root_vector(const NT& a, const NT& b, const NT& c, const EdgeCut& edge, int k) {
  const bool plus = has_plus(edge, k);
  const NT w = root_of(NT(b * b - a * c));
  const auto turned = [](Sign s, const NT& x) -> NT { return s == Sign::Negative ? NT(-x) : x; };
  if (known_sign(b) == (plus ? Sign::Positive : Sign::Negative)) {  // also a / (-b - s w)
    const NT x0 = plus ? NT(-b - w) : NT(w - b);
    return {turned(edge.ends[0], x0), turned(edge.ends[0], a)};
  }
  const NT x1 = plus ? NT(w - b) : NT(-b - w);
  return {turned(edge.ends[1], c), turned(edge.ends[1], x1)};
}

/// The signs of q at the roots of p on an edge; Zero: the triple degenerate curve meets the edge.
/// Guarantee: exact. \pre edge is the cut of the balanced surface. Source: proofs/quadric_spine.md.
std::array<Sign, 2> spine_signs(const TensorField& field, const std::array<VertexId, 2>& vertices,
                                const EdgeCut& edge);

}  // namespace triplex::detail

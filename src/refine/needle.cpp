// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "needle.hpp"

#include <algorithm>
#include <cmath>

namespace triplex {
namespace {

/// Longest edge over that of the input's tet, times the cube root of the quotient of volumes: 1 for
/// a tet of the same shape.
constexpr double kLongest = 20;

struct Edge {
  std::array<VertexId, 2> ends{};
  double squared_length = -1;
};

/// The first of several.
Edge longest_edge_approx(const RefinableField& field, const std::array<VertexId, 4>& vertices) {
  Edge longest;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) {
      const Tensor<double>& a = field.approximate(vertices[i]).a;
      const Tensor<double>& b = field.approximate(vertices[j]).a;
      double squared = 0;
      for (std::size_t k = 0; k < 9; ++k) squared += (a[k] - b[k]) * (a[k] - b[k]);
      if (squared > longest.squared_length) longest = {{vertices[i], vertices[j]}, squared};
    }
  return longest;
}

}  // namespace

std::optional<std::array<VertexId, 2>> edge_of_needle(const RefinableField& field,
                                                      const Leaf& leaf) {
  // An edge is never longer than those of the input's tet, so a leaf of few bisections is none.
  if (std::exp2(leaf.depth / 3.0) <= kLongest) return {};
  // The tets at an isotropic vertex are needles by right: only the opposite face is refined.
  const auto is_special = [&](VertexId v) { return field.is_enclosed(v) || field.is_isotropic(v); };
  if (std::ranges::any_of(leaf.vertices, is_special)) return {};
  const Edge edge = longest_edge_approx(field, leaf.vertices);
  const Edge whole = longest_edge_approx(field, field.input_tets()[index(leaf.input)]);
  // A bisection about halves the volume; this is a choice of edges, not a bound.
  const double usual = whole.squared_length * std::exp2(-2.0 / 3 * leaf.depth);
  if (!(edge.squared_length > kLongest * kLongest * usual)) return {};
  return edge.ends;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "triplex/refine/refine.hpp"

namespace triplex::test {

/// Four tensors at the corners of a tet: the origin and one step along each axis.
inline TensorField on_corners(std::vector<Tensor<double>> tensors) {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  field.tensors = std::move(tensors);
  return field;
}

/// The points of the input, ascending, at the ends of the edge that is chosen for the leaf that is
/// the only tet.
template <class Choice>
std::vector<std::size_t> edge_of_only_leaf(const TensorField& input, const Choice& choose) {
  const RefinableField field(input);
  const Leaf leaf{.vertices = field.input_tets().front(), .input = TetId(0)};
  const auto edge = choose(field, leaf);
  std::vector<std::size_t> points;
  const auto vertex_of = field.vertices_of_input();
  for (std::size_t p = 0; edge && p < vertex_of.size(); ++p)
    if (std::ranges::count(*edge, vertex_of[p]) != 0) points.push_back(p);
  return points;
}

}  // namespace triplex::test

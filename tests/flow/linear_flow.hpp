// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/field/grid.hpp"
#include "triplex/field/vector_field.hpp"

namespace triplex::test {

/// v = J (x - centre) + offset on a jittered grid of the box [-1, 1]^3.
inline VectorField linear_flow(const Tensor<double>& j, const Point& centre, const Point& offset,
                               int n = 5) {
  VectorField field{grid_mesh({.n = n, .jitter = 0.1}, {{-1, -1, -1}, {1, 1, 1}}), {}, "u"};
  for (const Point& x : field.mesh.points) {
    Point v = offset;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) v[i] += j[3 * i + k] * (x[k] - centre[k]);
    field.vectors.push_back(v);
  }
  return field;
}

}  // namespace triplex::test

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "triplex/field/generators.hpp"
#include "triplex/trace/tracer.hpp"

/// Fields given by a function of the point, sampled on a grid, and distances along curves.
namespace triplex::testing_fields {

template <class Function>
TensorField sampled(const GridOptions& options, const Function& tensor_at) {
  TensorField field = generate_constant(options);
  for (std::size_t v = 0; v < field.mesh.points.size(); ++v)
    field.tensors[v] = tensor_at(field.mesh.points[v]);
  return field;
}

inline GridOptions grid(int n, const Box& box, double jitter = 0) {
  GridOptions options;
  options.n = n;
  options.box = box;
  options.jitter = jitter;
  return options;
}

inline double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace triplex::testing_fields

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex::baseline {

/// A point of the field with its tensor, in scaled units.
struct FieldPoint {
  Point x;
  Tensor<double> t;
};

inline FieldPoint midpoint(const FieldPoint& a, const FieldPoint& b) {
  FieldPoint m;
  for (std::size_t i = 0; i < 3; ++i) m.x[i] = 0.5 * (a.x[i] + b.x[i]);
  for (std::size_t i = 0; i < 9; ++i) m.t[i] = 0.5 * (a.t[i] + b.t[i]);
  return m;
}

/// The point with these barycentric coordinates.
template <std::size_t N>
FieldPoint interpolate(const std::array<FieldPoint, N>& v, const std::array<double, N>& weight) {
  FieldPoint r{};
  for (std::size_t n = 0; n < N; ++n) {
    if (weight[n] == 0) continue;
    for (std::size_t i = 0; i < 3; ++i) r.x[i] += weight[n] * v[n].x[i];
    for (std::size_t i = 0; i < 9; ++i) r.t[i] += weight[n] * v[n].t[i];
  }
  return r;
}

/// The longest edge of a simplex. Among equally long ones the one whose midpoint comes first in the
/// order of coordinates, so that both tets at a face choose alike.
template <std::size_t N>
std::pair<int, int> longest_edge(const std::array<FieldPoint, N>& v) {
  std::pair<int, int> best{0, 1};
  double best_length = -1;
  Point best_sum{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = i + 1; j < N; ++j) {
      double length = 0;
      Point sum;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = v[i].x[k] - v[j].x[k];
        length += d * d;
        sum[k] = v[i].x[k] + v[j].x[k];
      }
      if (length < best_length || (length == best_length && sum >= best_sum)) continue;
      best = {static_cast<int>(i), static_cast<int>(j)};
      best_length = length;
      best_sum = sum;
    }
  return best;
}

}  // namespace triplex::baseline

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

#include "form_fields.hpp"

namespace triplex::test {

/// Random linear functions on the tet, as their values at the corners.
inline TensorField random_quadric(std::mt19937& random, std::size_t plus, std::size_t minus) {
  TensorField field = one_tet(kAroundOrigin);
  std::vector<std::array<double, 4>> values(plus + minus);
  for (auto& l : values) {
    const int shift = std::uniform_int_distribution<int>(-12, 12)(random);
    for (double& x : l) x = shift + std::uniform_int_distribution<int>(-20, 20)(random);
  }
  for (std::size_t v = 0; v < 4; ++v) {
    std::vector<double> a, s;
    for (std::size_t k = 0; k < values.size(); ++k) (k < plus ? a : s).push_back(values[k][v]);
    field.tensors[v] = balanced_tensor(a, s);
  }
  return field;
}

/// Quadrics around a point inside the tet: many loops.
inline TensorField random_central_quadric(std::mt19937& random, std::size_t plus) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const Point center = {unit(random), unit(random), unit(random)};
  std::array<Linear, 4> squares;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<double, 3> d{unit(random) / 3, unit(random) / 3, unit(random) / 3};
    d[k] += 1;
    squares[k] = [=](const Point& x) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += d[i] * (x[i] - center[i]);
      return sum;
    };
  }
  const double radius = 5 + 12 * std::abs(unit(random));
  squares[3] = [=](const Point&) { return radius; };
  if (plus == 1)
    return quadric_field(kAroundOrigin, {squares[3]}, {squares[0], squares[1], squares[2]});
  return quadric_field(kAroundOrigin, {squares[0], squares[1]}, {squares[2], squares[3]});
}

}  // namespace triplex::test

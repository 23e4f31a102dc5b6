// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "triplex/field/tensor_field.hpp"

/// Fields on one tet whose balanced surface is a quadric of choice: antisymmetric unit tensors have
/// -tr(A^2) = 2, symmetric ones -2, and all six are orthogonal to each other.
namespace triplex::test {

using Linear = std::function<double(const Point&)>;

/// The tensor whose -tr(A^2) / 2 is the sum of the squares of `plus` less that of `minus`; at most
/// three of each.
inline Tensor<double> balanced_tensor(const std::vector<double>& plus,
                                      const std::vector<double>& minus) {
  constexpr int kUpper[3] = {1, 2, 5}, kLower[3] = {3, 6, 7};
  Tensor<double> t{};
  for (std::size_t k = 0; k < plus.size(); ++k) {
    t[kUpper[k]] += plus[k];
    t[kLower[k]] -= plus[k];
  }
  for (std::size_t k = 0; k < minus.size(); ++k) {
    t[kUpper[k]] += minus[k];
    t[kLower[k]] += minus[k];
  }
  return t;
}

inline TensorField one_tet(const std::array<Point, 4>& corners) {
  TensorField field;
  field.mesh.points.assign(corners.begin(), corners.end());
  field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  field.tensors.resize(4);
  field.array_name = "T";
  return field;
}

/// The function sum plus^2 - sum minus^2 on a tet.
inline TensorField quadric_field(const std::array<Point, 4>& corners,
                                 const std::vector<Linear>& plus,
                                 const std::vector<Linear>& minus) {
  TensorField field = one_tet(corners);
  for (std::size_t v = 0; v < 4; ++v) {
    std::vector<double> a, s;
    for (const Linear& l : plus) a.push_back(l(corners[v]));
    for (const Linear& l : minus) s.push_back(l(corners[v]));
    field.tensors[v] = balanced_tensor(a, s);
  }
  return field;
}

/// A tet around the origin that holds the ball of radius 7.
inline constexpr std::array<Point, 4> kAroundOrigin = {
    {{-7, -7, -7}, {31, -7, -7}, {-7, 31, -7}, {-7, -7, 31}}};
inline constexpr std::array<VertexId, 4> kCorners = {VertexId(0), VertexId(1), VertexId(2),
                                                     VertexId(3)};

inline double x_of(const Point& p) { return p[0]; }
inline double y_of(const Point& p) { return p[1]; }
inline double z_of(const Point& p) { return p[2]; }
inline double one_of(const Point&) { return 1; }
inline Linear times(double c, const Linear& f) {
  return [=](const Point& p) { return c * f(p); };
}

}  // namespace triplex::test

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_field.hpp"

#include <algorithm>
#include <cmath>

namespace triplex::detail {
namespace {

Vector minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Tensor<double> combine(const std::array<Tensor<double>, 4>& t, const std::array<double, 4>& l) {
  Tensor<double> r;
  for (int i = 0; i < 9; ++i)
    r[i] = (l[0] * t[0][i] + l[1] * t[1][i]) + (l[2] * t[2][i] + l[3] * t[3][i]);
  return r;
}

}  // namespace

CellField::CellField(const TensorField& field, TetId tet) : tet_(tet) {
  std::array<Point, 4> v;
  double coordinate = 0, entry = 0;
  for (int i = 0; i < 4; ++i) {
    const auto id = index(field.mesh.tets[index(tet)][i]);
    v[i] = field.mesh.points[id];
    tensors_[i] = field.tensors[id];
    for (const double x : v[i]) coordinate = std::fmax(coordinate, std::fabs(x));
    for (const double x : tensors_[i]) entry = std::fmax(entry, std::fabs(x));
  }
  int exponent = 0;
  std::frexp(entry, &exponent);
  scaled_ = tensors_;
  for (auto& t : scaled_)
    for (double& x : t) x = std::ldexp(x, -exponent);
  origin_ = v[0];
  const Vector a = minus(v[1], v[0]), b = minus(v[2], v[0]), c = minus(v[3], v[0]);
  const double volume = dot(a, cross(b, c));
  gradients_[1] = (1 / volume) * cross(b, c);
  gradients_[2] = (1 / volume) * cross(c, a);
  gradients_[3] = (1 / volume) * cross(a, b);
  double steepest = 0;
  for (int k = 0; k < 3; ++k)
    gradients_[0][k] = -(gradients_[1][k] + gradients_[2][k] + gradients_[3][k]);
  for (int i = 0; i < 4; ++i) {
    const double length = std::sqrt(dot(gradients_[i], gradients_[i]));
    heights_[i] = 1 / length;
    steepest = std::fmax(steepest, length);
    for (int j = 0; j < i; ++j) {
      const Vector edge = minus(v[i], v[j]);
      size_ = std::fmax(size_, std::sqrt(dot(edge, edge)));
    }
  }
  // A choice: a few hundred roundings of numbers up to one, or 16 of the position.
  position_rounding_ = 16 * 0x1p-53 * coordinate;
  rounding_ = std::fmax(1e-13, position_rounding_ * steepest);
}

std::array<double, 4> CellField::barycentric(const Point& x) const {
  const Vector d = minus(x, origin_);
  std::array<double, 4> l{};
  for (int i = 1; i < 4; ++i) l[i] = dot(gradients_[i], d);
  l[0] = 1 - (l[1] + l[2] + l[3]);
  return l;
}

Tensor<double> CellField::tensor(const Point& x) const { return combine(tensors_, barycentric(x)); }
Tensor<double> CellField::scaled_tensor(const Point& x) const {
  return combine(scaled_, barycentric(x));
}
Tensor<double> CellField::scaled_growth(const Vector& direction) const {
  return combine(scaled_, {slope(0, direction), slope(1, direction), slope(2, direction),
                           slope(3, direction)});
}

}  // namespace triplex::detail

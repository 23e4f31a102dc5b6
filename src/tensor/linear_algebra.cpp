// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear_algebra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace triplex {
namespace {

// Brings the largest entry of rows and columns >= k to place (k, k); notes the order of columns.
void pivot(std::array<std::array<double, 3>, 3>& u, std::array<int, 3>& columns, int k) {
  int row = k;
  int column = k;
  for (int i = k; i < 3; ++i) {
    for (int j = k; j < 3; ++j) {
      if (std::fabs(u[i][j]) > std::fabs(u[row][column])) {
        row = i;
        column = j;
      }
    }
  }
  std::swap(u[k], u[row]);
  for (auto& r : u) std::swap(r[k], r[column]);
  std::swap(columns[k], columns[column]);
}

}  // namespace

UnitDeviator unit_deviator(const Tensor<double>& t) {
  // Sums of differences of entries up to 2^1020 do not overflow. What is off the diagonal keeps its
  // own scale, however small it is.
  Tensor<double> a = t;
  a[0] = (t[0] - t[4]) + (t[0] - t[8]);
  a[4] = (t[4] - t[0]) + (t[4] - t[8]);
  a[8] = (t[8] - t[0]) + (t[8] - t[4]);
  int exponent = std::numeric_limits<int>::min();
  for (const double x : a) {
    int e = 0;
    std::frexp(x, &e);
    if (x != 0) exponent = std::max(exponent, e);
  }
  if (exponent == std::numeric_limits<int>::min()) return {};
  for (double& x : a) x = std::ldexp(x, -exponent);
  for (const int i : {0, 4, 8}) a[i] /= 3;
  return {a, exponent};
}

Tensor<double> shifted(const Tensor<double>& m, double l) {
  Tensor<double> r = m;
  for (const int i : {0, 4, 8}) r[i] -= l;
  return r;
}

Direction null_vector(const Tensor<double>& m) {
  std::array<std::array<double, 3>, 3> u = {
      {{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}}};
  std::array<int, 3> columns = {0, 1, 2};
  pivot(u, columns, 0);
  if (u[0][0] == 0) return {1, 0, 0};
  for (int i = 1; i < 3; ++i) {
    const double factor = u[i][0] / u[0][0];
    for (int j = 1; j < 3; ++j) u[i][j] -= factor * u[0][j];
  }
  pivot(u, columns, 1);
  // Rank one to rounding: any vector with two free components will do.
  const double last = 1;
  const double middle = u[1][1] == 0 ? 0 : -u[1][2] / u[1][1];
  const double first = -(u[0][1] * middle + u[0][2] * last) / u[0][0];
  Direction v;
  v[columns[0]] = first;
  v[columns[1]] = middle;
  v[columns[2]] = last;
  return with_fixed_sign(normalized(v));
}

double dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Direction normalized(const Direction& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction combination(double x, const Direction& a, double y, const Direction& b) {
  return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
}

Direction any_orthogonal(const Direction& n) {
  int axis = 0;
  for (const int i : {1, 2}) {
    if (std::fabs(n[i]) < std::fabs(n[axis])) axis = i;
  }
  Direction e{};
  e[axis] = 1;
  return normalized(cross(n, e));
}

Direction times(const Tensor<double>& m, const Direction& v) {
  Direction r;
  for (std::size_t i = 0; i < 3; ++i)
    r[i] = m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2];
  return r;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "triplex/field/tensor_field.hpp"

/// The nodes of one linear field by many starts of a Gauss-Newton iteration in doubles.
namespace triplex::oracle {

namespace detail {

/// Solves a symmetric 4 x 4 system by elimination with pivoting.
inline bool solve(std::array<std::array<double, 5>, 4> m, std::array<double, 4>& x) {
  for (std::size_t c = 0; c < 4; ++c) {
    std::size_t best = c;
    for (std::size_t r = c + 1; r < 4; ++r)
      if (std::fabs(m[r][c]) > std::fabs(m[best][c])) best = r;
    std::swap(m[c], m[best]);
    if (m[c][c] == 0) return false;
    for (std::size_t r = 0; r < 4; ++r) {
      if (r == c) continue;
      const double f = m[r][c] / m[c][c];
      for (std::size_t k = c; k < 5; ++k) m[r][k] -= f * m[c][k];
    }
  }
  for (std::size_t c = 0; c < 4; ++c) x[c] = m[c][4] / m[c][c];
  return true;
}

/// F = A^2 + l A - 2 l^2 I, with A = A_0 + sum x_k D_k; F vanishes at nodes (and where A = 0).
struct LinearField {
  std::array<Tensor<double>, 4> a;  // value at the origin, derivatives

  Tensor<double> at(const Point& x) const {
    Tensor<double> r = a[0];
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t k = 0; k < 9; ++k) r[k] += x[n] * a[n + 1][k];
    return r;
  }
  static Tensor<double> product(const Tensor<double>& a, const Tensor<double>& b) {
    Tensor<double> c{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    return c;
  }
  /// One step; returns its length, or infinity.
  double step(std::array<double, 4>& z) const {
    const Tensor<double> A = at({z[0], z[1], z[2]});
    const double l = z[3];
    Tensor<double> f = product(A, A);
    for (std::size_t k = 0; k < 9; ++k) f[k] += l * A[k] - (k % 4 == 0 ? 2 * l * l : 0);
    std::array<Tensor<double>, 4> d;
    for (std::size_t n = 0; n < 3; ++n) {
      const auto left = product(a[n + 1], A), right = product(A, a[n + 1]);
      for (std::size_t k = 0; k < 9; ++k) d[n][k] = left[k] + right[k] + l * a[n + 1][k];
    }
    for (std::size_t k = 0; k < 9; ++k) d[3][k] = A[k] - (k % 4 == 0 ? 4 * l : 0);
    std::array<std::array<double, 5>, 4> normal{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t k = 0; k < 9; ++k) normal[i][j] += d[i][k] * d[j][k];
      for (std::size_t k = 0; k < 9; ++k) normal[i][4] += d[i][k] * f[k];
    }
    std::array<double, 4> s{};
    if (!solve(normal, s)) return HUGE_VAL;
    double length = 0;
    for (std::size_t n = 0; n < 4; ++n) {
      z[n] -= s[n];
      length = std::max(length, std::fabs(s[n]));
    }
    return length;
  }
  double residual(const std::array<double, 4>& z) const {
    const Tensor<double> A = at({z[0], z[1], z[2]});
    Tensor<double> f = product(A, A);
    double worst = 0;
    for (std::size_t k = 0; k < 9; ++k)
      worst = std::max(worst, std::fabs(f[k] + z[3] * A[k] - (k % 4 == 0 ? 2 * z[3] * z[3] : 0)));
    return worst;
  }
};

}  // namespace detail

/// The nodes inside the box [-1, 1]^3, by position. \pre a linear field on a grid of that box.
inline std::vector<Point> nodes_of_linear_field(const TensorField& field) {
  detail::LinearField linear;
  const auto value_at = [&](const Point& x) {
    const auto found = std::ranges::find(field.mesh.points, x);
    Tensor<double> t = field.tensors[static_cast<std::size_t>(found - field.mesh.points.begin())];
    const double mean = (t[0] + t[4] + t[8]) / 3;
    for (const std::size_t k : {0u, 4u, 8u}) t[k] -= mean;
    return t;
  };
  const auto low = value_at({-1, -1, -1}), x = value_at({1, -1, -1}), y = value_at({-1, 1, -1}),
             z = value_at({-1, -1, 1});
  for (std::size_t k = 0; k < 9; ++k) {
    linear.a[1][k] = (x[k] - low[k]) / 2;
    linear.a[2][k] = (y[k] - low[k]) / 2;
    linear.a[3][k] = (z[k] - low[k]) / 2;
    linear.a[0][k] = low[k] + linear.a[1][k] + linear.a[2][k] + linear.a[3][k];
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(-1.2, 1.2), eigenvalue(-2, 2);
  std::vector<Point> nodes;
  constexpr int kStarts = 4000, kSteps = 60;
  for (int n = 0; n < kStarts; ++n) {
    std::array<double, 4> p = {coordinate(random), coordinate(random), coordinate(random),
                               eigenvalue(random)};
    double length = HUGE_VAL;
    for (int s = 0; s < kSteps && length > 1e-14; ++s) length = linear.step(p);
    if (!(length < 1e-10) || linear.residual(p) > 1e-12 || std::fabs(p[3]) < 1e-6) continue;
    if (std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])}) > 1) continue;
    const bool known = std::ranges::any_of(nodes, [&](const Point& q) {
      return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]) < 1e-6;
    });
    if (!known) nodes.push_back({p[0], p[1], p[2]});
  }
  std::ranges::sort(nodes);
  return nodes;
}

}  // namespace triplex::oracle

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "triplex/feature/feature_table.hpp"
#include "triplex/field/tensor_field.hpp"

/// The pages of one linear field in long doubles, by other means than the code: differences and
/// Newton's iteration; and distances to triangles.
namespace triplex::oracle {

using Vec = std::array<long double, 3>;

/// A linear field in space, in long doubles, from the corners of the box of a grid.
class Linear {
 public:
  explicit Linear(const TensorField& field) {
    const auto& x = field.mesh.points;
    for (std::size_t n = 0; n < x.size(); ++n) {
      int differ = 0, axis = -1;
      for (int k = 0; k < 3; ++k)
        if (x[n][static_cast<std::size_t>(k)] != x[0][static_cast<std::size_t>(k)])
          ++differ, axis = k;
      if (differ != 1) continue;
      const auto a = static_cast<std::size_t>(axis);
      for (std::size_t k = 0; k < 9; ++k)
        slope_[a][k] = (static_cast<long double>(field.tensors[n][k]) - field.tensors[0][k]) /
                       (static_cast<long double>(x[n][a]) - x[0][a]);
    }
    for (std::size_t k = 0; k < 9; ++k) {
      at_zero_[k] = field.tensors[0][k];
      for (std::size_t a = 0; a < 3; ++a) at_zero_[k] -= slope_[a][k] * x[0][a];
    }
  }
  std::array<long double, 2> invariants(const Vec& x) const {
    std::array<long double, 9> t;
    for (std::size_t k = 0; k < 9; ++k)
      t[k] = at_zero_[k] + x[0] * slope_[0][k] + x[1] * slope_[1][k] + x[2] * slope_[2][k];
    const long double third = (t[0] + t[4] + t[8]) / 3;
    for (const std::size_t k : {0u, 4u, 8u}) t[k] -= third;
    long double square = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) square += t[3 * i + j] * t[3 * j + i];
    const long double q = t[0] * (t[4] * t[8] - t[5] * t[7]) - t[1] * (t[3] * t[8] - t[5] * t[6]) +
                          t[2] * (t[3] * t[7] - t[4] * t[6]);
    return {-square / 2, q};
  }
  /// The function of the sheet that carries a standard page.
  long double sheet(Feature f, const Vec& x) const {
    const auto [p, q] = invariants(x);
    const long double w = std::sqrt(std::max(0.0L, -p) / 3);
    switch (f) {
      case Feature::BalancedLinear:
      case Feature::BalancedPlanar:
        return p;
      case Feature::DegenerateLinear:
        return q - 2 * w * w * w;
      case Feature::DegeneratePlanar:
        return q + 2 * w * w * w;
      default:
        return q;
    }
  }
  bool is_on_page(Feature f, const Vec& x) const {
    const auto [p, q] = invariants(x);
    switch (f) {
      case Feature::BalancedLinear:
        return q > 0;
      case Feature::BalancedPlanar:
        return q < 0;
      case Feature::NeutralComplex:
        return p > 0;
      default:
        return p < 0;
    }
  }
  /// The point of the sheet that Newton's iteration along the gradient reaches, by differences.
  std::optional<Vec> project(Feature f, Vec x, long double reach) const {
    const Vec start = x;
    for (int n = 0; n < 60; ++n) {
      const long double value = sheet(f, x), h = reach * 1e-4L + 1e-12L;
      Vec g;
      long double square = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        Vec a = x, b = x;
        a[k] += h, b[k] -= h;
        g[k] = (sheet(f, a) - sheet(f, b)) / (2 * h);
        square += g[k] * g[k];
      }
      if (square == 0) return std::nullopt;
      long double step = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] -= value / square * g[k];
        step = std::max(step, std::fabs(value / square * g[k]));
      }
      if (!(std::fabs(x[0] - start[0]) + std::fabs(x[1] - start[1]) + std::fabs(x[2] - start[2]) <
            100 * reach + 1))
        return std::nullopt;
      if (step < 1e-15L) return x;
    }
    return std::nullopt;
  }

 private:
  std::array<long double, 9> at_zero_{};
  std::array<std::array<long double, 9>, 3> slope_{};
};

inline long double distance(const Vec& a, const Vec& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                   (a[2] - b[2]) * (a[2] - b[2]));
}

inline Vec to_vec(const Point& x) { return {x[0], x[1], x[2]}; }

/// To a triangle, by its regions.
inline long double distance_to_triangle(const Vec& p, const Vec& a, const Vec& b, const Vec& c) {
  const auto minus = [](const Vec& u, const Vec& v) {
    return Vec{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  };
  const auto dot = [](const Vec& u, const Vec& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto at = [&](const Vec& u, const Vec& v, long double t) {
    return Vec{u[0] + t * (v[0] - u[0]), u[1] + t * (v[1] - u[1]), u[2] + t * (v[2] - u[2])};
  };
  const auto to_segment = [&](const Vec& u, const Vec& v) {
    const Vec d = minus(v, u);
    const long double square = dot(d, d);
    const long double t = square > 0 ? std::clamp(dot(minus(p, u), d) / square, 0.0L, 1.0L) : 0.0L;
    return distance(p, at(u, v, t));
  };
  long double best = std::min({to_segment(a, b), to_segment(b, c), to_segment(a, c)});
  const Vec u = minus(b, a), v = minus(c, a), w = minus(p, a);
  const long double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const long double det = uu * vv - uv * uv;
  if (det > 0) {
    const long double s = (vv * wu - uv * wv) / det, t = (uu * wv - uv * wu) / det;
    if (s >= 0 && t >= 0 && s + t <= 1)
      best = std::min(best, distance(p, {a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1],
                                         a[2] + s * u[2] + t * v[2]}));
  }
  return best;
}

}  // namespace triplex::oracle

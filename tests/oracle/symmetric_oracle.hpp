// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

/// Degenerate points of linear fields of symmetric tensors by Newton's iteration with eigenvectors
/// in doubles, from many starts, and curves by small steps along them. Shares nothing with the code
/// under test.
namespace triplex::oracle {

/// N symmetric tensors at the vertices of a simplex.
template <int N>
struct LinearSymmetric {
  std::array<Eigen::Matrix3d, N> a;

  using Place = Eigen::Matrix<double, N - 1, 1>;  ///< coordinates of the vertices but the first
  Eigen::Matrix3d at(const Place& x) const {
    Eigen::Matrix3d t = a[0];
    for (int i = 1; i < N; ++i) t += x[i - 1] * (a[static_cast<std::size_t>(i)] - a[0]);
    return t;
  }
  static double least_coordinate(const Place& x) { return std::min(1 - x.sum(), x.minCoeff()); }

  struct Linearised {
    Eigen::Vector2d value;  ///< half the difference and the off-diagonal of the 2 x 2 block
    Eigen::Matrix<double, 2, N - 1> slope;
  };
  /// The block of the two eigenvectors of the pair: the lower (linear) or upper (planar) one.
  Linearised linearised(const Place& x, bool planar) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(at(x));
    const Eigen::Vector3d u = solver.eigenvectors().col(planar ? 1 : 0),
                          v = solver.eigenvectors().col(planar ? 2 : 1);
    const auto block = [&](const Eigen::Matrix3d& m) -> Eigen::Vector2d {
      return {(u.dot(m * u) - v.dot(m * v)) / 2, u.dot(m * v)};
    };
    Linearised l;
    l.value = block(at(x));
    for (int i = 1; i < N; ++i) l.slope.col(i - 1) = block(a[static_cast<std::size_t>(i)] - a[0]);
    return l;
  }
  /// The nearest degenerate point, by steps of least norm.
  std::optional<Place> newton(Place x, bool planar) const {
    for (int step = 0; step < 40; ++step) {
      const Linearised l = linearised(x, planar);
      const Eigen::Vector2d y = (l.slope * l.slope.transpose()).ldlt().solve(l.value);
      const Place d = l.slope.transpose() * y;
      x -= d;
      if (!(x.norm() < 20)) return std::nullopt;
      if (d.norm() < 1e-13) return x;
    }
    return std::nullopt;
  }
};

/// The points inside a face, from a grid of starts.
inline std::vector<Eigen::Vector2d> face_points(const LinearSymmetric<3>& f, bool planar,
                                                int starts = 16) {
  std::vector<Eigen::Vector2d> found;
  for (int i = -2; i <= starts + 2; ++i)
    for (int j = -2; i + j <= starts + 2; ++j) {
      const auto x = f.newton(Eigen::Vector2d(i, j) / starts, planar);
      if (!x || f.least_coordinate(*x) < 0) continue;
      if (std::ranges::none_of(found, [&](const auto& y) { return (y - *x).norm() < 1e-7; }))
        found.push_back(*x);
    }
  return found;
}

/// Follows a curve from a point on the boundary of a tet into it until it leaves; returns where.
/// Nothing if the steps get lost.
inline std::optional<Eigen::Vector3d> follow(const LinearSymmetric<4>& f, Eigen::Vector3d x,
                                             bool planar, double length = 5e-4) {
  const auto tangent = [&](const Eigen::Vector3d& p) {
    const auto l = f.linearised(p, planar);
    return Eigen::Vector3d(l.slope.row(0).cross(l.slope.row(1))).normalized().eval();
  };
  Eigen::Vector3d direction = tangent(x);
  if (f.least_coordinate(x + 1e-6 * direction) < f.least_coordinate(x - 1e-6 * direction))
    direction = -direction;
  for (int step = 0; step < 200000; ++step) {
    const auto next = f.newton(x + length * direction, planar);
    if (!next || (*next - x).norm() > 2 * length) return std::nullopt;
    if (f.least_coordinate(*next) < 0) return step > 0 ? std::optional(*next) : std::nullopt;
    x = *next;
    const Eigen::Vector3d t = tangent(x);
    direction = t.dot(direction) < 0 ? Eigen::Vector3d(-t) : t;
  }
  return std::nullopt;
}

inline Eigen::Matrix3d to_matrix(const Tensor<double>& t) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(t.data());
}

}  // namespace triplex::oracle

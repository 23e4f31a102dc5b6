// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

using Barycentric = std::array<double, 4>;

/// What is nearer to an edge or face than that, in barycentric coordinates, lies on it, also if its
/// points were moved a little to join them with others: A-patches move them by 2^-40 of the mesh,
/// which is below this where no tet is a thousand times smaller than the mesh.
inline constexpr double kOnSimplex = 1e-9;

/// Positions to barycentric coordinates in a tet; rounded.
class TetChart {
 public:
  TetChart(const TensorField& field, TetId tet) {
    const auto& vertices = field.mesh.tets[index(tet)];
    const auto x = [&](int i) {
      return Eigen::Map<const Eigen::Vector3d>(field.mesh.points[index(vertices[i])].data());
    };
    origin_ = x(0);
    Eigen::Matrix3d edges;
    edges << x(1) - origin_, x(2) - origin_, x(3) - origin_;
    inverse_ = edges.inverse();
    double size = 0;
    for (int i = 0; i < 4; ++i) size = std::fmax(size, x(i).cwiseAbs().maxCoeff());
    // A coordinate of a root on an edge, of its difference from the origin and of the product below
    // take a dozen roundings, 2^-53 of the largest coordinate each.
    rounding_ = 0x1p-48 * size * inverse_.cwiseAbs().rowwise().sum().maxCoeff();
  }
  /// What rounding the coordinates of a point, and this chart's own arithmetic, may do to its
  /// barycentric coordinates, with some to spare: nearer points lie on an edge or face if they are
  /// roots on it.
  double rounding() const { return rounding_; }
  Barycentric of(const Point& point) const {
    const Eigen::Vector3d b =
        inverse_ * (Eigen::Map<const Eigen::Vector3d>(point.data()) - origin_);
    return {1 - b[0] - b[1] - b[2], b[0], b[1], b[2]};
  }

 private:
  Eigen::Vector3d origin_;
  Eigen::Matrix3d inverse_;
  double rounding_ = 0;
};

}  // namespace triplex::detail

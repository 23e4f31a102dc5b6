// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

using Barycentric = std::array<double, 4>;

/// What is nearer to an edge or face than that, in barycentric coordinates, lies on it. Mesh points
/// on edges are roots rounded to doubles, a thousand times nearer in any mesh whose tets doubles
/// can tell apart.
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
  }
  Barycentric of(const Point& point) const {
    const Eigen::Vector3d b =
        inverse_ * (Eigen::Map<const Eigen::Vector3d>(point.data()) - origin_);
    return {1 - b[0] - b[1] - b[2], b[0], b[1], b[2]};
  }

 private:
  Eigen::Vector3d origin_;
  Eigen::Matrix3d inverse_;
};

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <limits>
#include <stdexcept>

#include "triplex/trace/plant.hpp"

namespace triplex::detail {

using Vector = Eigen::Vector3d;
using Rgb = std::array<std::uint8_t, 3>;

inline Vector vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// A unit vector orthogonal to a unit vector.
inline Vector orthogonal(const Vector& v) {
  int least = 0;
  v.cwiseAbs().minCoeff(&least);
  return v.cross(Vector::Unit(least)).normalized();
}

/// Adds points and polygons with the same attributes to a plant.
struct PlantBuilder {
  Plant& plant;
  std::uint32_t curve;
  PlantPart part;
  std::uint8_t domain = kNotApplicable;
  std::uint8_t eigenvector = kNotApplicable;
  double arc_length = 0;

  std::uint32_t add_point(const Vector& position, const Vector& normal, Rgb rgb) {
    if (plant.points.size() >= std::numeric_limits<std::uint32_t>::max())
      throw std::invalid_argument("the plants have too many points; make fewer or coarser ones");
    plant.points.push_back({position[0], position[1], position[2]});
    plant.normals.push_back({normal[0], normal[1], normal[2]});
    plant.rgb.push_back(rgb);
    plant.arc_length.push_back(arc_length);
    return static_cast<std::uint32_t>(plant.points.size() - 1);
  }

  void add_polygon(std::initializer_list<std::uint32_t> points) {
    plant.corners.insert(plant.corners.end(), points);
    plant.ends.push_back(static_cast<std::uint32_t>(plant.corners.size()));
    plant.part.push_back(part);
    plant.domain.push_back(domain);
    plant.eigenvector.push_back(eigenvector);
    plant.curve.push_back(curve);
  }
};

/// The tube around the curve.
void grow_stem(const Hyperstreamline& curve, const PlantSizes& sizes, PlantBuilder& builder);

}  // namespace triplex::detail

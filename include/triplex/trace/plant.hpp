// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/trace/augmentation.hpp"
#include "triplex/trace/hyperstreamline.hpp"

namespace triplex {

enum class PlantPart : std::uint8_t { Stem = 0, Thorn = 1, Leaf = 2 };

/// In place of a domain or an eigenvector where there is none to name.
inline constexpr std::uint8_t kNotApplicable = 255;

/// Surfaces to look at: polygons of a hyperstreamline with its thorns and leaves, in colours.
struct Plant {
  std::vector<Point> points;
  std::vector<std::array<double, 3>> normals;    ///< of points, unit
  std::vector<std::array<std::uint8_t, 3>> rgb;  ///< of points
  std::vector<double> arc_length;                ///< of points: where on the curve they grow
  std::vector<std::uint32_t> corners;            ///< of the polygons, one after another
  std::vector<std::uint32_t> ends{0};            ///< polygon k: corners ends[k] to ends[k + 1]
  std::vector<PlantPart> part;                   ///< of polygons
  std::vector<std::uint8_t> domain;              ///< of polygons, 0 to 5 as in `Classification`
  std::vector<std::uint8_t> eigenvector;  ///< of polygons: of thorns 0 major, 1 medium, 2 minor
  std::vector<std::uint32_t> curve;       ///< of polygons: the number given to `grow`
};

/// Lengths in the units of the mesh.
struct PlantSizes {
  double radius = 0;  ///< of the stem
  double thorn = 0;   ///< from the axis of the stem to the tip
  double leaf = 0;    ///< the long semi-axis
  int sides = 20;     ///< of the stem, at least 3
};

/// Adds a hyperstreamline with what grows on it to a plant.
///   stem    a tube of that radius around the polyline, with round ends, broken at turns and leaps:
///           brown wood in the real domain, smooth in the inner complex domain, half and half in
///           the outer complex domain; the appearance changes exactly at the events;
///   thorns  a spike to either side of the stem, coloured by eigenvector: red major, yellow medium,
///           blue minor;
///   leaves  the ellipse of `StemLeaf` around its place, long semi-axis `leaf`, green with a
///   midrib.
/// Shapes are approximate (polygons), the colours a choice. Guarantee: a function of its arguments.
/// \pre all sizes positive and finite; augmentation of that curve. \throw std::invalid_argument if
/// not, or if the plant would have more than 2^32 - 1 points.
void grow(const Hyperstreamline& curve, const Augmentation& augmentation, const PlantSizes& sizes,
          std::uint32_t number, Plant& plant);

}  // namespace triplex

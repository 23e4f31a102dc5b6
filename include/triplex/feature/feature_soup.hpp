// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/feature/feature.hpp"
#include "triplex/feature/feature_mesh.hpp"

namespace triplex {

/// Meshes of several features in one. Points with equal coordinates are one vertex, whatever their
/// indices. A cell is a triangle or a segment; cells are numbered triangles first.
struct FeatureSoup {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;
  std::vector<Feature> features;  ///< per cell
  // Per cell, or empty where nobody asks; and so nodes.
  std::vector<std::int64_t> source_cell = {};  ///< cell id in the input file
  std::vector<std::uint8_t> certified = {};    ///< 1 where the topology is proven
  std::vector<std::uint32_t> nodes = {};       ///< points that are nodes, ascending

  std::size_t cells() const { return triangles.size() + segments.size(); }
};

/// All features in one, in their order; mesh n is that of the feature with the number n.
/// \throw std::invalid_argument if a mesh does not have one source cell and mark per cell.
FeatureSoup join_features(std::span<const FeatureMesh> meshes);

/// The number of the vertex of each point: the lowest point with equal coordinates.
/// \pre coordinates are numbers.
std::vector<std::uint32_t> merge_equal_points(std::span<const Point> points);

}  // namespace triplex

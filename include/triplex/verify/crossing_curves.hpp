// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/verify/embedding.hpp"

namespace triplex {

/// The curves along which triangles of two features cross, as segments; those that follow each
/// other share points by index.
struct CrossingCurves {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> segments;
  // per segment
  std::vector<std::array<Feature, 2>> features;  ///< ascending
  std::vector<std::array<std::int64_t, 2>> source_cells;
  std::uint64_t points_only = 0;  ///< pairs of triangles that meet in one point
  std::uint64_t overlaps = 0;     ///< pairs in one plane: their common part is no curve
};

/// The curves in which the given pairs of triangles meet. Every point is where an edge or a vertex
/// of one meets the other, is computed once for all triangles there, and has coordinates that are
/// within one unit in the last place of the exact ones. So the curves close exactly where those of
/// the exact intersection do. Points are in order of the simplices that meet there, segments in
/// order of features and points; nothing depends on threads.
/// \pre `crossings` is from `check_embedding` of this soup, with `list_crossings`; the soup has
/// source cells. Cost: sorting, and a microsecond of rational arithmetic per point.
CrossingCurves crossing_curves(const FeatureSoup& soup, std::span<const Contact> crossings);

}  // namespace triplex

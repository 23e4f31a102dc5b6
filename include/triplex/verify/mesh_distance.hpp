// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>

#include "triplex/verify/mesh_view.hpp"

namespace triplex {

struct DistanceOptions {
  /// The bounds are brought this near to each other, in units of length; 0 for as near as
  /// `max_pieces` allows.
  double gap = 0;
  /// Where `max_pieces` allows, whether the distance is at most this is decided: not lower <=
  /// threshold < upper. Infinite: no such question.
  double threshold = std::numeric_limits<double>::infinity();
  /// So many pieces of cells are looked at, at most.
  std::size_t max_pieces = 20'000'000;
  /// Called now and then; may throw to end the computation.
  std::function<void()> check = {};
};

/// The largest distance of a point of one mesh to another mesh: between `lower` and `upper`.
/// Both 0 if the first mesh is empty, both infinite if only the second one is.
struct DirectedDistance {
  double lower = 0;
  double upper = 0;
  Point from{};  ///< where `lower` is attained
  Point to{};    ///< the point of the other mesh nearest to `from`
  friend bool operator==(const DirectedDistance&, const DirectedDistance&) = default;
};

/// The one-sided Hausdorff distance from `from` to `to`, as sets of points, with bounds.
/// Guarantee: lower <= distance <= upper up to the rounding of the distances between points and
/// cells, which are computed in doubles: a few units in the last place of the coordinates. Exactly
/// 0 if every cell of `from` is a cell of `to`, with the same coordinates. upper - lower <=
/// options.gap unless `max_pieces` was reached. The result does not depend on threads.
/// Method: the distances of the vertices; then cells are cut in four until, for all pieces, the
/// distance of the corners to one convex cell, or that of a corner and the piece's radius, is
/// small enough. Cost: n log n if the meshes nearly agree; else the pieces needed grow with the
/// seams of `to` that cross `from`, and with size / gap.
/// \throw std::invalid_argument as `check_mesh`; what `check` throws.
DirectedDistance directed_distance(const MeshView& from, const MeshView& to,
                                   const DistanceOptions& options = {});

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "patch_chart.hpp"

namespace triplex::detail {

/// Triangles over the points of the loops, one after another, and then those of `inner`.
struct PatchMesh {
  std::vector<TetPoint> inner;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Of each triangle of a balanced surface: 1 linear, -1 planar, 0 not known. Else empty.
  std::vector<std::int8_t> parts;
};

/// How the triple degenerate curve cuts a patch.
struct PatchCut {
  std::vector<std::int8_t> sides;   ///< of q at the points of the loops; 0 at the ends; or empty
  std::vector<std::uint32_t> ends;  ///< none, or the two points of the only loop that an arc joins
  std::vector<TetPoint> path;       ///< points between them

  /// The arc, by numbers of points if those of the path come first after the loops.
  std::vector<std::uint32_t> chain() const {
    std::vector<std::uint32_t> r;
    if (ends.empty()) return r;
    r.push_back(ends[0]);
    for (std::size_t k = 0; k < path.size(); ++k)
      r.push_back(static_cast<std::uint32_t>(sides.size() + k));
    r.push_back(ends[1]);
    return r;
  }
};

/// Fills the region between loops by constrained Delaunay triangulation in the plane of a chart,
/// with samples inside, and lifts it. Nothing if in the chart the loops are not the boundary of one
/// region: the combinatorics are checked (Euler number, all loops on the boundary). The arc of a
/// cut is a constraint, and its sides are those of the triangles; nothing if they are not as
/// proven.
std::optional<PatchMesh> triangulate_patch(const PatchChart& chart,
                                           const std::vector<TetLoop>& loops,
                                           const PatchCut& cut = {});

/// A closed ellipsoid: an octahedron divided `rate` times along each edge, mapped to the surface in
/// the directions of its own axes.
PatchMesh triangulate_ellipsoid(const QuadraticForm<double, 4>& form, int rate);

/// A disc from one loop and its middle.
PatchMesh triangulate_fan(const TetLoop& loop);

}  // namespace triplex::detail

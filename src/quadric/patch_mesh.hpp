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
};

/// Fills the region between loops by constrained Delaunay triangulation in the plane of a chart,
/// with samples inside, and lifts it. Nothing if in the chart the loops are not the boundary of one
/// region: the combinatorics are checked (Euler number, all loops on the boundary).
std::optional<PatchMesh> triangulate_patch(const PatchChart& chart,
                                           const std::vector<TetLoop>& loops);

/// A closed ellipsoid: an octahedron divided `rate` times along each edge, mapped to the surface in
/// the directions of its own axes.
PatchMesh triangulate_ellipsoid(const QuadraticForm<double, 4>& form, int rate);

/// A disc from one loop and its middle.
PatchMesh triangulate_fan(const TetLoop& loop);

}  // namespace triplex::detail

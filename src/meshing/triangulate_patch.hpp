// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "chart.hpp"

namespace triplex {

/// What a patch is made of: a cell, the function of its surface, a chart if there is one, and the
/// points along its boundary, in the sense of the patch.
struct PatchOutline {
  const CellMap& cell;
  const SurfaceFunction& f;
  const std::optional<Chart>& chart;
  std::span<const Weights> boundary;
  /// Of the boundary's polyline from its arcs, and of |f| between the two (`SampledArc`).
  double deviation = 0, value = 0;
};

/// Triangles of a patch; vertices are those of the outline, then those inside.
struct PatchTriangles {
  std::vector<Weights> inside;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// A bound on the distance of points of the triangles from the patch and of points of the patch
  /// from the triangles, without what rounding of positions adds; infinite where nothing is proven.
  double error = std::numeric_limits<double>::infinity();
  /// How far the vertices inside may be from the surface.
  double vertex_error = 0;
  /// The outline is no simple polygon in the plane of the chart: a finer one may be.
  bool is_tangled = false;
};

/// Triangulates a patch in the plane of its chart: constrained Delaunay, refined until the error is
/// within the tolerance and, where that is finite, for triangles of good shape. The polyline along
/// its boundary is kept as it is. Without a chart in some plane that shows the outline as a simple
/// polygon, else as a fan: without a bound. Source: proofs/mesh_accuracy.md.
PatchTriangles triangulate_patch(const PatchOutline& outline, double tolerance);

}  // namespace triplex

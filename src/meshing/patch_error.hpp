// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triangulate_patch.hpp"

namespace triplex {

/// How far up or down the surface is from a triangle, at most: |f| over the growth of f, first in
/// the whole cell; then, if that is more than what is allowed, between the triangle moved up and
/// moved down by it. Infinite where nothing is proven. Source: proofs/mesh_accuracy.md.
double error_up(const PatchOutline& outline, const Chart& chart,
                const std::array<Weights, 3>& corners, double allowed);

/// What the boundary's polyline adds to the distances.
double error_at_boundary(const PatchOutline& outline, const Chart& chart);

/// The bound for a disc over the outline whose triangles may be folded over in the plane. Where the
/// outline does not wind around a point, triangles that are turned the right way lie over it only
/// together with ones that are turned the wrong way; and these are no farther from the outline than
/// their width. \pre the outline has a chart.
double error_of_tangled(const PatchOutline& outline,
                        std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace triplex

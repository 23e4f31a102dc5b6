// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "patch_chart.hpp"
#include "spine_on_edge.hpp"

namespace triplex::detail {

/// The sign that q has everywhere in a tet, where its Bernstein coefficients tell; else Zero.
/// Certified.
Sign sign_of_q(const TensorField& field, const std::array<VertexId, 4>& vertices);

/// A linear function on a tet, by its values at the vertices, that grows along the triple
/// degenerate curve: a guess, from the directions of the curve at some points.
std::array<double, 4> height_along_spine(const TensorField& field,
                                         const std::array<VertexId, 4>& vertices,
                                         const std::vector<TetPoint>& points);

/// Whether grad(height) . (grad p x grad q) > 0 wherever p and q may both be zero in the tet: then
/// the curve is regular there, has no closed component, and grows from each start to its end.
/// Certified; false if the budget of bisections does not suffice. Source: proofs/quadric_spine.md.
bool grows_along_spine(const TensorField& field, const std::array<VertexId, 4>& vertices,
                       const std::array<double, 4>& height);

/// Points on the curve between two of its points in the order of the height, in doubles: those that
/// Newton's method finds in the tet.
std::vector<TetPoint> spine_path_approx(const TensorField& field,
                                        const std::array<VertexId, 4>& vertices,
                                        const TetPoint& from, const TetPoint& to, int segments);

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// A point inside a face or an edge of the input, exactly: the weights of its corners up to a
/// common factor. Of an edge the last corner is repeated, with weight zero.
struct ExactPoint {
  std::array<VertexId, 3> carrier;  ///< ascending
  std::array<Exact, 3> weights;
};

/// The points of faces and edges of tets of the input that have to become vertices, as no halving
/// leads to them: critical zeros of p and q (certify/critical_zero) and rational nodes
/// (certify/block_node). Those that tets share are found from each.
std::vector<ExactPoint> exact_points_on(const RefinableField& field, std::span<const TetId> tets);

/// An order that depends on the geometry only; a point that was found twice stands side by side.
void sort_by_place(std::vector<ExactPoint>& points);

/// The vertices of a leaf that span the smallest face of it that holds the point, as a bit mask;
/// nothing if the point is not in the leaf. \pre no vertex of the leaf is enclosed.
std::optional<unsigned> face_with(const RefinableField& field, const Leaf& leaf,
                                  const ExactPoint& point);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <vector>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// A point inside a face or an edge of the input, exactly: the weights of its corners up to a
/// common factor. Of an edge the last corner is repeated, with weight zero.
struct ExactPoint {
  std::array<VertexId, 3> carrier;  ///< ascending
  std::array<Exact, 3> weights;
};

/// Finds the points of faces and edges that have to become vertices as no halving leads to them:
/// critical zeros of p and q (certify/critical_zero), and nodes with exactly known places.
class ExactPoints {
 public:
  ExactPoints(const RefinableField& field, FeatureSet features)
      : field_(field), features_(features) {}

  /// The points on the faces and edges of the given tets of the input, each tet searched once, in
  /// an order that depends on the geometry only.
  std::vector<ExactPoint> search(std::span<const TetId> tets);

 private:
  std::vector<ExactPoint> points_of(TetId tet) const;

  const RefinableField& field_;
  const FeatureSet features_;  // that are requested
  std::unordered_set<TetId> searched_;
};

/// The vertices of a leaf that span the smallest face of it that holds the point, as a bit mask;
/// nothing if the point is not in the leaf.
std::optional<unsigned> face_with(const RefinableField& field, const Leaf& leaf,
                                  const ExactPoint& point);

}  // namespace triplex

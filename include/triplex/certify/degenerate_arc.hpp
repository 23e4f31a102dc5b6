// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "triplex/certify/degenerate_point.hpp"

namespace triplex {

/// A degenerate point on the boundary of a tet.
struct CellPoint {
  Feature feature = Feature::DegenerateLinear;
  std::array<ExactRange, 3> axis;  ///< as `DegeneratePoint`
  std::array<double, 4> place;     ///< barycentric coordinates in the tet, rounded
};

/// An arc of a degenerate curve in a tet, from one boundary point to another. (No degenerate curve
/// closes inside one tet.)
struct DegenerateArc {
  Feature feature = Feature::DegenerateLinear;
  int from = 0, to = 0;                       ///< numbers of points
  std::vector<std::array<double, 4>> inside;  ///< points on it in order, rounded; not certified
};

struct CellArcs {
  std::vector<DegenerateArc> arcs;
  CurveObstacle obstacle = CurveObstacle::None;  ///< if any, no arcs are known
};

/// How degenerate points on the faces of a tet of symmetric tensors are joined inside it.
/// Guarantee: the degenerate curves in the tet are the arcs, up to a homeomorphism that keeps their
/// ends, and there are no others. \pre `points` are all the points of the four faces, with the
/// same precision. The result does not depend on the order of
/// the vertices. Source: proofs/symmetric_curve.md.
CellArcs link_degenerate_points(const SymmetricField& field,
                                const std::array<VertexId, 4>& vertices,
                                std::span<const CellPoint> points,
                                AxisPrecision precision = AxisPrecision::Double);

}  // namespace triplex

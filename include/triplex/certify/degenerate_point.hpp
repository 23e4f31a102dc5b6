// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "triplex/arithmetic/exact_range.hpp"
#include "triplex/certify/node.hpp"
#include "triplex/certify/symmetric_field.hpp"
#include "triplex/feature/feature.hpp"

namespace triplex {

/// A degenerate point of a linear field of symmetric tensors inside a face: a tensor l (I - 3 n
/// n^T) with the double eigenvalue l, l < 0 linear, l > 0 planar. A degenerate curve crosses the
/// face there, transversally.
struct DegeneratePoint {
  Feature feature = Feature::DegenerateLinear;
  std::array<Range, 3> weights;    ///< enclosures of the barycentric coordinates
  std::array<ExactRange, 3> axis;  ///< enclosures of n, with some length
};

/// Why the degenerate points of a face or the arcs in a tet are not known.
enum class CurveObstacle : std::uint8_t {
  None,
  FlatFace,    ///< the tensors on the face do not span three dimensions
  Pencil,      ///< a curve of degenerate points may lie in the face
  Tangency,    ///< a multiple point in the face or at its boundary
  Boundary,    ///< a point on an edge or at a vertex
  Resolution,  ///< points too close to tell apart
  FlatCell,    ///< the tensors in the tet do not span four dimensions
  Crossing,    ///< two degenerate curves may cross
  Order,       ///< the order of the points along the curve could not be proven
};
std::string_view describe(CurveObstacle obstacle);

struct FacePoints {
  std::vector<DegeneratePoint> points;
  CurveObstacle obstacle = CurveObstacle::None;  ///< if any, no points are known
};

/// How narrow the enclosures of axes are: relative to their length, 2^-44 or 2^-400.
enum class AxisPrecision : std::uint8_t { Double, High };

/// All degenerate points in a face of symmetric tensors, at most four.
/// Guarantee: each is one and no other is, in the closed face; all lie inside and are simple. The
/// result depends on the face only, with its vertices in ascending order. Exact arithmetic.
/// Source: proofs/symmetric_curve.md.
FacePoints isolate_degenerate_points(const SymmetricField& field,
                                     const std::array<VertexId, 3>& vertices,
                                     AxisPrecision precision = AxisPrecision::Double);

}  // namespace triplex

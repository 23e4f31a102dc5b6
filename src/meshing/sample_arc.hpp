// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "cell_map.hpp"
#include "surface_function.hpp"

namespace triplex {

/// Points on an arc between its ends, and how far the polyline through them is from it.
struct SampledArc {
  std::vector<Weights> between;  ///< in the cell at hand, from the first end to the second
  /// A bound on the distance between points of the arc and of the polyline that correspond to each
  /// other; infinite where nothing is proven. Without what rounding of positions adds.
  double deviation = std::numeric_limits<double>::infinity();
  /// A bound on |f| on the paths between points that correspond; infinite for the triple degenerate
  /// curve, which is no surface's.
  double value = std::numeric_limits<double>::infinity();
  /// A bound on the distance of the points between from the arc, if `deviation` is finite.
  double point_error = 0;
};

/// The two ends of an arc in a cell, and how far they may be from the true ones.
struct ArcEnds {
  Weights first, second;
  double error = 0;
};

/// What a polyline has to satisfy.
struct ArcTarget {
  double deviation = std::numeric_limits<double>::infinity();
  double value = std::numeric_limits<double>::infinity();  ///< of f; not asked of the curve's arcs

  friend bool operator==(const ArcTarget&, const ArcTarget&) = default;
  void include(const ArcTarget& other) {
    deviation = std::fmin(deviation, other.deviation);
    value = std::fmin(value, other.value);
  }
};

/// Samples the arc of a surface on the face that lacks one corner of the cell, until it meets the
/// target. The surface must meet the face in this arc alone. Source:
/// proofs/mesh_accuracy.md.
SampledArc sample_face_arc(const CellMap& cell, const SurfaceFunction& f, std::size_t lacking,
                           const ArcEnds& ends, const ArcTarget& target);

/// Samples the arc of the triple degenerate curve in a cell of tripled deviators. The cell must
/// hold this arc alone. Source: proofs/mesh_accuracy.md.
SampledArc sample_spine_arc(const CellMap& cell, const ArcEnds& ends, double target);

/// Whether `sample_face_arc` can bound the deviation of an arc on this face; of an arc whose chord
/// it can use, it may even if not.
bool has_face_chart(const CellMap& cell, const SurfaceFunction& f, std::size_t lacking);
/// Whether there are planes in each of which (P, Q) is one-to-one on the cell, so that
/// `sample_spine_arc` needs no cut for the sake of a proof.
bool has_spine_slices(const CellMap& cell);

/// A bound on the distance of a point on an edge of the cell from the surface's only point there,
/// from the value of f; infinite if f does not grow along the edge.
double error_on_edge(const CellMap& cell, const SurfaceFunction& f, const Weights& point);

}  // namespace triplex

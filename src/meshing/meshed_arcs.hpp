// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sample_arc.hpp"
#include "triplex/extract/patch_complex.hpp"

namespace triplex {

/// The functions of all features of a table.
std::vector<SurfaceFunction> surface_functions(const FeatureTable& table, int scale);

/// Weights in a cell of a point with weights on a face, an edge, a vertex or the whole of it.
Weights in_cell(std::span<const double> weights, std::span<const VertexId> carrier,
                const std::array<VertexId, 4>& cell);

/// The arcs of a complex as polylines, each sampled once, for all patches that share it.
class MeshedArcs {
 public:
  MeshedArcs(const PatchComplex& complex, const std::vector<SurfaceFunction>& functions,
             const std::vector<ArcTarget>& targets);

  const std::vector<Point>& points() const { return points_; }
  /// The first point of an arc between its ends; those of the next follow.
  std::uint32_t first(std::uint32_t arc) const { return first_[arc]; }
  std::uint32_t count(std::uint32_t arc) const { return first_[arc + 1] - first_[arc]; }
  /// On the carrier of the point's arc.
  const std::array<double, 4>& weights(std::uint32_t point) const { return weights_[point]; }
  /// See `SampledArc`; infinite where the arc is not certified.
  double deviation(std::uint32_t arc) const { return deviation_[arc]; }
  double value(std::uint32_t arc) const { return value_[arc]; }
  /// Of the points between the ends.
  double point_error(std::uint32_t arc) const { return point_error_[arc]; }
  /// How far a corner may be from the true point, in units of length.
  double corner_error(std::uint32_t corner) const { return corner_error_[corner]; }

 private:
  std::vector<Point> points_;
  std::vector<std::array<double, 4>> weights_;
  std::vector<std::uint32_t> first_;
  std::vector<double> deviation_, value_, point_error_, corner_error_;
};

}  // namespace triplex

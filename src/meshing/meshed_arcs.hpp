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

/// An arc as a polyline.
struct MeshedArc {
  /// Between its ends, from the first to the second; weights are those of the arc's carrier.
  std::vector<Point> points;
  std::vector<std::array<double, 4>> weights;
  ArcTarget target;  ///< that it was sampled for
  /// See `SampledArc`; infinite where the arc is not certified.
  double deviation = 0, value = 0;
  double point_error = 0;
  double position_error = 0;  ///< what rounding adds to each of these
};

/// The arcs of a complex, each sampled once for all patches that share it.
class MeshedArcs {
 public:
  /// Samples nothing yet.
  MeshedArcs(const PatchComplex& complex, const std::vector<SurfaceFunction>& functions);

  /// Samples the arcs whose targets have changed; says which. \pre periodic copies have one target.
  std::vector<bool> sample(const std::vector<ArcTarget>& targets);

  const MeshedArc& operator[](std::uint32_t arc) const { return arcs_[arc]; }
  /// How far a corner's weights may be from the true point, in units of length.
  double corner_error(std::uint32_t corner) const { return corner_error_[corner]; }
  /// The same of its position.
  double corner_position_error(std::uint32_t corner) const;

 private:
  void find_hosts();
  void bound_corner_errors();
  MeshedArc sampled(std::uint32_t arc, const ArcTarget& target) const;
  /// The arc as its original is sampled. \pre that is.
  MeshedArc copied(std::uint32_t arc) const;
  bool is_copy(std::uint32_t arc) const {
    return !complex_.arc_originals.empty() && complex_.arc_originals[arc].arc != arc;
  }

  const PatchComplex& complex_;
  const std::vector<SurfaceFunction>& functions_;
  /// The cell that each arc is sampled in: that of the first patch or piece that uses it.
  std::vector<std::array<VertexId, 4>> hosts_;
  std::vector<MeshedArc> arcs_;
  std::vector<double> corner_error_;
  std::vector<std::uint32_t> arc_at_;  // an arc at each corner; arcs_.size() if there is none
};

}  // namespace triplex

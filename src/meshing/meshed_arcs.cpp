// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshed_arcs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace triplex {
namespace {

/// For every arc the cell that it is sampled in: that of the first patch or piece that uses it.
std::vector<std::array<VertexId, 4>> host_cells(const PatchComplex& complex) {
  std::vector<std::array<VertexId, 4>> hosts(complex.arcs.size());
  std::vector<bool> has_host(complex.arcs.size(), false);
  for (const Patch& patch : complex.patches)
    for (const ArcUse& use : complex.boundary(patch))
      if (!has_host[use.arc]) {
        hosts[use.arc] = patch.cell;
        has_host[use.arc] = true;
      }
  for (const CurvePiece& piece : complex.curve)
    hosts[piece.use.arc] = complex.arcs[piece.use.arc].carrier;
  return hosts;
}

Weights corner_in_cell(const PatchCorner& corner, const std::array<VertexId, 4>& cell) {
  return in_cell(std::span(corner.weights).first(corner.vertices),
                 std::span(corner.carrier).first(corner.vertices), cell);
}

std::size_t position_in(VertexId v, const std::array<VertexId, 4>& cell) {
  return static_cast<std::size_t>(std::ranges::find(cell, v) - cell.begin());
}

/// The corner of the cell that a face lacks.
std::size_t lacking(const PatchArc& arc, const std::array<VertexId, 4>& cell) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::ranges::find(std::span(arc.carrier).first(3), cell[i]) ==
        std::span(arc.carrier).first(3).end())
      return i;
  return 4;
}

struct Sampled {
  std::vector<std::array<double, 4>> weights;  // on the carrier
  std::vector<Point> points;
};

}  // namespace

std::vector<SurfaceFunction> surface_functions(const FeatureTable& table, int scale) {
  std::vector<SurfaceFunction> functions;
  for (const FeatureRow& row : table.rows())
    // The curve has none of its own; its place is kept.
    functions.emplace_back(
        table, row.kind == FeatureKind::Curve ? Feature::BalancedLinear : row.feature, scale);
  return functions;
}

Weights in_cell(std::span<const double> weights, std::span<const VertexId> carrier,
                const std::array<VertexId, 4>& cell) {
  Weights w{};
  for (std::size_t i = 0; i < carrier.size(); ++i) w[position_in(carrier[i], cell)] = weights[i];
  return w;
}

MeshedArcs::MeshedArcs(const PatchComplex& complex, const std::vector<SurfaceFunction>& functions,
                       const std::vector<ArcTarget>& targets)
    : first_(complex.arcs.size() + 1),
      deviation_(complex.arcs.size()),
      value_(complex.arcs.size()),
      point_error_(complex.arcs.size()),
      corner_error_(complex.corners.size()) {
  const auto hosts = host_cells(complex);
  const std::size_t arcs = complex.arcs.size();

  // What the value of f says of a corner may be much better than the bracket of its root; an arc on
  // a face at each corner is enough to tell.
  std::vector<std::uint32_t> arc_at(complex.corners.size(), static_cast<std::uint32_t>(arcs));
  for (std::uint32_t n = 0; n < arcs; ++n)
    if (complex.arcs[n].vertices == 3)
      for (const std::uint32_t corner : complex.arcs[n].ends)
        arc_at[corner] = std::min(arc_at[corner], n);
  tbb::parallel_for(std::size_t{0}, complex.corners.size(), [&](std::size_t n) {
    const PatchCorner& corner = complex.corners[n];
    corner_error_[n] = corner.error;
    if (corner.vertices != 2 || arc_at[n] == arcs) return;
    const SurfaceFunction& f = functions[index(complex.arcs[arc_at[n]].feature)];
    const CellMap cell(*complex.field, hosts[arc_at[n]], f.takes_trace());
    corner_error_[n] =
        std::min(corner.error, error_on_edge(cell, f, corner_in_cell(corner, hosts[arc_at[n]])));
  });

  std::vector<Sampled> sampled(arcs);
  tbb::parallel_for(std::size_t{0}, arcs, [&](std::size_t n) {
    const PatchArc& arc = complex.arcs[n];
    const bool on_face = arc.vertices == 3;
    const SurfaceFunction& f = functions[index(arc.feature)];
    const CellMap cell(*complex.field, hosts[n], on_face && f.takes_trace());
    const ArcEnds ends = {corner_in_cell(complex.corners[arc.ends[0]], hosts[n]),
                          corner_in_cell(complex.corners[arc.ends[1]], hosts[n]),
                          std::max(corner_error_[arc.ends[0]], corner_error_[arc.ends[1]])};
    SampledArc result = on_face ? sample_face_arc(cell, f, lacking(arc, hosts[n]), ends, targets[n])
                                : sample_spine_arc(cell, ends, targets[n].deviation);
    deviation_[n] = arc.certified ? result.deviation : std::numeric_limits<double>::infinity();
    value_[n] = result.value;
    point_error_[n] = result.point_error;
    for (const Weights& w : result.between) {
      const Vector x = cell.position(w);
      sampled[n].points.push_back({x[0], x[1], x[2]});
      std::array<double, 4> on_carrier{};
      for (std::size_t i = 0; i < arc.vertices; ++i)
        on_carrier[i] = w[position_in(arc.carrier[i], hosts[n])];
      sampled[n].weights.push_back(on_carrier);
    }
  });
  for (std::size_t n = 0; n < arcs; ++n) {
    first_[n] = static_cast<std::uint32_t>(points_.size());
    points_.insert(points_.end(), sampled[n].points.begin(), sampled[n].points.end());
    weights_.insert(weights_.end(), sampled[n].weights.begin(), sampled[n].weights.end());
    sampled[n] = {};
  }
  first_[arcs] = static_cast<std::uint32_t>(points_.size());
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshed_arcs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace triplex {
namespace {

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

MeshedArcs::MeshedArcs(const PatchComplex& complex, const std::vector<SurfaceFunction>& functions)
    : complex_(complex),
      functions_(functions),
      hosts_(complex.arcs.size()),
      corner_error_(complex.corners.size()) {
  find_hosts();
  bound_corner_errors();
}

void MeshedArcs::find_hosts() {
  std::vector<bool> has_host(complex_.arcs.size(), false);
  for (const Patch& patch : complex_.patches)
    for (const ArcUse& use : complex_.boundary(patch)) {
      if (has_host[use.arc]) continue;
      hosts_[use.arc] = patch.cell;
      has_host[use.arc] = true;
    }
  for (const CurvePiece& piece : complex_.curve)
    hosts_[piece.use.arc] = complex_.arcs[piece.use.arc].carrier;
}

/// What the value of f says of a corner may be much better than the bracket of its root; one arc on
/// a face at each corner is enough to tell.
void MeshedArcs::bound_corner_errors() {
  const auto none = static_cast<std::uint32_t>(complex_.arcs.size());
  arc_at_.assign(complex_.corners.size(), none);
  for (std::uint32_t n = 0; n < none; ++n)
    if (complex_.arcs[n].vertices == 3)
      for (const std::uint32_t corner : complex_.arcs[n].ends)
        arc_at_[corner] = std::min(arc_at_[corner], n);
  tbb::parallel_for(std::size_t{0}, complex_.corners.size(), [&](std::size_t n) {
    const PatchCorner& corner = complex_.corners[n];
    corner_error_[n] = corner.error;
    if (corner.vertices != 2 || arc_at_[n] == none) return;
    const SurfaceFunction& f = functions_[index(complex_.arcs[arc_at_[n]].feature)];
    const auto& host = hosts_[arc_at_[n]];
    const CellMap cell(*complex_.field, host, f.takes_trace());
    corner_error_[n] = std::min(corner.error, error_on_edge(cell, f, corner_in_cell(corner, host)));
  });
}

double MeshedArcs::corner_position_error(std::uint32_t corner) const {
  const std::uint32_t arc = arc_at_[corner];
  return arc < arcs_.size() ? corner_error_[corner] + arcs_[arc].position_error
                            : std::numeric_limits<double>::infinity();
}

std::vector<bool> MeshedArcs::sample(const std::vector<ArcTarget>& targets) {
  std::vector<std::uint32_t> wanted;
  std::vector<bool> changed(targets.size(), false);
  for (std::uint32_t n = 0; n < targets.size(); ++n)
    if (arcs_.empty() || arcs_[n].target != targets[n]) {
      wanted.push_back(n);
      changed[n] = true;
    }
  arcs_.resize(targets.size());
  const auto copies =
      std::stable_partition(wanted.begin(), wanted.end(), [&](auto n) { return !is_copy(n); });
  const auto originals = static_cast<std::size_t>(copies - wanted.begin());
  tbb::parallel_for(std::size_t{0}, originals, [&](std::size_t i) {
    arcs_[wanted[i]] = sampled(wanted[i], targets[wanted[i]]);
  });
  tbb::parallel_for(originals, wanted.size(),
                    [&](std::size_t i) { arcs_[wanted[i]] = copied(wanted[i]); });
  return changed;
}

/// The sides are translates of each other: nothing but the coordinate across them differs.
MeshedArc MeshedArcs::copied(std::uint32_t n) const {
  const PatchArc& arc = complex_.arcs[n];
  const auto& [original, reversed, places] = complex_.arc_originals[n];
  MeshedArc result = arcs_[original];
  if (!arc.certified) result.deviation = result.value = std::numeric_limits<double>::infinity();
  const CellMap cell(*complex_.field, hosts_[n], functions_[index(arc.feature)].takes_trace());
  result.position_error = std::max(result.position_error, cell.position_error());
  for (std::array<double, 4>& w : result.weights) w = {w[places[0]], w[places[1]], w[places[2]], 0};
  const Point here = complex_.field->position(arc.carrier[0]);
  const Point there = complex_.field->position(complex_.arcs[original].carrier[places[0]]);
  for (Point& x : result.points)
    for (std::size_t i = 0; i < 3; ++i)
      if (here[i] != there[i]) x[i] = here[i];
  if (reversed) {
    std::ranges::reverse(result.weights);
    std::ranges::reverse(result.points);
  }
  return result;
}

MeshedArc MeshedArcs::sampled(std::uint32_t n, const ArcTarget& target) const {
  const PatchArc& arc = complex_.arcs[n];
  const auto& host = hosts_[n];
  const bool on_face = arc.vertices == 3;
  const SurfaceFunction& f = functions_[index(arc.feature)];
  const CellMap cell(*complex_.field, host, on_face && f.takes_trace());
  const ArcEnds ends = {corner_in_cell(complex_.corners[arc.ends[0]], host),
                        corner_in_cell(complex_.corners[arc.ends[1]], host),
                        std::max(corner_error_[arc.ends[0]], corner_error_[arc.ends[1]])};
  const SampledArc found = on_face ? sample_face_arc(cell, f, lacking(arc, host), ends, target)
                                   : sample_spine_arc(cell, ends, target.deviation);
  MeshedArc result;
  result.target = target;
  result.deviation = arc.certified ? found.deviation : std::numeric_limits<double>::infinity();
  result.value = arc.certified ? found.value : std::numeric_limits<double>::infinity();
  result.position_error = cell.position_error();
  result.point_error = found.point_error;
  for (const Weights& w : found.between) {
    const Vector x = cell.position(w);
    result.points.push_back({x[0], x[1], x[2]});
    std::array<double, 4> on_carrier{};
    for (std::size_t i = 0; i < arc.vertices; ++i)
      on_carrier[i] = w[position_in(arc.carrier[i], host)];
    result.weights.push_back(on_carrier);
  }
  return result;
}

}  // namespace triplex

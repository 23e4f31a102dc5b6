// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "joined_crossings.hpp"

#include <numeric>

namespace triplex {

JoinedCrossings::JoinedCrossings(const RefinedComplex& complex, const EdgeCrossings& crossings,
                                 const FaceSpinePoints& spine_points)
    : edge_of(crossings.crossings().size()),
      joined(crossings.crossings().size()),
      at_node(crossings.crossings().size()) {
  std::iota(joined.begin(), joined.end(), 0u);
  for (std::size_t e = 0; e < crossings.edges().size(); ++e) {
    const CrossedEdge& edge = crossings.edges()[e];
    for (int i = 0; i < edge.count(); ++i)
      edge_of[edge.first + static_cast<std::uint32_t>(i)] = static_cast<std::uint32_t>(e);
  }
  for (const CrossedEdge& edge : crossings.edges())
    for (const VertexId end : edge.ends) {
      const bool isotropic = complex.field.is_isotropic(end);
      if (!isotropic && !complex.field.is_node(end)) continue;
      for (int i = 0; i < edge.pages(); ++i) {
        const std::uint32_t crossing = edge.first + static_cast<std::uint32_t>(i);
        const Crossing& c = crossings.crossings()[crossing];
        const bool passes = isotropic || c.feature == Feature::DegenerateLinear ||
                            c.feature == Feature::DegeneratePlanar;
        if (!passes || c.t != (end == edge.ends[1] ? 1 : 0)) continue;
        joined[crossing] = first_.try_emplace(end, crossing).first->second;
        at_node[crossing] = true;
      }
    }
  if (!complex.field.has_isotropic_vertices()) return;
  // Around a face the rotations add up to zero or a whole turn, which no single edge makes: so a
  // face at an isotropic vertex with a spine point has a crossing there.
  for (const SpinePoint& point : spine_points.points()) {
    of_spine_point_.push_back(kNone);
    for (const VertexId v : point.face)
      if (complex.field.is_isotropic(v)) of_spine_point_.back() = first_.at(v);
  }
}

PatchVertex JoinedCrossings::operator()(PatchVertex v) const {
  if (!v.on_spine) {
    v.number = joined[v.number];
  } else if (!of_spine_point_.empty() && of_spine_point_[v.number] != kNone) {
    v.number = of_spine_point_[v.number];
    v.on_spine = false;
  }
  return v;
}

}  // namespace triplex

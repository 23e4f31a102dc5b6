// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "joined_crossings.hpp"

#include <numeric>
#include <unordered_map>

namespace triplex {

JoinedCrossings::JoinedCrossings(const RefinedComplex& complex, const EdgeCrossings& crossings)
    : edge_of(crossings.crossings().size()),
      joined(crossings.crossings().size()),
      at_node(crossings.crossings().size()) {
  std::iota(joined.begin(), joined.end(), 0u);
  for (std::size_t e = 0; e < crossings.edges().size(); ++e) {
    const CrossedEdge& edge = crossings.edges()[e];
    for (int i = 0; i < edge.count(); ++i)
      edge_of[edge.first + static_cast<std::uint32_t>(i)] = static_cast<std::uint32_t>(e);
  }
  std::unordered_map<VertexId, std::uint32_t> first;
  for (const CrossedEdge& edge : crossings.edges())
    for (const VertexId end : edge.ends) {
      if (!complex.field.is_node(end)) continue;
      for (int i = 0; i < edge.pages(); ++i) {
        const std::uint32_t crossing = edge.first + static_cast<std::uint32_t>(i);
        const Crossing& c = crossings.crossings()[crossing];
        const bool is_degenerate =
            c.feature == Feature::DegenerateLinear || c.feature == Feature::DegeneratePlanar;
        if (!is_degenerate || c.t != (end == edge.ends[1] ? 1 : 0)) continue;
        joined[crossing] = first.try_emplace(end, crossing).first->second;
        at_node[crossing] = true;
      }
    }
}

}  // namespace triplex

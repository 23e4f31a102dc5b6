// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {

/// A point where an edge meets a page.
struct Crossing {
  Feature page;
  double t = 0;      ///< along the edge from its lower to its higher end
  double error = 1;  ///< the root is proven to lie within t +- error; 1 if nothing is proven
  Point position{};
  double p = 0, q = 0;  ///< of the deviator there, in the units of the input
};

/// An edge of the refined mesh whose ends lie in different sectors. Its crossings are the pages
/// between the sectors, in order from the lower to the higher end.
struct CrossedEdge {
  std::array<VertexId, 2> ends;  ///< ascending
  std::int8_t rotation = 0;      ///< pages crossed, positive counter-clockwise
  bool open = false;             ///< the side of the spine could not be decided
  std::uint32_t first = 0;       ///< its first crossing

  int count() const { return rotation < 0 ? -rotation : rotation; }
};

/// All crossed edges of the complex, each once, with their crossings.
class EdgeCrossings {
 public:
  /// `labels` has a sector for every vertex. Crossings of pages outside `features` get no position.
  EdgeCrossings(const RefinedComplex& complex, const std::vector<Sector>& labels,
                const std::vector<std::uint32_t>& active_leaves, FeatureSet features,
                SignStages& stages);

  const std::vector<CrossedEdge>& edges() const { return edges_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  /// The edge between two vertices, or nullptr if it is not crossed. \pre a < b.
  const CrossedEdge* find(VertexId a, VertexId b) const;
  /// The crossing of a page on an edge that starts in `sector`, or -1.
  static int crossing_of(const CrossedEdge& edge, Sector sector, Feature page);

 private:
  std::vector<CrossedEdge> edges_;
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> first_edge_;  // per vertex: its first edge as lower end
};

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include "edge_root.hpp"
#include "triplex/certify/simplex.hpp"
#include "triplex/feature/feature_table.hpp"
#include "vertex_labels.hpp"

namespace triplex {

/// A point where an edge meets a page or a level set.
struct Crossing {
  Feature feature{};
  double t = 0;      ///< along the edge from its lower to its higher end
  double error = 1;  ///< the root is proven to lie within t +- error; 1 if nothing is proven
  Point position{};
  double p = 0, q = 0;  ///< of the deviator there, in the units of the input
};

/// An edge of the refined mesh whose ends differ in their labels, or that a page crosses twice. Its
/// crossings are the pages between the sectors, in order from the lower to the higher end, then the
/// level sets, in order of the table, then the pages that cross it twice, each with both crossings.
struct CrossedEdge {
  std::array<VertexId, 2> ends;  ///< ascending
  std::int8_t rotation = 0;      ///< pages crossed, positive counter-clockwise
  bool open = false;             ///< the side of the spine could not be decided
  FeatureSet levels = 0;         ///< level sets crossed
  FeatureSet doubles = 0;        ///< degenerate pages that cross it twice; none of the rotation's
  std::uint32_t first = 0;       ///< its first crossing

  int pages() const { return rotation < 0 ? -rotation : rotation; }
  int count() const { return pages() + std::popcount(levels) + 2 * std::popcount(doubles); }
};

/// All crossed edges of the complex, each once, with their crossings.
class EdgeCrossings {
 public:
  /// Crossings of pages outside `features` get no position. Keeps the table and the labels.
  EdgeCrossings(const RefinedComplex& complex, const FeatureTable& table,
                const VertexLabels& labels, const std::vector<std::uint32_t>& active_leaves,
                FeatureSet features, SignStages& stages);

  const FeatureTable& table() const { return table_; }
  const VertexLabels& labels() const { return labels_; }
  const std::vector<CrossedEdge>& edges() const { return edges_; }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  /// The edge between two vertices, or nullptr if it is not crossed. \pre a < b.
  const CrossedEdge* find(VertexId a, VertexId b) const;
  /// The pages and level sets that cross an edge.
  FeatureSet features_on(const CrossedEdge& edge) const;
  /// The crossing of a feature on an edge, the first one if there are two; -1 if there is none.
  int crossing_of(const CrossedEdge& edge, Feature feature) const;
  /// Whether the edge, from its lower to its higher end, meets the feature in the sense in which
  /// its surface is oriented: counter-clockwise; out of the convex set. At the first crossing, if
  /// there are two: the second one is the other way. \pre it crosses the edge.
  bool ascends(const CrossedEdge& edge, Feature feature) const;

 private:
  CrossedEdge classify(const RefinableField& field, const std::array<VertexId, 2>& ends,
                       SignStages& stages) const;
  std::optional<int> end_crossed(const Simplex<2>& edge, Feature page) const;
  void locate(const RefinableField& field, const CrossedEdge& edge, FeatureSet features);
  void set_crossing(const RefinableField& field, const Simplex<2>& edge, Feature feature,
                    const EdgeRoot& root, Crossing& crossing) const;

  const FeatureTable& table_;
  const VertexLabels& labels_;
  std::vector<CrossedEdge> edges_;
  std::vector<Crossing> crossings_;
  std::vector<std::uint32_t> first_edge_;  // per vertex: its first edge as lower end
};

}  // namespace triplex

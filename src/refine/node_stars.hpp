// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "exact_points.hpp"
#include "triplex/certify/node.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {

/// The sector on the real side of a degenerate page: a node belongs to its closure, and so does a
/// whole ring around the node.
Sector real_side(const FeatureTable& table, Feature page);

/// Nodes on their way to becoming vertices of the refined mesh: those proven to lie inside a tet of
/// the input. Each gets a vertex, known by an enclosure; the leaf that holds it is replaced by the
/// four tets around it as soon as these can be certified. Source: proofs/star.md.
class NodeStars {
 public:
  NodeStars(RefinedComplex& complex, const FeatureTable& table, FeatureSet features);

  /// Looks for nodes in tets of the input that were not searched before, in ascending order. Those
  /// inside get vertices, with labels; returns those in faces and edges whose place is known
  /// exactly.
  std::vector<ExactPoint> search(std::span<const TetId> tets, SignStages& stages);
  /// The node to be planted in a leaf, if any is ready. Only reads.
  std::optional<VertexId> ready_in(const Leaf& leaf, SignStages& stages) const;
  void mark_planted(VertexId node);

 private:
  /// A node of one tet: its vertex, and the ranges of its barycentric coordinates there.
  struct Waiting {
    VertexId vertex;
    std::array<VertexId, 4> tet;
    std::array<Range, 4> coordinates;
    std::array<ExactRange, 4> weights;  // the same, narrower
  };
  bool holds(const Leaf& leaf, const Waiting& node) const;
  bool only_its_page_near(const Leaf& leaf, VertexId node, SignStages& stages) const;

  RefinedComplex& complex_;
  const FeatureTable& table_;
  const FeatureSet features_;  // the degenerate pages among those requested
  std::unordered_map<TetId, std::vector<Waiting>> waiting_;
};

}  // namespace triplex

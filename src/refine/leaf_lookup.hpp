// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bisection.hpp"

namespace triplex {

/// Finds the leaves around an edge through the tets of the input: every leaf lies in one, so a
/// round costs as much as its marks, not as the whole mesh.
class LeafLookup {
 public:
  /// The leaves are the tets of the input, in order.
  explicit LeafLookup(const RefinableField& field);

  /// A leaf was appended at the end; `sibling` lies in the same tet of the input.
  void add_leaf(std::uint32_t sibling);

  /// The leaves in the tets of the input that have all these vertices as corners.
  std::vector<std::uint32_t> leaves_around(std::span<const VertexId> corners,
                                           const RefinableField& field) const;

  /// The leaves that hold a marked edge, ascending.
  std::vector<std::uint32_t> leaves_with(const MarkedEdges& marked, const RefinableField& field,
                                         const std::vector<Leaf>& leaves) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  void add_tets_around(std::span<const VertexId> corners, const RefinableField& field,
                       std::vector<std::uint32_t>& out) const;

  std::vector<std::uint32_t> first_, tets_;  // per vertex of the input: the tets that hold it
  std::vector<std::uint32_t> next_;          // the next leaf in the same tet of the input
};

}  // namespace triplex

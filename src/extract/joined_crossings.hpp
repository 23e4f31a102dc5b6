// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "cell_patches.hpp"

namespace triplex {

/// Where each crossing lies, and which vertices of patches are one point: the edges from a node
/// into the complex domain all cross the surface at the node; at an isotropic vertex all pages and
/// the triple degenerate curve meet.
struct JoinedCrossings {
  JoinedCrossings(const RefinedComplex& complex, const EdgeCrossings& crossings,
                  const FaceSpinePoints& spine_points);

  std::vector<std::uint32_t> edge_of;  ///< crossing -> its edge
  std::vector<std::uint32_t> joined;   ///< crossing -> the first one at the same node, else itself
  std::vector<bool> at_node;           ///< per crossing: at a node or an isotropic vertex

  /// The node or isotropic vertex at which a crossing lies. \pre `at_node`
  VertexId vertex_of(const EdgeCrossings& crossings, std::uint32_t crossing) const {
    return crossings.edges()[edge_of[crossing]]
        .ends[crossings.crossings()[crossing].t == 1 ? 1 : 0];
  }
  /// The crossing that stands for all at a node or isotropic vertex, if there are any.
  std::optional<std::uint32_t> at_vertex(VertexId v) const {
    const auto found = first_.find(v);
    return found == first_.end() ? std::nullopt : std::optional(found->second);
  }

  /// The one that stands for all that are the same point.
  PatchVertex operator()(PatchVertex v) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::unordered_map<VertexId, std::uint32_t> first_;  // by node or isotropic vertex
  std::vector<std::uint32_t> of_spine_point_;          // the crossing that stands for it, or kNone
};

}  // namespace triplex

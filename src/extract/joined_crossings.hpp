// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "edge_crossings.hpp"

namespace triplex {

/// Where each crossing lies, and which of them are one point: the edges from a node into the
/// complex domain all cross the surface at the node.
struct JoinedCrossings {
  JoinedCrossings(const RefinedComplex& complex, const EdgeCrossings& crossings);

  std::vector<std::uint32_t> edge_of;  ///< crossing -> its edge
  std::vector<std::uint32_t> joined;   ///< crossing -> the first one at the same node, else itself
  std::vector<bool> at_node;           ///< per crossing
};

}  // namespace triplex

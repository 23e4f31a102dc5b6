// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "vertex_labels.hpp"

namespace triplex {

/// The edges of active tets whose ends differ in some label, by their lower ends: the upper ends of
/// those of vertex v are upper[first[v]], ..., upper[first[v + 1] - 1], ascending, each once.
struct EdgeTable {
  std::vector<std::uint32_t> first;
  std::vector<VertexId> upper;
};

/// Time linear in vertices and active tets. The same table for any number of threads.
EdgeTable crossed_edges(const RefinedComplex& complex, const VertexLabels& labels,
                        const std::vector<std::uint32_t>& active_leaves);

}  // namespace triplex

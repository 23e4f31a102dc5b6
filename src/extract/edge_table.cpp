// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_table.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>

namespace triplex {
namespace {

/// Calls take(lower, upper) for every such edge of every tet whose lower end lies in [low, high).
template <class Take>
void for_each_edge(const RefinedComplex& complex, const VertexLabels& labels,
                   const std::vector<std::uint32_t>& active_leaves, std::size_t low,
                   std::size_t high, const Take& take) {
  for (const std::uint32_t n : active_leaves) {
    const auto& v = complex.leaves[n].vertices;
    for (int i = 0; i < 3; ++i) {
      if (index(v[i]) < low || index(v[i]) >= high) continue;
      for (int j = i + 1; j < 4; ++j)
        if (labels.crossed(v[i], v[j])) take(index(v[i]), v[j]);
    }
  }
}

}  // namespace

EdgeTable crossed_edges(const RefinedComplex& complex, const VertexLabels& labels,
                        const std::vector<std::uint32_t>& active_leaves) {
  const std::size_t vertices = complex.field.vertex_count();
  std::vector<std::uint32_t> first(vertices + 1, 0), count(vertices, 0);
  std::vector<VertexId> upper;
  // Every thread takes a range of lower ends and looks at all tets: no two write to one place.
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t parts = std::clamp<std::size_t>(threads, 1, 8);
  const auto in_parts = [&](const auto& work) {
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
      work(part * vertices / parts, (part + 1) * vertices / parts);
    });
  };
  in_parts([&](std::size_t low, std::size_t high) {
    for_each_edge(complex, labels, active_leaves, low, high,
                  [&](std::size_t v, VertexId) { first[v + 1] += 1; });
  });
  for (std::size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  upper.resize(first.back());
  in_parts([&](std::size_t low, std::size_t high) {
    for_each_edge(complex, labels, active_leaves, low, high,
                  [&](std::size_t v, VertexId w) { upper[first[v] + count[v]++] = w; });
    for (std::size_t v = low; v < high; ++v) {
      const auto begin = upper.begin() + first[v], end = begin + count[v];
      std::sort(begin, end);
      count[v] = static_cast<std::uint32_t>(std::unique(begin, end) - begin);
    }
  });
  EdgeTable table{std::vector<std::uint32_t>(vertices + 1, 0), {}};
  for (std::size_t v = 0; v < vertices; ++v) table.first[v + 1] = table.first[v] + count[v];
  table.upper.resize(table.first.back());
  for (std::size_t v = 0; v < vertices; ++v)
    std::copy_n(upper.begin() + first[v], count[v], table.upper.begin() + table.first[v]);
  return table;
}

}  // namespace triplex

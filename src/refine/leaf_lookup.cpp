// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "leaf_lookup.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

namespace triplex {
namespace {

using Lists = tbb::enumerable_thread_specific<std::vector<std::uint32_t>>;

/// Everything that the threads found, ascending, each once.
std::vector<std::uint32_t> joined(const Lists& lists) {
  std::vector<std::uint32_t> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  tbb::parallel_sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

LeafLookup::LeafLookup(const RefinableField& field)
    : first_(field.input_vertex_count() + 1, 0),
      tets_(4 * field.input_tets().size()),
      next_(field.input_tets().size(), kNone) {
  const auto& tets = field.input_tets();
  // Every thread takes a range of vertices and looks at all tets: no two write to one place.
  const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t parts = std::clamp<std::size_t>(threads, 1, 8);
  const auto for_each_corner = [&](const auto& take) {
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t part) {
      const std::size_t low = part * field.input_vertex_count() / parts;
      const std::size_t high = (part + 1) * field.input_vertex_count() / parts;
      for (std::size_t t = 0; t < tets.size(); ++t)
        for (const VertexId v : tets[t])
          if (index(v) >= low && index(v) < high) take(index(v), static_cast<std::uint32_t>(t));
    });
  };
  for_each_corner([&](std::size_t v, std::uint32_t) { first_[v] += 1; });
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  // Filled from the back, which leaves every start in its place.
  for_each_corner([&](std::size_t v, std::uint32_t t) { tets_[--first_[v]] = t; });
}

void LeafLookup::add_leaf(std::uint32_t sibling) {
  next_.push_back(next_[sibling]);
  next_[sibling] = static_cast<std::uint32_t>(next_.size() - 1);
}

void LeafLookup::add_tets_around(std::span<const VertexId> corners, const RefinableField& field,
                                 std::vector<std::uint32_t>& out) const {
  const std::size_t v = index(corners.front());
  for (std::uint32_t n = first_[v]; n < first_[v + 1]; ++n) {
    const auto& tet = field.input_tets()[tets_[n]];
    const auto has = [&](VertexId corner) {
      return std::find(tet.begin(), tet.end(), corner) != tet.end();
    };
    if (std::ranges::all_of(corners, has)) out.push_back(tets_[n]);
  }
}

std::vector<std::uint32_t> LeafLookup::leaves_around(std::span<const VertexId> corners,
                                                     const RefinableField& field) const {
  std::vector<std::uint32_t> tets, leaves;
  add_tets_around(corners, field, tets);
  for (const std::uint32_t tet : tets)
    for (std::uint32_t leaf = tet; leaf != kNone; leaf = next_[leaf]) leaves.push_back(leaf);
  return leaves;
}

std::vector<std::uint32_t> LeafLookup::leaves_with(const MarkedEdges& marked,
                                                   const RefinableField& field,
                                                   const std::vector<Leaf>& leaves) const {
  Lists tets_around;
  const auto& marks = marked.entries();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, marks.size(), 64), [&](const auto& range) {
    auto& mine = tets_around.local();
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      // A tet of the input that holds the edge has every corner that its ends are combined of.
      auto corners = field.corners(marks[n].edge[0]);
      for (const VertexId corner : field.corners(marks[n].edge[1])) corners.push_back(corner);
      add_tets_around(corners, field, mine);
    }
  });
  const std::vector<std::uint32_t> tets = joined(tets_around);

  Lists found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tets.size(), 64), [&](const auto& range) {
    auto& mine = found.local();
    for (std::size_t n = range.begin(); n < range.end(); ++n)
      for (std::uint32_t leaf = tets[n]; leaf != kNone; leaf = next_[leaf])
        if (marked.touches(leaves[leaf]) && marked.first_in(leaves[leaf]) != nullptr)
          mine.push_back(leaf);
  });
  return joined(found);
}

}  // namespace triplex

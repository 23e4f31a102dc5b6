// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_crossings.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "edge_root.hpp"
#include "triplex/certify/edge_side.hpp"

namespace triplex {
namespace {

constexpr std::size_t kGrain = 256;

using Ends = std::array<VertexId, 2>;

/// The edges of active tets whose ends differ in sector, sorted, each once.
std::vector<Ends> crossed_ends(const RefinedComplex& complex, const std::vector<Sector>& labels,
                               const std::vector<std::uint32_t>& active_leaves) {
  tbb::enumerable_thread_specific<std::vector<Ends>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, active_leaves.size(), kGrain),
                    [&](const auto& range) {
                      auto& mine = found.local();
                      for (std::size_t n = range.begin(); n < range.end(); ++n) {
                        const auto& v = complex.leaves[active_leaves[n]].vertices;
                        for (int i = 0; i < 4; ++i)
                          for (int j = i + 1; j < 4; ++j)
                            if (labels[index(v[i])] != labels[index(v[j])])
                              mine.push_back({v[i], v[j]});
                      }
                    });
  std::vector<Ends> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  tbb::parallel_sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

EdgeCrossings::EdgeCrossings(const RefinedComplex& complex, const std::vector<Sector>& labels,
                             const std::vector<std::uint32_t>& active_leaves, FeatureSet features,
                             SignStages& stages) {
  const std::vector<Ends> ends = crossed_ends(complex, labels, active_leaves);
  edges_.resize(ends.size());
  tbb::enumerable_thread_specific<SignStages> stages_per_thread;
  const tbb::blocked_range<std::size_t> all(0, ends.size(), kGrain);

  // Rotations first, then room for the crossings, then their positions.
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const auto [a, b] = ends[n];
      const Sector from = labels[index(a)], to = labels[index(b)];
      const auto rotation =
          rotation_along(complex.field, a, b, from, to, stages_per_thread.local());
      // An open side still needs one value that both neighbours share: the short way round.
      int turn = (index(to) - index(from) + kPages) % kPages;
      if (turn > kPages / 2) turn -= kPages;
      edges_[n] = {ends[n], static_cast<std::int8_t>(rotation.value_or(turn)), !rotation, 0};
    }
  });
  std::uint32_t count = 0;
  for (CrossedEdge& edge : edges_) {
    edge.first = count;
    count += static_cast<std::uint32_t>(edge.count());
  }
  crossings_.resize(count);
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const CrossedEdge& edge = edges_[n];
      const Simplex<2> simplex(complex.field, edge.ends);
      for (int i = 0; i < edge.count(); ++i) {
        const Feature page = page_crossed(labels[index(edge.ends[0])], edge.rotation, i);
        Crossing& crossing = crossings_[edge.first + static_cast<std::uint32_t>(i)];
        crossing.page = page;
        if (!(features & bit(page))) continue;
        const EdgeRoot root = find_crossing(simplex, page, edge.rotation > 0);
        crossing.t = root.t;
        crossing.error = root.error;
      }
    }
  });
  for (const SignStages& s : stages_per_thread) stages += s;

  first_edge_.assign(complex.field.vertex_count() + 1, 0);
  for (const CrossedEdge& edge : edges_) first_edge_[index(edge.ends[0]) + 1] += 1;
  for (std::size_t v = 1; v < first_edge_.size(); ++v) first_edge_[v] += first_edge_[v - 1];
}

const CrossedEdge* EdgeCrossings::find(VertexId a, VertexId b) const {
  const auto begin = edges_.begin() + first_edge_[index(a)];
  const auto end = edges_.begin() + first_edge_[index(a) + 1];
  const auto at = std::lower_bound(
      begin, end, b, [](const CrossedEdge& e, VertexId key) { return e.ends[1] < key; });
  return at != end && at->ends[1] == b ? &*at : nullptr;
}

int EdgeCrossings::crossing_of(const CrossedEdge& edge, Sector sector, Feature page) {
  const int k = static_cast<int>(page), from = index(sector);
  const int i = edge.rotation > 0 ? (k - from - 1 + kPages) % kPages : (from - k + kPages) % kPages;
  return i < edge.count() ? static_cast<int>(edge.first) + i : -1;
}

Point EdgeCrossings::position(const RefinedComplex& complex, std::size_t edge,
                              const Crossing& crossing) const {
  const Point a = complex.field.position(edges_[edge].ends[0]);
  const Point b = complex.field.position(edges_[edge].ends[1]);
  Point x;
  for (int k = 0; k < 3; ++k) x[k] = a[k] + crossing.t * (b[k] - a[k]);
  return x;
}

}  // namespace triplex

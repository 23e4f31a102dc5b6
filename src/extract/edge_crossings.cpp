// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_crossings.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>

#include "edge_root.hpp"
#include "level_root.hpp"
#include "triplex/certify/edge_side.hpp"

namespace triplex {
namespace {

constexpr std::size_t kGrain = 256;

using Ends = std::array<VertexId, 2>;

/// The edges of active tets whose ends differ in some label, sorted, each once.
std::vector<Ends> crossed_ends(const RefinedComplex& complex, const VertexLabels& labels,
                               const std::vector<std::uint32_t>& active_leaves) {
  tbb::enumerable_thread_specific<std::vector<Ends>> found;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, active_leaves.size(), kGrain),
                    [&](const auto& range) {
                      auto& mine = found.local();
                      for (std::size_t n = range.begin(); n < range.end(); ++n) {
                        const auto& v = complex.leaves[active_leaves[n]].vertices;
                        for (int i = 0; i < 4; ++i)
                          for (int j = i + 1; j < 4; ++j)
                            if (!labels.agree(v[i], v[j])) mine.push_back({v[i], v[j]});
                      }
                    });
  std::vector<Ends> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  tbb::parallel_sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

EdgeCrossings::EdgeCrossings(const RefinedComplex& complex, const FeatureTable& table,
                             const VertexLabels& labels,
                             const std::vector<std::uint32_t>& active_leaves, FeatureSet features,
                             SignStages& stages)
    : table_(table), labels_(labels) {
  const std::vector<Ends> ends = crossed_ends(complex, labels, active_leaves);
  edges_.resize(ends.size());
  tbb::enumerable_thread_specific<SignStages> stages_per_thread;
  const tbb::blocked_range<std::size_t> all(0, ends.size(), kGrain);

  // Rotations first, then room for the crossings, then their positions.
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n)
      edges_[n] = classify(complex.field, ends[n], stages_per_thread.local());
  });
  std::uint32_t count = 0;
  for (CrossedEdge& edge : edges_) {
    edge.first = count;
    count += static_cast<std::uint32_t>(edge.count());
  }
  crossings_.resize(count);
  tbb::parallel_for(all, [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n)
      locate(complex.field, edges_[n], features);
  });
  for (const SignStages& s : stages_per_thread) stages += s;

  first_edge_.assign(complex.field.vertex_count() + 1, 0);
  for (const CrossedEdge& edge : edges_) first_edge_[index(edge.ends[0]) + 1] += 1;
  for (std::size_t v = 1; v < first_edge_.size(); ++v) first_edge_[v] += first_edge_[v - 1];
}

CrossedEdge EdgeCrossings::classify(const RefinableField& field, const Ends& ends,
                                    SignStages& stages) const {
  const auto [a, b] = ends;
  const Sector from = labels_.sector(a), to = labels_.sector(b);
  const auto rotation = rotation_along(field, a, b, from, to, table_, stages);
  // An open side still needs one value that both neighbours share: the short way round.
  const int pages = table_.page_count();
  int turn = (index(to) - index(from) + pages) % pages;
  if (turn > pages / 2) turn -= pages;
  return {.ends = ends,
          .rotation = static_cast<std::int8_t>(rotation.value_or(turn)),
          .open = !rotation,
          .levels = labels_.inside_of(a) ^ labels_.inside_of(b)};
}

void EdgeCrossings::locate(const RefinableField& field, const CrossedEdge& edge,
                           FeatureSet features) {
  Crossing* crossing = &crossings_[edge.first];
  const auto set = [&](Feature feature, const EdgeRoot& root) {
    *crossing++ = {feature, root.t, root.error};
  };
  const Simplex<2> simplex(field, edge.ends);
  for (int i = 0; i < edge.pages(); ++i) {
    const Feature page = page_crossed(table_, labels_.sector(edge.ends[0]), edge.rotation, i);
    set(page, contains(features, page) ? find_crossing(simplex, table_, page, edge.rotation > 0)
                                       : EdgeRoot{});
  }
  for (FeatureSet rest = edge.levels; rest != 0; rest &= rest - 1) {
    const auto feature = static_cast<Feature>(std::countr_zero(rest));
    set(feature, find_level_crossing(field, edge.ends, table_.row(feature).level,
                                     contains(labels_.inside_of(edge.ends[0]), feature)));
  }
}

const CrossedEdge* EdgeCrossings::find(VertexId a, VertexId b) const {
  const auto begin = edges_.begin() + first_edge_[index(a)];
  const auto end = edges_.begin() + first_edge_[index(a) + 1];
  const auto at = std::lower_bound(
      begin, end, b, [](const CrossedEdge& e, VertexId key) { return e.ends[1] < key; });
  return at != end && at->ends[1] == b ? &*at : nullptr;
}

FeatureSet EdgeCrossings::features_on(const CrossedEdge& edge) const {
  return edge.levels | pages_crossed(table_, labels_.sector(edge.ends[0]), edge.rotation);
}

int EdgeCrossings::crossing_of(const CrossedEdge& edge, Feature feature) const {
  if (contains(edge.levels, feature))
    return static_cast<int>(edge.first) + edge.pages() +
           std::popcount(edge.levels & (bit(feature) - 1));
  const int k = table_.position(feature);
  if (k < 0) return -1;
  const int from = index(labels_.sector(edge.ends[0])), pages = table_.page_count();
  const int i = edge.rotation > 0 ? (k - from - 1 + pages) % pages : (from - k + pages) % pages;
  return i < edge.pages() ? static_cast<int>(edge.first) + i : -1;
}

bool EdgeCrossings::ascends(const CrossedEdge& edge, Feature feature) const {
  if (contains(edge.levels, feature))
    return contains(labels_.inside_of(edge.ends[0]), feature);
  return edge.rotation > 0;
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

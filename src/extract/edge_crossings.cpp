// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_crossings.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "edge_root.hpp"
#include "edge_table.hpp"
#include "level_root.hpp"
#include "triplex/certify/degenerate_roots.hpp"
#include "triplex/certify/edge_side.hpp"

namespace triplex {
namespace {

constexpr std::size_t kGrain = 256;

/// p and q of the deviator on an edge, in the units of the input.
std::array<double, 2> invariants_at(const Simplex<2>& edge, double t) {
  const auto& f = edge.approximate();
  const double s = 1 - t;
  const double P = s * s * f.p[0] + 2 * s * t * f.p[1] + t * t * f.p[2];
  const double Q =
      s * s * s * f.q[0] + 3 * s * s * t * f.q[1] + 3 * s * t * t * f.q[2] + t * t * t * f.q[3];
  // P = 18 p and Q = 162 q of the field scaled by a power of two.
  const int e = edge.field().scale_exponent();
  return {std::ldexp(P / 18, -2 * e), std::ldexp(Q / 162, -3 * e)};
}

}  // namespace

EdgeCrossings::EdgeCrossings(const RefinedComplex& complex, const FeatureTable& table,
                             const VertexLabels& labels,
                             const std::vector<std::uint32_t>& active_leaves, FeatureSet features,
                             SignStages& stages)
    : table_(table), labels_(labels) {
  EdgeTable edge_table = crossed_edges(complex, labels, active_leaves);
  first_edge_ = std::move(edge_table.first);
  edges_.resize(edge_table.upper.size());
  tbb::enumerable_thread_specific<SignStages> stages_per_thread;
  const tbb::blocked_range<std::size_t> all(0, edges_.size(), kGrain);
  const tbb::blocked_range<std::size_t> vertices(0, first_edge_.size() - 1, kGrain);

  // Rotations first, then room for the crossings, then their positions.
  tbb::parallel_for(vertices, [&](const auto& range) {
    SignStages& mine = stages_per_thread.local();
    for (std::size_t v = range.begin(); v < range.end(); ++v)
      for (std::uint32_t n = first_edge_[v]; n < first_edge_[v + 1]; ++n)
        edges_[n] = classify(complex.field, {VertexId(v), edge_table.upper[n]}, mine);
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
}

CrossedEdge EdgeCrossings::classify(const RefinableField& field,
                                    const std::array<VertexId, 2>& ends, SignStages& stages) const {
  const auto [a, b] = ends;
  const Sector from = labels_.sector(a), to = labels_.sector(b);
  const auto rotation = rotation_along(field, a, b, from, to, table_, stages);
  // An open side still needs one value that both neighbours share: the short way round.
  const int pages = table_.page_count();
  int turn = (index(to) - index(from) + pages) % pages;
  if (turn > pages / 2) turn -= pages;
  return {.ends = ends,
          .rotation = static_cast<std::int8_t>(rotation.value_or(turn)),
          // At an isotropic vertex any value serves: these crossings are all put there.
          .open = !rotation && !field.is_isotropic(a) && !field.is_isotropic(b),
          .levels = labels_.inside_of(a) ^ labels_.inside_of(b),
          .doubles = labels_.doubles_on(ends)};
}

/// The end at which a page crosses: any page at an isotropic vertex; at a node its degenerate page,
/// in no plane that it might cross elsewhere.
std::optional<int> EdgeCrossings::end_crossed(const Simplex<2>& edge, Feature page) const {
  for (int end = 0; end < 2; ++end)
    if (edge.field().is_isotropic(edge.vertices()[static_cast<std::size_t>(end)])) return end;
  const int node = edge.node_vertex();
  if (node == 2 || edge.block_axis() >= 0) return {};
  const VertexId v = edge.vertices()[static_cast<std::size_t>(node)];
  const Feature at_node = table_.sign_q(labels_.sector(v)) == Sign::Positive
                              ? Feature::DegenerateLinear
                              : Feature::DegeneratePlanar;
  return page == at_node ? std::optional(node) : std::nullopt;
}

void EdgeCrossings::set_crossing(const RefinableField& field, const Simplex<2>& edge,
                                 Feature feature, const EdgeRoot& root, Crossing& crossing) const {
  const Point a = field.position(edge.vertices()[0]), b = field.position(edge.vertices()[1]);
  const auto [p, q] = invariants_at(edge, root.t);
  crossing = {feature, root.t, root.error, {}, p, q};
  for (std::size_t k = 0; k < 3; ++k) crossing.position[k] = a[k] + root.t * (b[k] - a[k]);
}

void EdgeCrossings::locate(const RefinableField& field, const CrossedEdge& edge,
                           FeatureSet features) {
  Crossing* crossing = &crossings_[edge.first];
  const Simplex<2> simplex(field, edge.ends);
  const auto set = [&](Feature feature, const EdgeRoot& root) {
    set_crossing(field, simplex, feature, root, *crossing++);
  };
  for (int i = 0; i < edge.pages(); ++i) {
    const Feature page = page_crossed(table_, labels_.sector(edge.ends[0]), edge.rotation, i);
    const auto end = end_crossed(simplex, page);
    set(page, end ? EdgeRoot{static_cast<double>(*end), 0}
              : !contains(features, page)
                  ? EdgeRoot{}
                  : find_crossing(simplex, table_, page, edge.rotation > 0));
  }
  for (FeatureSet rest = edge.levels; rest != 0; rest &= rest - 1) {
    const auto feature = static_cast<Feature>(std::countr_zero(rest));
    set(feature, find_level_crossing(field, edge.ends, table_.row(feature).level,
                                     contains(labels_.inside_of(edge.ends[0]), feature)));
  }
  if (edge.doubles == 0) return;
  SignStages not_counted;
  const auto roots = isolate_degenerate_roots(simplex, not_counted);  // as when it was certified
  for (FeatureSet rest = edge.doubles; rest != 0; rest &= rest - 1) {
    const auto page = static_cast<Feature>(std::countr_zero(rest));
    for (int i = 0; i < roots->count; ++i)
      if (const DegenerateRoot& root = roots->roots[static_cast<std::size_t>(i)]; root.page == page)
        set(page, {root.t.middle(), root.t.hi - root.t.lo});
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
  return edge.levels | edge.doubles |
         pages_crossed(table_, labels_.sector(edge.ends[0]), edge.rotation);
}

int EdgeCrossings::crossing_of(const CrossedEdge& edge, Feature feature) const {
  if (contains(edge.levels, feature))
    return static_cast<int>(edge.first) + edge.pages() +
           std::popcount(edge.levels & (bit(feature) - 1));
  if (contains(edge.doubles, feature))
    return static_cast<int>(edge.first) + edge.pages() + std::popcount(edge.levels) +
           2 * std::popcount(edge.doubles & (bit(feature) - 1));
  const int k = table_.position(feature);
  if (k < 0) return -1;
  const int from = index(labels_.sector(edge.ends[0])), pages = table_.page_count();
  const int i = edge.rotation > 0 ? (k - from - 1 + pages) % pages : (from - k + pages) % pages;
  return i < edge.pages() ? static_cast<int>(edge.first) + i : -1;
}

bool EdgeCrossings::ascends(const CrossedEdge& edge, Feature feature) const {
  if (contains(edge.levels, feature)) return contains(labels_.inside_of(edge.ends[0]), feature);
  if (contains(edge.doubles, feature)) {
    // Counter-clockwise the linear page leads to the real side, the planar one away from it.
    const Domain domain = table_.domain(labels_.sector(edge.ends[0]));
    const bool from_real = domain == Domain::RealLinear || domain == Domain::RealPlanar;
    return from_real == (feature == Feature::DegeneratePlanar);
  }
  return edge.rotation > 0;
}

}  // namespace triplex

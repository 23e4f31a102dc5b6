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

EdgeCrossings::EdgeCrossings(const RefinedComplex& complex, const std::vector<Sector>& labels,
                             const std::vector<std::uint32_t>& active_leaves, FeatureSet features,
                             SignStages& stages) {
  EdgeTable table = crossed_edges(complex, labels, active_leaves);
  first_edge_ = std::move(table.first);
  edges_.resize(table.upper.size());
  tbb::enumerable_thread_specific<SignStages> stages_per_thread;
  const tbb::blocked_range<std::size_t> all(0, edges_.size(), kGrain);
  const tbb::blocked_range<std::size_t> vertices(0, first_edge_.size() - 1, kGrain);

  // Rotations first, then room for the crossings, then their positions.
  tbb::parallel_for(vertices, [&](const auto& range) {
    SignStages& mine = stages_per_thread.local();
    for (std::size_t v = range.begin(); v < range.end(); ++v)
      for (std::uint32_t n = first_edge_[v]; n < first_edge_[v + 1]; ++n) {
        const VertexId a{static_cast<std::uint32_t>(v)}, b = table.upper[n];
        const Sector from = labels[index(a)], to = labels[index(b)];
        const auto rotation = rotation_along(complex.field, a, b, from, to, mine);
        // An open side still needs one value that both neighbours share: the short way round.
        int turn = (index(to) - index(from) + kPages) % kPages;
        if (turn > kPages / 2) turn -= kPages;
        edges_[n] = {{a, b}, static_cast<std::int8_t>(rotation.value_or(turn)), !rotation, 0};
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
      const std::array<Point, 2> ends = {complex.field.position(edge.ends[0]),
                                         complex.field.position(edge.ends[1])};
      for (int i = 0; i < edge.count(); ++i) {
        const Feature page = page_crossed(labels[index(edge.ends[0])], edge.rotation, i);
        Crossing& crossing = crossings_[edge.first + static_cast<std::uint32_t>(i)];
        crossing.page = page;
        if (!(features & bit(page))) continue;
        const EdgeRoot root = find_crossing(simplex, page, edge.rotation > 0);
        crossing.t = root.t;
        crossing.error = root.error;
        const auto [p, q] = invariants_at(simplex, root.t);
        crossing.p = p;
        crossing.q = q;
        for (int k = 0; k < 3; ++k)
          crossing.position[k] = ends[0][k] + root.t * (ends[1][k] - ends[0][k]);
      }
    }
  });
  for (const SignStages& s : stages_per_thread) stages += s;
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

}  // namespace triplex

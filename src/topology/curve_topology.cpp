// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/curve_topology.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "compensated_sum.hpp"
#include "triplex/topology/disjoint_sets.hpp"

namespace triplex {
namespace {

void check_segment(const std::array<std::uint32_t, 2>& segment, std::size_t points) {
  if (segment[0] >= points || segment[1] >= points)
    throw std::invalid_argument("a segment's vertex is out of range");
  if (segment[0] == segment[1]) throw std::invalid_argument("a segment uses a vertex twice");
}

/// Walks along the segments, each once.
class ChainWalk {
 public:
  ChainWalk(std::span<const std::array<std::uint32_t, 2>> segments, std::size_t points,
            std::span<const std::uint8_t> labels)
      : segments_(segments),
        labels_(labels),
        first_(points + 1, 0),
        at_(2 * segments.size()),
        used_(segments.size(), false) {
    for (const auto& segment : segments) {
      check_segment(segment, points);
      for (const std::uint32_t v : segment) ++first_[v + 1];
    }
    for (std::size_t v = 0; v < points; ++v) first_[v + 1] += first_[v];
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t s = 0; s < segments.size(); ++s)
      for (const std::uint32_t v : segments[s]) at_[next[v]++] = s;
  }

  std::vector<CurveChain> run() {
    std::vector<CurveChain> chains;
    for (const bool loops : {false, true})
      for (std::uint32_t v = 0; v + 1 < first_.size(); ++v)
        if (loops || is_end(v))
          for (const std::uint32_t s : segments_at(v))
            if (!used_[s]) chains.push_back(walk(v, s));
    return chains;
  }

 private:
  std::span<const std::uint32_t> segments_at(std::uint32_t v) const {
    return std::span(at_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  bool is_end(std::uint32_t v) const {
    const auto around = segments_at(v);
    return around.size() != 2 || (!labels_.empty() && labels_[around[0]] != labels_[around[1]]);
  }
  CurveChain walk(std::uint32_t v, std::uint32_t s) {
    const std::uint32_t start = v;
    CurveChain chain{{v}, {}};
    for (;;) {
      used_[s] = true;
      v = segments_[s][0] == v ? segments_[s][1] : segments_[s][0];
      chain.points.push_back(v);
      chain.segments.push_back(s);
      if (v == start || is_end(v)) return chain;
      const auto around = segments_at(v);
      s = around[0] == s ? around[1] : around[0];
    }
  }

  std::span<const std::array<std::uint32_t, 2>> segments_;
  std::span<const std::uint8_t> labels_;
  std::vector<std::size_t> first_;  // per point: its first place in `at_`
  std::vector<std::uint32_t> at_;
  std::vector<bool> used_;
};

}  // namespace

CurveTopology curve_topology(std::span<const std::array<std::uint32_t, 2>> segments,
                             std::size_t points) {
  DisjointSets sets(points);
  std::vector<std::uint32_t> degree(points, 0);
  for (const auto& [a, b] : segments) {
    check_segment({a, b}, points);
    ++degree[a];
    ++degree[b];
    sets.unite(a, b);
  }
  CurveTopology result;
  result.segments = segments.size();
  std::vector<bool> open(points, false);  // by the representative of the component
  for (std::uint32_t v = 0; v < points; ++v) {
    if (degree[v] == 0) continue;
    ++result.vertices;
    if (degree[v] == 1) ++result.ends;
    if (degree[v] > 2) ++result.branches;
    if (degree[v] != 2) open[sets.find(v)] = true;
  }
  for (std::uint32_t v = 0; v < points; ++v) {
    if (degree[v] == 0 || sets.find(v) != v) continue;
    ++result.components;
    if (!open[v]) ++result.closed;
  }
  return result;
}

std::vector<CurveChain> curve_chains(std::span<const std::array<std::uint32_t, 2>> segments,
                                     std::size_t points, std::span<const std::uint8_t> labels) {
  if (!labels.empty() && labels.size() != segments.size())
    throw std::invalid_argument("curve_chains: not one label per segment");
  return ChainWalk(segments, points, labels).run();
}

double length_approx(std::span<const Point> points,
                     std::span<const std::array<std::uint32_t, 2>> segments) {
  CompensatedSum sum;
  for (const auto& [a, b] : segments) {
    sum.add(std::hypot(points[b][0] - points[a][0], points[b][1] - points[a][1],
                       points[b][2] - points[a][2]));
  }
  return sum.value();
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/betti.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

#include "incidence.hpp"
#include "triplex/topology/disjoint_sets.hpp"

namespace triplex {
namespace {

using detail::Side;

/// A sum of unknowns that must vanish over Z/2: their numbers, ascending.
using Row = std::vector<std::uint32_t>;

/// The chains of triangles without boundary. There is one unknown per triangle; an edge of one
/// triangle makes it zero, an edge of two makes them equal, and what then remains are the equations
/// of the edges of three and more.
class Cycles {
 public:
  // Member 0 of the sets is the constant zero, triangle t is member t + 1.
  explicit Cycles(std::size_t triangles) : sets_(triangles + 1) {}

  void add_edge(std::span<const Side> sides) {
    if (sides.size() == 1) sets_.unite(0, sides[0].triangle + 1);
    if (sides.size() == 2) sets_.unite(sides[0].triangle + 1, sides[1].triangle + 1);
    if (sides.size() < 3) return;
    Row& row = rows_.emplace_back();
    for (const Side& side : sides) row.push_back(side.triangle + 1);
  }

  std::uint64_t dimension(const std::vector<bool>& repeated) {
    simplify();
    std::uint64_t unknowns = 0;
    for (std::uint32_t t = 0; t < repeated.size(); ++t)
      if (!repeated[t] && sets_.find(t + 1) == t + 1) ++unknowns;
    return unknowns - rank();
  }

 private:
  /// In terms of the sets: each at most once, without zero.
  void reduce(Row& row) {
    for (std::uint32_t& x : row) x = sets_.find(x);
    std::ranges::sort(row);
    Row odd;
    for (std::size_t begin = 0, end = 0; begin < row.size(); begin = end) {
      while (end < row.size() && row[end] == row[begin]) ++end;
      if (row[begin] != 0 && (end - begin) % 2 == 1) odd.push_back(row[begin]);
    }
    row = std::move(odd);
  }

  /// Uses up equations in one or two unknowns. Each round may make more of them; what is left
  /// after a few is for the elimination, which needs none of this to be right.
  void simplify() {
    constexpr int kRounds = 8;
    bool changed = true;
    for (int round = 0; round < kRounds && changed; ++round) {
      changed = false;
      for (Row& row : rows_) {
        reduce(row);
        if (row.size() == 1) changed |= sets_.unite(0, row[0]);
        if (row.size() == 2) changed |= sets_.unite(row[0], row[1]);
      }
    }
    for (Row& row : rows_) reduce(row);
    std::ranges::sort(rows_);
    rows_.erase(std::unique(rows_.begin(), rows_.end()), rows_.end());
  }

  std::uint64_t rank() {
    std::unordered_map<std::uint32_t, Row> by_last;  // rows with distinct last unknowns
    for (Row& row : rows_) {
      for (auto other = by_last.end();
           !row.empty() && (other = by_last.find(row.back())) != by_last.end();) {
        Row sum;
        std::ranges::set_symmetric_difference(row, other->second, std::back_inserter(sum));
        row = std::move(sum);
      }
      if (!row.empty()) by_last.emplace(row.back(), std::move(row));
    }
    return by_last.size();
  }

  DisjointSets sets_;
  std::vector<Row> rows_;
};

/// Segments that are no side of a triangle, each once.
std::uint64_t free_segments(const MeshView& mesh, std::span<const Side> sides) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Edge> edges;
  for (const auto& [a, b] : mesh.segments) edges.push_back(std::minmax(a, b));
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto by_ends = [](const Side& s) { return Edge(s.low, s.high); };
  return static_cast<std::uint64_t>(std::ranges::count_if(edges, [&](const Edge& edge) {
    return !std::ranges::binary_search(sides, edge, {}, by_ends);
  }));
}

}  // namespace

BettiNumbers betti_numbers(const MeshView& mesh) {
  check_mesh(mesh);
  const std::vector<bool> repeated = detail::repeated_triangles(mesh.triangles);
  const std::vector<Side> sides = detail::sorted_sides(mesh.triangles, repeated);
  Cycles cycles(mesh.triangles.size());
  std::uint64_t edges = free_segments(mesh, sides);
  detail::for_each_edge(sides, [&](std::span<const Side> edge) {
    ++edges;
    cycles.add_edge(edge);
  });

  DisjointSets sets(mesh.points.size());
  std::vector<bool> used(mesh.points.size(), false);
  std::uint64_t vertices = 0;
  std::uint64_t joins = 0;
  const auto join = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const std::uint32_t v : cell) {
        if (!used[v]) ++vertices;
        used[v] = true;
        if (sets.unite(cell[0], v)) ++joins;
      }
  };
  join(mesh.triangles);
  join(mesh.segments);

  const auto triangles = static_cast<std::uint64_t>(std::ranges::count(repeated, false));
  BettiNumbers betti;
  betti.b0 = vertices - joins;
  betti.b2 = cycles.dimension(repeated);
  betti.b1 = betti.b0 + betti.b2 + edges - vertices - triangles;
  return betti;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "unresolved.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>

#include "triplex/certify/graph_margin.hpp"

namespace triplex {
namespace {

/// The tets that hold a node, ascending.
std::vector<TetId> tets_with_nodes(const std::vector<Node>& nodes) {
  std::vector<TetId> tets;
  for (const Node& node : nodes)
    if (node.status != NodeStatus::Shared) tets.push_back(node.tet);
  std::ranges::sort(tets);
  return tets;
}

/// The numbers of the open leaves, by tet of the input.
std::vector<std::uint32_t> open_leaves(const RefinedComplex& complex) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t n = 0; n < complex.leaves.size(); ++n)
    if (complex.leaves[n].open != 0) open.push_back(n);
  std::ranges::stable_sort(open, {}, [&](std::uint32_t n) { return complex.leaves[n].input; });
  return open;
}

double volume_approx(const RefinableField& field, const std::array<VertexId, 4>& vertices) {
  const Point origin = field.position(vertices[0]);
  std::array<Point, 3> e;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) e[i][k] = field.position(vertices[i + 1])[k] - origin[k];
  return std::fabs(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                   e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                   e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
}

/// Of the tet's volume.
double share_of(const RefinedComplex& complex, const Leaf& leaf) {
  const RefinableField& field = complex.field;
  return volume_approx(field, leaf.vertices) /
         volume_approx(field, field.input_tets()[index(leaf.input)]);
}

/// Place and size of the open leaves of one tet.
void add_place(const RefinedComplex& complex, std::span<const std::uint32_t> leaves,
               UnresolvedTet& tet) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  tet.extent.fill({kInfinity, -kInfinity});
  tet.open_cells = leaves.size();
  tet.smallest_share = kInfinity;
  for (const std::uint32_t n : leaves) {
    const Leaf& leaf = complex.leaves[n];
    tet.depth = std::max<std::uint32_t>(tet.depth, leaf.depth);
    const double share = share_of(complex, leaf);
    tet.open_share += share;
    tet.smallest_share = std::min(tet.smallest_share, share);
  }
  for (const std::uint32_t n : leaves) {
    const double share = share_of(complex, complex.leaves[n]);
    // Where their corners are too near for doubles they have no volume there, and count alike.
    const double weight =
        (tet.open_share > 0 ? share / tet.open_share : 1 / static_cast<double>(leaves.size())) / 4;
    for (const VertexId v : complex.leaves[n].vertices) {
      const Point x = complex.field.position(v);
      for (std::size_t k = 0; k < 3; ++k) {
        tet.centre[k] += weight * x[k];
        tet.extent[k] = {std::min(tet.extent[k].lo, x[k]), std::max(tet.extent[k].hi, x[k])};
      }
    }
  }
}

/// The margin of the largest open leaf; the first of several.
std::optional<double> margin_of(const RefinedComplex& complex,
                                std::span<const std::uint32_t> leaves, const FeatureTable& table) {
  const std::uint32_t n = *std::ranges::min_element(
      leaves, {}, [&](std::uint32_t k) { return complex.leaves[k].depth; });
  const Leaf& leaf = complex.leaves[n];
  return graph_margin_approx(complex.field, leaf.vertices, leaf.obstacle, leaf.open, table);
}

std::string reason_of(const UnresolvedTet& tet, Obstacle obstacle, bool has_node,
                      bool hit_size_limit, std::uint32_t budget) {
  std::string reason = has_node ? "contains a node; " : "";
  reason += describe(obstacle);
  if (hit_size_limit)
    reason += "; the refined mesh reached its size limit";
  else if (tet.bisections < budget)
    reason += "; its vertices are as near to each other as their weights allow";
  else
    reason += fmt::format("; budget of {} bisections spent", budget);
  for (int i = 0; i < kIdentities; ++i) {
    const auto identity = static_cast<Identity>(i);
    if (tet.touches & bit(identity))
      fmt::format_to(std::back_inserter(reason), "; touches a simplex that is {} throughout",
                     name_of(identity));
  }
  return reason;
}

}  // namespace

std::vector<UnresolvedTet> unresolved_tets(const TensorField& input, const RefinedComplex& complex,
                                           const std::vector<Node>& nodes,
                                           const IdenticalSimplices& identical,
                                           const FeatureTable& table) {
  const std::vector<TetId> with_nodes = tets_with_nodes(nodes);
  const std::vector<std::uint32_t> open = open_leaves(complex);
  std::vector<UnresolvedTet> result;
  for (std::size_t begin = 0; begin < open.size();) {
    const TetId id = complex.leaves[open[begin]].input;
    UnresolvedTet tet;
    tet.tet = id;
    tet.source_cell = input.source_cell(id);
    Obstacle gravest = complex.leaves[open[begin]].obstacle;
    std::size_t end = begin;
    for (; end < open.size() && complex.leaves[open[end]].input == id; ++end) {
      tet.features |= complex.leaves[open[end]].open;
      gravest = std::min(gravest, complex.leaves[open[end]].obstacle);
    }
    const auto leaves = std::span(open).subspan(begin, end - begin);
    add_place(complex, leaves, tet);
    tet.margin = margin_of(complex, leaves, table);
    tet.bisections = complex.budget.asked_for(id);
    for (const VertexId v : input.mesh.tets[index(id)])
      tet.touches |= identical.at_points[index(v)];
    tet.reason = reason_of(tet, gravest, std::ranges::binary_search(with_nodes, id),
                           complex.hit_size_limit, complex.budget.limit(id));
    result.push_back(std::move(tet));
    begin = end;
  }
  std::ranges::stable_sort(result, {}, &UnresolvedTet::source_cell);
  return result;
}

UnresolvedTet whole_tet(const TensorField& input, TetId tet) {
  UnresolvedTet open;
  open.tet = tet;
  open.source_cell = input.source_cell(tet);
  open.open_cells = 1;
  open.open_share = open.smallest_share = 1;
  open.extent.fill(
      {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  for (const VertexId v : input.mesh.tets[index(tet)]) {
    const Point& x = input.mesh.points[index(v)];
    for (std::size_t k = 0; k < 3; ++k) {
      open.centre[k] += x[k] / 4;
      open.extent[k] = {std::min(open.extent[k].lo, x[k]), std::max(open.extent[k].hi, x[k])};
    }
  }
  return open;
}

OpenCells open_cells(const TensorField& input, const RefinedComplex& complex, std::size_t most) {
  OpenCells cells;
  std::vector<std::uint32_t> open = open_leaves(complex);
  if (open.size() > most) {
    cells.left_out = open.size() - most;
    std::ranges::stable_sort(open, {}, [&](std::uint32_t n) { return complex.leaves[n].depth; });
    open.resize(most);
    std::ranges::stable_sort(open, {}, [&](std::uint32_t n) { return complex.leaves[n].input; });
  }
  constexpr std::uint32_t kUnused = 0xffffffff;
  std::vector<std::uint32_t> number(complex.field.vertex_count(), kUnused);
  for (const std::uint32_t n : open) {
    const Leaf& leaf = complex.leaves[n];
    std::array<std::uint32_t, 4> tet;
    for (std::size_t i = 0; i < 4; ++i) {
      const VertexId v = leaf.vertices[i];
      if (number[index(v)] == kUnused) {
        number[index(v)] = static_cast<std::uint32_t>(cells.points.size());
        cells.points.push_back(complex.field.position(v));
      }
      tet[i] = number[index(v)];
    }
    if (leaf.flipped) std::swap(tet[2], tet[3]);
    cells.tets.push_back(tet);
    cells.features.push_back(leaf.open);
    cells.obstacle.push_back(leaf.obstacle);
    cells.source_cell.push_back(input.source_cell(leaf.input));
    cells.depth.push_back(leaf.depth);
  }
  return cells;
}

}  // namespace triplex

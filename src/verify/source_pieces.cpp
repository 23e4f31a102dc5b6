// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "source_pieces.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex::detail {
namespace {

/// Some cells of a mesh with their points numbered from zero on.
template <std::size_t N>
std::pair<std::vector<std::array<std::uint32_t, N>>, std::size_t> renumbered(
    const std::vector<std::array<std::uint32_t, N>>& all, std::span<const std::uint32_t> chosen) {
  std::vector<std::array<std::uint32_t, N>> cells;
  std::vector<std::uint32_t> points;
  for (const std::uint32_t c : chosen) {
    cells.push_back(all[c]);
    points.insert(points.end(), all[c].begin(), all[c].end());
  }
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (auto& cell : cells)
    for (std::uint32_t& v : cell)
      v = static_cast<std::uint32_t>(std::ranges::lower_bound(points, v) - points.begin());
  return {std::move(cells), points.size()};
}

}  // namespace

SourcePieces::SourcePieces(const FeatureMesh& mesh)
    : mesh_(&mesh), order_(mesh.source_cell.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  const auto& source = mesh.source_cell;
  tbb::parallel_sort(order_, [&](std::uint32_t a, std::uint32_t b) {
    return source[a] != source[b] ? source[a] < source[b] : a < b;
  });
  for (std::size_t n = 0; n < order_.size(); ++n) {
    if (n > 0 && source[order_[n]] == source[order_[n - 1]]) continue;
    cells_.push_back(source[order_[n]]);
    begin_.push_back(n);
  }
  begin_.push_back(order_.size());
}

std::span<const std::uint32_t> SourcePieces::in(std::int64_t cell) const {
  const auto at = std::ranges::lower_bound(cells_, cell);
  if (at == cells_.end() || *at != cell) return {};
  const auto n = static_cast<std::size_t>(at - cells_.begin());
  return std::span(order_).subspan(begin_[n], begin_[n + 1] - begin_[n]);
}

PieceTopology SourcePieces::topology_in(std::int64_t cell) const {
  const auto chosen = in(cell);
  if (chosen.empty()) return {};
  if (is_curve()) {
    const auto [segments, points] = renumbered(mesh_->segments, chosen);
    const CurveTopology t = curve_topology(segments, points);
    return {static_cast<std::uint32_t>(t.components),
            static_cast<std::int32_t>(t.vertices) - static_cast<std::int32_t>(t.segments),
            static_cast<std::uint32_t>(t.ends)};
  }
  const auto [triangles, points] = renumbered(mesh_->triangles, chosen);
  const SurfaceTopology t = surface_topology(triangles, points);
  return {static_cast<std::uint32_t>(t.components), static_cast<std::int32_t>(t.euler),
          static_cast<std::uint32_t>(t.boundary_loops)};
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/quadric_comparison.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "source_pieces.hpp"

namespace triplex {
namespace {

std::vector<std::int64_t> cells_left_out(const TensorField& field,
                                         const QuadricExtraction& quadrics,
                                         std::span<const std::int64_t> open) {
  std::vector<std::int64_t> cells(open.begin(), open.end());
  for (const QuadricContact& c : quadrics.contacts) cells.push_back(field.source_cell(c.tet));
  for (const TetId t : quadrics.unmeshed) cells.push_back(field.source_cell(t));
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace

QuadricComparison compare_quadrics(const TensorField& field, const QuadricExtraction& quadrics,
                                   const FeatureMesh& mesh, std::span<const std::int64_t> open) {
  const detail::SourcePieces ours(quadrics.mesh), theirs(mesh);
  const auto left_out = cells_left_out(field, quadrics, open);
  std::vector<std::int64_t> cells;
  std::ranges::set_union(ours.cells(), theirs.cells(), std::back_inserter(cells));
  QuadricComparison r;
  r.left_out = left_out.size();
  for (const std::int64_t cell : cells) {
    if (std::ranges::binary_search(left_out, cell)) continue;
    ++r.compared;
    if (ours.topology_in(cell) != theirs.topology_in(cell)) r.differing.push_back(cell);
  }
  r.quadrics = surface_topology(quadrics.mesh.triangles, quadrics.mesh.points.size());
  r.mesh = surface_topology(mesh.triangles, mesh.points.size());
  return r;
}

QuadricComparison compare_part(const TensorField& field, const QuadricExtraction& quadrics,
                               const FeatureMesh& mesh, std::span<const std::int64_t> open) {
  std::vector<std::int64_t> cells(open.begin(), open.end());
  for (const QuadricContact& c : quadrics.curve_contacts) cells.push_back(field.source_cell(c.tet));
  for (const TetId t : quadrics.unsplit) cells.push_back(field.source_cell(t));
  return compare_quadrics(field, quadrics, mesh, cells);
}

MergedMesh merged(const FeatureMesh& a, const FeatureMesh& b) {
  MergedMesh result;
  FeatureMesh& r = result.mesh;
  r.points = a.points;
  r.points.insert(r.points.end(), b.points.begin(), b.points.end());
  std::vector<std::uint32_t> order(r.points.size()), first(r.points.size());
  std::vector<bool> ambiguous(r.points.size(), false);
  std::iota(order.begin(), order.end(), 0u);
  first = order;
  std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
    return r.points[i] != r.points[j] ? r.points[i] < r.points[j] : i < j;
  });
  for (std::size_t n = 0, end = 0; n < order.size(); n = end) {
    while (end < order.size() && r.points[order[end]] == r.points[order[n]]) ++end;
    if (order[n] >= a.points.size() || order[end - 1] < a.points.size()) continue;
    if (end == n + 2)
      first[order[n + 1]] = order[n];
    else
      for (std::size_t k = n; k < end; ++k) ambiguous[order[k]] = true;
  }
  const auto append = [&](const FeatureMesh& m, std::uint32_t offset) {
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
      std::array<std::uint32_t, 3> v = m.triangles[t];
      for (std::uint32_t& x : v) x += offset;
      if (ambiguous[v[0]] || ambiguous[v[1]] || ambiguous[v[2]])
        result.ambiguous.push_back(m.source_cell[t]);
      r.triangles.push_back({first[v[0]], first[v[1]], first[v[2]]});
    }
    r.source_cell.insert(r.source_cell.end(), m.source_cell.begin(), m.source_cell.end());
    r.certified.insert(r.certified.end(), m.certified.begin(), m.certified.end());
  };
  append(a, 0);
  append(b, static_cast<std::uint32_t>(a.points.size()));
  std::ranges::sort(result.ambiguous);
  result.ambiguous.erase(std::unique(result.ambiguous.begin(), result.ambiguous.end()),
                         result.ambiguous.end());
  return result;
}

}  // namespace triplex

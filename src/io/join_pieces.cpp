// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/input_check.hpp"
#include "vtk_grid.hpp"

namespace triplex::detail {
namespace {

void join_points(RawField& raw) {
  TensorField& field = raw.field;
  const auto& points = field.mesh.points;
  if (raw.copies.empty()) raw.copies.assign(points.size(), 0);
  // Only points that tets use: points of skipped cells may carry anything.
  std::vector<char> used(points.size(), 0);
  for (const auto& tet : field.mesh.tets) {
    for (const VertexId v : tet) used[index(v)] = 1;
  }
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (used[i]) ids.push_back(i);
  }
  // By place; at one place first those that their piece owns, then by id.
  tbb::parallel_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return points[a] < points[b];
    return raw.copies[a] != raw.copies[b] ? raw.copies[a] < raw.copies[b] : a < b;
  });
  std::vector<VertexId> target(points.size());
  for (std::size_t i = 0, j; i < ids.size(); i = j) {
    const std::uint32_t first = ids[i];
    for (j = i; j < ids.size() && points[ids[j]] == points[first]; ++j) {
      const std::uint32_t other = ids[j];
      const bool overruled = raw.copies[other] != raw.copies[first];
      if (!overruled && field.tensors[other] != field.tensors[first]) {
        throw BadInput(fmt::format(
            "the pieces disagree: points {} and {} both lie at ({}, {}, {}), but their tensors "
            "differ; the field must be continuous, average or correct the tensors",
            first, other, points[first][0], points[first][1], points[first][2]));
      }
      target[other] = VertexId{first};
    }
  }
  for (auto& tet : field.mesh.tets) {
    for (VertexId& v : tet) v = target[index(v)];
  }
}

/// Keeps the first of the tets that have the same four points.
void leave_out_repeated_cells(TensorField& field) {
  auto& tets = field.mesh.tets;
  struct Key {
    std::array<VertexId, 4> points;
    std::uint32_t tet;
  };
  std::vector<Key> keys(tets.size());
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    keys[t] = {tets[t], t};
    std::ranges::sort(keys[t].points);
  }
  tbb::parallel_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return a.points != b.points ? std::ranges::lexicographical_compare(a.points, b.points)
                                : a.tet < b.tet;
  });
  std::vector<char> keep(tets.size(), 1);
  bool repeated = false;
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].points != keys[i - 1].points) continue;
    keep[keys[i].tet] = 0;
    repeated = true;
  }
  if (!repeated) return;
  if (field.source_cells.empty()) {
    field.source_cells.resize(tets.size());
    std::iota(field.source_cells.begin(), field.source_cells.end(), 0);
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (!keep[t]) continue;
    tets[kept] = tets[t];
    field.source_cells[kept++] = field.source_cells[t];
  }
  tets.resize(kept);
  field.source_cells.resize(kept);
}

}  // namespace

TensorField join_pieces(RawField raw) {
  join_points(raw);
  leave_out_repeated_cells(raw.field);
  remove_unused_points(raw.field);
  return std::move(raw.field);
}

}  // namespace triplex::detail

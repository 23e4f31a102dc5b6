// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raw_field.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex::detail {
namespace {

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

std::vector<std::uint8_t> used_points(const TetMesh& mesh) {
  std::vector<std::uint8_t> used(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets) {
    for (const VertexId v : tet) used[index(v)] = 1;
  }
  return used;
}

std::vector<VertexId> joined_points(const RawField& raw,
                                    const std::function<bool(std::size_t, std::size_t)>& agree,
                                    std::string_view what) {
  const auto& points = raw.field.mesh.points;
  // Only points that tets use: points of skipped cells may carry anything.
  const auto used = used_points(raw.field.mesh);
  std::vector<std::uint32_t> ids;
  std::vector<VertexId> target(points.size());
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    target[i] = VertexId{i};
    if (!used[i]) continue;
    if (!std::ranges::all_of(points[i], [](double x) { return std::isfinite(x); })) {
      throw BadInput(
          fmt::format("point {} at ({}, {}, {}) has a coordinate that is not finite; correct or "
                      "remove the point",
                      i, points[i][0], points[i][1], points[i][2]));
    }
    ids.push_back(i);
  }
  const auto copy = [&](std::uint32_t i) { return raw.copies.empty() ? 0 : raw.copies[i]; };
  // By place; at one place first those that their piece owns, then by id.
  tbb::parallel_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a] != points[b]) return points[a] < points[b];
    return copy(a) != copy(b) ? copy(a) < copy(b) : a < b;
  });
  for (std::size_t i = 0, j; i < ids.size(); i = j) {
    const std::uint32_t first = ids[i];
    for (j = i + 1; j < ids.size() && points[ids[j]] == points[first]; ++j) {
      const std::uint32_t other = ids[j];
      const bool overruled = copy(other) != copy(first);
      if (!overruled && !agree(other, first)) {
        throw BadInput(fmt::format(
            "{}points {} and {} both lie at ({}, {}, {}), but their {} differ; the field must be "
            "continuous, average them or compute them on the whole mesh (a gradient: with "
            "--gradient-of)",
            raw.pieces ? "the pieces disagree: " : "", first, other, points[first][0],
            points[first][1], points[first][2], what));
      }
      target[other] = VertexId{first};
    }
  }
  return target;
}

TensorField join_pieces(RawField raw) {
  const auto& tensors = raw.field.tensors;
  const auto target = joined_points(
      raw, [&](std::size_t a, std::size_t b) { return tensors[a] == tensors[b]; }, "tensors");
  for (auto& tet : raw.field.mesh.tets) {
    for (VertexId& v : tet) v = target[index(v)];
  }
  leave_out_repeated_cells(raw.field);
  clear_unused_points(raw.field);
  return std::move(raw.field);
}

void clear_unused_points(TensorField& field) {
  const auto used = used_points(field.mesh);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) continue;
    field.mesh.points[i] = {};
    field.tensors[i] = {};
  }
}

}  // namespace triplex::detail

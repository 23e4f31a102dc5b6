// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/input_check.hpp"

#include <fmt/format.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "describe.hpp"
#include "first_index.hpp"
#include "half_faces.hpp"
#include "triplex/field/orientation.hpp"

namespace triplex {

using detail::describe_cell;
using detail::describe_point;
using detail::first_index;

namespace {

constexpr std::size_t kMaxIds = std::numeric_limits<std::uint32_t>::max();

void check_sizes(const TensorField& field) {
  const std::size_t points = field.mesh.points.size(), tets = field.mesh.tets.size();
  if (tets == 0) {
    throw BadInput(
        fmt::format("the mesh has no tets ({} points); give a tetrahedral mesh", points));
  }
  if (points > kMaxIds || tets > kMaxIds) {
    throw BadInput(
        fmt::format("the mesh has {} points and {} tets, at most {} of each are possible; "
                    "cut it into parts",
                    points, tets, kMaxIds));
  }
  if (field.tensors.size() != points) {
    throw BadInput(fmt::format("there are {} tensors for {} points; give one tensor per point",
                               field.tensors.size(), points));
  }
  if (!field.source_cells.empty() && field.source_cells.size() != tets) {
    throw BadInput(fmt::format("there are {} source cell ids for {} tets; give one per tet or none",
                               field.source_cells.size(), tets));
  }
}

template <std::size_t N>
bool all_finite(const std::array<double, N>& values) {
  return std::ranges::all_of(values, [](double x) { return std::isfinite(x); });
}

void check_finite(const TensorField& field) {
  const auto& points = field.mesh.points;
  const std::size_t bad = first_index(points.size(), [&](std::size_t i) {
    return !all_finite(points[i]) || !all_finite(field.tensors[i]);
  });
  if (bad == points.size()) return;
  if (!all_finite(points[bad])) {
    throw BadInput(
        fmt::format("{} has a coordinate that is not finite; correct or remove the point",
                    describe_point(field, bad)));
  }
  const auto& t = field.tensors[bad];
  const auto i = std::ranges::find_if(t, [](double x) { return !std::isfinite(x); }) - t.begin();
  throw BadInput(
      fmt::format("the tensor of {} has component {} (row {}, column {}) = {}; all "
                  "components must be finite, correct or remove the point",
                  describe_point(field, bad), i, i / 3, i % 3, t[i]));
}

void check_vertex_ids(const TensorField& field) {
  const auto& tets = field.mesh.tets;
  const std::size_t points = field.mesh.points.size();
  const auto out_of_range = [&](VertexId v) { return index(v) >= points; };
  const std::size_t bad = first_index(tets.size(), [&](std::size_t t) {
    const auto& v = tets[t];
    return std::ranges::any_of(v, out_of_range) || v[0] == v[1] || v[0] == v[2] || v[0] == v[3] ||
           v[1] == v[2] || v[1] == v[3] || v[2] == v[3];
  });
  if (bad == tets.size()) return;
  if (const auto v = std::ranges::find_if(tets[bad], out_of_range); v != tets[bad].end()) {
    throw BadInput(
        fmt::format("{} refers to point {}, but there are only {} points; correct or "
                    "remove the cell",
                    describe_cell(field, bad), index(*v), points));
  }
  throw BadInput(fmt::format("{} has the same point twice; remove this degenerate cell",
                             describe_cell(field, bad)));
}

/// The points that tets use, sorted by coordinates and then by id.
std::vector<std::uint32_t> used_points_by_place(const TetMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  for (const auto& tet : mesh.tets) {
    for (const VertexId v : tet) used[index(v)] = 1;
  }
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < used.size(); ++i) {
    if (used[i]) ids.push_back(i);
  }
  tbb::parallel_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.points[a] != mesh.points[b] ? mesh.points[a] < mesh.points[b] : a < b;
  });
  return ids;
}

[[noreturn]] void refuse_coincident(const TensorField& field, std::uint32_t a, std::uint32_t b) {
  if (field.tensors[a] == field.tensors[b]) {
    throw BadInput(
        fmt::format("{} coincides with point {} and has the same tensor; merge them with "
                    "--merge-points",
                    describe_point(field, b), a));
  }
  const auto& s = field.tensors[a];
  const auto& t = field.tensors[b];
  const auto i = std::ranges::mismatch(s, t).in1 - s.begin();
  throw BadInput(
      fmt::format("{} coincides with point {}, but their tensors differ (component {}: {} "
                  "and {}); the field must be continuous, average or correct the tensors",
                  describe_point(field, b), a, i, t[i], s[i]));
}

/// Calls `pair(a, b)` for the first and each other point of every set of coincident used points.
template <class Pair>
void for_coincident(const TensorField& field, const Pair& pair) {
  const auto ids = used_points_by_place(field.mesh);
  const auto& points = field.mesh.points;
  for (std::size_t i = 0, j; i < ids.size(); i = j) {
    for (j = i + 1; j < ids.size() && points[ids[j]] == points[ids[i]]; ++j) pair(ids[i], ids[j]);
  }
}

void check_coincident(const TensorField& field) {
  std::uint32_t first = 0, second = std::numeric_limits<std::uint32_t>::max();
  for_coincident(field, [&](std::uint32_t a, std::uint32_t b) {
    if (b < second) {
      first = a;
      second = b;
    }
  });
  if (second != std::numeric_limits<std::uint32_t>::max()) refuse_coincident(field, first, second);
}

Sign orientation_of(const TensorField& field, std::size_t tet) {
  const auto& x = field.mesh.points;
  const auto& v = field.mesh.tets[tet];
  return orientation(x[index(v[0])], x[index(v[1])], x[index(v[2])], x[index(v[3])]);
}

void check_orientation(const TensorField& field) {
  const std::size_t tets = field.mesh.tets.size();
  const std::size_t bad =
      first_index(tets, [&](std::size_t t) { return orientation_of(field, t) != Sign::Positive; });
  if (bad == tets) return;
  const Point& x = field.mesh.points[index(field.mesh.tets[bad][0])];
  const std::string where =
      fmt::format("{} at ({}, {}, {})", describe_cell(field, bad), x[0], x[1], x[2]);
  if (orientation_of(field, bad) == Sign::Zero) {
    throw BadInput(
        fmt::format("{} has no volume, its points lie in one plane; remove it or mesh "
                    "again",
                    where));
  }
  throw BadInput(
      fmt::format("{} is inverted (negative volume); reorder its points with "
                  "--fix-orientation{}",
                  where, detail::is_part(field, bad) ? ", or mesh again if it is not convex" : ""));
}

// ---- repairs ----

std::size_t merge_points(TensorField& field) {
  std::vector<VertexId> target(field.mesh.points.size());
  for (std::uint32_t i = 0; i < target.size(); ++i) target[i] = VertexId{i};
  std::size_t merged = 0;
  for_coincident(field, [&](std::uint32_t a, std::uint32_t b) {
    if (field.tensors[a] != field.tensors[b]) refuse_coincident(field, a, b);
    target[b] = VertexId{a};
    ++merged;
  });
  if (merged == 0) return 0;
  for (auto& tet : field.mesh.tets) {
    for (VertexId& v : tet) v = target[index(v)];
  }
  return merged;
}

std::size_t fix_orientation(TensorField& field) {
  std::atomic<std::size_t> flipped{0};
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, field.mesh.tets.size(), 4096),
                    [&](const auto& range) {
                      std::size_t here = 0;
                      for (std::size_t t = range.begin(); t != range.end(); ++t) {
                        if (orientation_of(field, t) != Sign::Negative) continue;
                        std::swap(field.mesh.tets[t][2], field.mesh.tets[t][3]);
                        ++here;
                      }
                      flipped += here;
                    });
  return flipped;
}

void check_elements(const TensorField& field) {
  check_sizes(field);
  check_finite(field);
  check_vertex_ids(field);
}

void check_geometry(const TensorField& field) {
  check_orientation(field);
  detail::check_boundary(field, detail::check_faces(field));
}

}  // namespace

void check_input(const TensorField& field) {
  check_elements(field);
  check_coincident(field);
  check_geometry(field);
}

InputRepairs check_input(TensorField& field, const InputOptions& options) {
  InputRepairs repairs;
  check_elements(field);
  if (options.merge_points) {
    repairs.merged_points = merge_points(field);
    if (repairs.merged_points > 0) check_vertex_ids(field);
  } else {
    check_coincident(field);
  }
  if (options.fix_orientation) repairs.flipped_tets = fix_orientation(field);
  check_geometry(field);
  return repairs;
}

std::size_t remove_unused_points(TensorField& field) {
  auto& points = field.mesh.points;
  constexpr auto kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> target(points.size(), kUnused);
  for (const auto& tet : field.mesh.tets) {
    for (const VertexId v : tet) target[index(v)] = 0;
  }
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (target[i] == kUnused) continue;
    points[kept] = points[i];
    field.tensors[kept] = field.tensors[i];
    target[i] = kept++;
  }
  const std::size_t removed = points.size() - kept;
  points.resize(kept);
  field.tensors.resize(kept);
  for (auto& tet : field.mesh.tets) {
    for (VertexId& v : tet) v = VertexId{target[index(v)]};
  }
  return removed;
}

}  // namespace triplex

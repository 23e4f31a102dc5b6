// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_components.hpp"

#include <algorithm>
#include <limits>

#include "triplex/topology/disjoint_sets.hpp"

namespace triplex {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

DisjointSets joined_points(const MeshView& mesh) {
  DisjointSets sets(mesh.points.size());
  const auto join = [&](const auto& cells) {
    for (const auto& cell : cells)
      for (const std::uint32_t v : cell) sets.unite(cell[0], v);
  };
  join(mesh.triangles);
  join(mesh.segments);
  return sets;
}

/// Per point the number of its component, by place; `kNone` where no cell uses it.
std::vector<std::uint32_t> component_of_points(const MeshView& mesh, std::vector<Point>& places) {
  DisjointSets sets = joined_points(mesh);
  const std::vector<bool> used = used_points(mesh);
  std::vector<std::uint32_t> lowest(mesh.points.size(), kNone);  // by representative
  std::vector<std::uint32_t> roots;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    if (!used[v]) continue;
    std::uint32_t& low = lowest[sets.find(v)];
    if (low == kNone) roots.push_back(sets.find(v));
    if (low == kNone || mesh.points[v] < mesh.points[low]) low = v;
  }
  std::ranges::stable_sort(roots, {}, [&](std::uint32_t r) { return mesh.points[lowest[r]]; });
  std::vector<std::uint32_t> number(mesh.points.size(), kNone);
  for (std::uint32_t c = 0; c < roots.size(); ++c) {
    number[roots[c]] = c;
    places.push_back(mesh.points[lowest[roots[c]]]);
  }
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
    if (used[v]) number[v] = number[sets.find(v)];
  return number;
}

}  // namespace

MeshComponents mesh_components(const MeshView& mesh) {
  MeshComponents result;
  std::vector<Point> places;
  const std::vector<std::uint32_t> component = component_of_points(mesh, places);
  result.components.resize(places.size());
  for (std::size_t c = 0; c < places.size(); ++c) result.components[c].place = places[c];
  std::vector<std::uint32_t> local(mesh.points.size(), kNone);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (component[v] == kNone) continue;
    std::vector<Point>& points = result.components[component[v]].points;
    local[v] = static_cast<std::uint32_t>(points.size());
    points.push_back(mesh.points[v]);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    result.of_triangle.push_back(component[a]);
    result.components[component[a]].triangles.push_back({local[a], local[b], local[c]});
  }
  for (const auto& [a, b] : mesh.segments) {
    result.of_segment.push_back(component[a]);
    result.components[component[a]].segments.push_back({local[a], local[b]});
  }
  return result;
}

}  // namespace triplex

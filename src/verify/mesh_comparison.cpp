// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_comparison.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "simplex_tree.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/disjoint_sets.hpp"
#include "triplex/topology/surface_topology.hpp"
#include "triplex/verify/mesh_components.hpp"

namespace triplex {
namespace {

using detail::Corners;
using detail::SimplexTree;

MeshSize size_of(const MeshView& mesh) {
  const std::vector<bool> used = used_points(mesh);
  return {static_cast<std::uint64_t>(std::ranges::count(used, true)),
          mesh.triangles.size(),
          mesh.segments.size(),
          area_approx(mesh.points, mesh.triangles),
          length_approx(mesh.points, mesh.segments),
          betti_numbers(mesh)};
}

/// A mesh with what is needed to look up points of the other one in it.
struct Side {
  MeshView mesh;
  MeshComponents parts;
  std::vector<Corners> cells;
  std::vector<std::uint32_t> component;  // per cell
  SimplexTree tree;

  explicit Side(const MeshView& m)
      : mesh(m), parts(mesh_components(m)), cells(detail::cells_of(m)), tree(cells) {
    component = parts.of_triangle;
    component.insert(component.end(), parts.of_segment.begin(), parts.of_segment.end());
  }
  bool is_triangle(std::size_t cell) const { return cell < mesh.triangles.size(); }
};

/// Area and length, which do not add up.
using Measure = std::array<double, 2>;

Measure measure_of(const Side& side, std::size_t cell) {
  const std::span<const Point> corners = side.cells[cell];
  const std::array<std::array<std::uint32_t, 3>, 1> triangle = {{{0, 1, 2}}};
  const std::array<std::array<std::uint32_t, 2>, 1> segment = {{{0, 1}}};
  if (side.is_triangle(cell)) return {area_approx(corners, triangle), 0};
  return {0, length_approx(corners, segment)};
}

Point middle_of(const Side& side, std::size_t cell) {
  const auto& [a, b, c] = side.cells[cell];
  if (!side.is_triangle(cell)) return detail::middle(a, b);
  Point p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] / 3 + b[k] / 3 + c[k] / 3;
  return p;
}

/// How much of each component of one mesh is nearest to each component of the other.
using Overlaps = std::map<std::pair<std::uint32_t, std::uint32_t>, Measure>;

/// For each component how many before it have the same place, counted up to 15: components that
/// coincide are told apart by that.
std::vector<std::uint32_t> repetitions(const MeshComponents& parts) {
  std::vector<std::uint32_t> result(parts.components.size(), 0);
  for (std::size_t c = 1; c < result.size(); ++c)
    if (parts.components[c].place == parts.components[c - 1].place)
      result[c] = std::min(result[c - 1] + 1, 15u);
  return result;
}

Overlaps overlaps(const Side& from, const Side& to, double tolerance) {
  Overlaps result;
  if (to.cells.empty() || from.cells.empty()) return result;
  const std::vector<std::uint32_t> mine = repetitions(from.parts);
  const std::vector<std::uint32_t> theirs = repetitions(to.parts);
  // By the repetition of the component that asks: which of equally near ones it prefers.
  std::vector<std::vector<std::uint32_t>> ranks(std::ranges::max(mine) + 1, to.component);
  for (std::uint32_t r = 0; r < ranks.size(); ++r)
    for (std::uint32_t& c : ranks[r])
      if (theirs[c] != r) c += static_cast<std::uint32_t>(theirs.size());
  std::vector<SimplexTree::Hit> hits(from.cells.size());
  tbb::parallel_for(std::size_t{0}, hits.size(), [&](std::size_t cell) {
    hits[cell] = to.tree.nearest(middle_of(from, cell), ranks[mine[from.component[cell]]]);
  });
  for (std::size_t cell = 0; cell < hits.size(); ++cell) {
    if (!(hits[cell].squared <= tolerance * tolerance)) continue;
    const Measure measure = measure_of(from, cell);
    Measure& sum = result[{from.component[cell], to.component[hits[cell].simplex]}];
    for (std::size_t k = 0; k < 2; ++k) sum[k] += measure[k];
  }
  return result;
}

/// Whether an overlap is at least half of the smaller component: by area if both have one, else by
/// length.
bool is_half(const Measure& overlap, const MeshSize& a, const MeshSize& b) {
  // Sums of the same terms in another order may differ by rounding.
  constexpr double kHalf = 0.5 * (1 - 1e-9);
  if (a.triangles > 0 && b.triangles > 0)
    return overlap[0] >= kHalf * std::min(a.area_approx, b.area_approx);
  if (a.triangles > 0 || b.triangles > 0) return false;
  return overlap[1] >= kHalf * std::min(a.length_approx, b.length_approx);
}

Point lowest_place(const MeshComparison& comparison, const ComponentMatch& match) {
  const auto place = [&](std::size_t m) {
    return comparison.meshes[m].components[match.components[m].front()].place;
  };
  return std::min(place(0), place(1));
}

/// Sets `matches`, `alone` and `betti_differ`.
void match_components(const std::array<Side, 2>& sides, MeshComparison& result) {
  const Overlaps forth = overlaps(sides[0], sides[1], result.tolerance);
  const Overlaps back = overlaps(sides[1], sides[0], result.tolerance);
  const auto& a = result.meshes[0].components;
  const auto& b = result.meshes[1].components;
  const auto first = static_cast<std::uint32_t>(a.size());
  DisjointSets sets(a.size() + b.size());
  for (const auto& [pair, overlap] : forth) {
    const auto& [i, j] = pair;
    const auto other = back.find({j, i});
    if (other != back.end() && is_half(overlap, a[i].size, b[j].size) &&
        is_half(other->second, a[i].size, b[j].size))
      sets.unite(i, first + j);
  }
  std::map<std::uint32_t, ComponentMatch> groups;
  for (std::uint32_t i = 0; i < a.size(); ++i) groups[sets.find(i)].components[0].push_back(i);
  for (std::uint32_t j = 0; j < b.size(); ++j)
    groups[sets.find(first + j)].components[1].push_back(j);
  for (auto& [root, group] : groups) {
    if (group.components[1].empty())
      result.meshes[0].alone.push_back(group.components[0].front());
    else if (group.components[0].empty())
      result.meshes[1].alone.push_back(group.components[1].front());
    else
      result.matches.push_back(std::move(group));
  }
  std::ranges::stable_sort(
      result.matches, {}, [&](const ComponentMatch& match) { return lowest_place(result, match); });
  for (std::uint32_t m = 0; m < result.matches.size(); ++m) {
    const auto& [c, d] = result.matches[m].components;
    if (result.matches[m].is_pair() && a[c[0]].size.betti != b[d[0]].size.betti)
      result.betti_differ.push_back(m);
  }
}

Corners place_of(const MeshView& mesh, const Defect& defect) {
  const auto& [a, b, c] = defect.points;
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

/// The defects of `mine` that are not within the tolerance of one of the same kind in `other`.
std::vector<std::uint32_t> unmatched_defects(std::span<const Defect> mine, const Side& other_side,
                                             std::span<const Defect> other, double tolerance) {
  std::array<std::vector<Corners>, kDefectKinds> places;
  for (const Defect& defect : other)
    places[static_cast<std::size_t>(defect.kind)].push_back(place_of(other_side.mesh, defect));
  std::vector<SimplexTree> trees;
  for (std::vector<Corners>& of_kind : places) trees.emplace_back(std::move(of_kind));
  std::vector<std::uint32_t> result;
  for (std::uint32_t d = 0; d < mine.size(); ++d) {
    if (mine[d].kind == DefectKind::DegenerateTriangle) continue;
    const SimplexTree& tree = trees[static_cast<std::size_t>(mine[d].kind)];
    if (tree.empty() || !(tree.nearest(mine[d].position).squared <= tolerance * tolerance))
      result.push_back(d);
  }
  return result;
}

ComparedMesh summary_of(const Side& side, const ComparisonOptions& options) {
  ComparedMesh result;
  result.size = size_of(side.mesh);
  for (const MeshComponent& part : side.parts.components)
    result.components.push_back({size_of(view_of(part)), part.place});
  result.defects = mesh_defects(side.mesh, {options.tolerance, options.may_end});
  return result;
}

}  // namespace

bool MeshComparison::within_tolerance() const {
  return meshes[0].distance.upper <= tolerance && meshes[1].distance.upper <= tolerance;
}

bool MeshComparison::agree() const {
  const bool lacking = std::ranges::any_of(meshes, [](const ComparedMesh& mesh) {
    return !mesh.unmatched.empty() || !mesh.alone.empty();
  });
  return !lacking && betti_differ.empty() && within_tolerance() &&
         std::ranges::all_of(matches, &ComponentMatch::is_pair);
}

MeshComparison compare_meshes(const MeshView& a, const MeshView& b,
                              const ComparisonOptions& options) {
  if (!(options.tolerance >= 0)) throw std::invalid_argument("the tolerance is negative");
  check_mesh(a);
  check_mesh(b);
  const std::array<Side, 2> sides = {Side(a), Side(b)};
  MeshComparison result;
  result.tolerance = options.tolerance;
  for (std::size_t m = 0; m < 2; ++m) {
    result.meshes[m] = summary_of(sides[m], options);
    if (options.check) options.check();
  }
  match_components(sides, result);
  for (std::size_t m = 0; m < 2; ++m)
    result.meshes[m].unmatched = unmatched_defects(result.meshes[m].defects, sides[1 - m],
                                                   result.meshes[1 - m].defects, options.tolerance);
  const DistanceOptions distance = {.gap = options.gap > 0 ? options.gap : options.tolerance / 4,
                                    .threshold = options.tolerance,
                                    .check = options.check};
  result.meshes[0].distance = directed_distance(a, b, distance);
  result.meshes[1].distance = directed_distance(b, a, distance);
  return result;
}

}  // namespace triplex

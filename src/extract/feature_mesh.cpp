// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_mesh.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "patch_fan.hpp"
#include "triplex/feature/invariants_on.hpp"

namespace triplex {
namespace {

constexpr std::size_t kChunk = 4096;  // leaves per part; parts are joined in order

}  // namespace

FeatureMeshBuilder::FeatureMeshBuilder(const TensorField& input, const RefinedComplex& complex,
                                       const EdgeCrossings& crossings,
                                       const FaceSpinePoints& spine_points,
                                       const StackedFaces& stacks, bool keep_tensors)
    : input_(input),
      complex_(complex),
      table_(crossings.table()),
      crossings_(crossings),
      spine_points_(spine_points),
      stacks_(stacks),
      keep_tensors_(keep_tensors),
      joined_(complex, crossings, spine_points) {}

FeatureMeshBuilder::Built FeatureMeshBuilder::build(const std::vector<std::uint32_t>& active_leaves,
                                                    FeatureSet features, bool contracted) const {
  std::vector<Cells> parts((active_leaves.size() + kChunk - 1) / kChunk);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    parts[n].resize(static_cast<std::size_t>(table_.size()));
    CellPatches patches;
    const std::size_t end = std::min((n + 1) * kChunk, active_leaves.size());
    for (std::size_t i = n * kChunk; i < end; ++i)
      add_leaf(complex_.leaves[active_leaves[i]], features, patches, parts[n]);
  });
  Built built;
  if (contracted) built.contraction = contract(parts);
  std::vector<FeatureMesh>& meshes = built.meshes;
  meshes.resize(static_cast<std::size_t>(table_.size()));
  tbb::parallel_for(std::size_t{0}, meshes.size(), [&](std::size_t n) {
    const auto feature = static_cast<Feature>(n);
    if (contains(features, feature)) meshes[n] = assemble(feature, parts);
  });
  return built;
}

void FeatureMeshBuilder::add_leaf(const Leaf& leaf, FeatureSet features, CellPatches& patches,
                                  Cells& cells) const {
  patches_of(leaf, crossings_, spine_points_, stacks_, features, patches);
  const std::int64_t source = input_.source_cell(leaf.input);
  for (const PatchLoop& loop : patches.loops) add_fan(loop, leaf, cells[index(loop.feature)]);
  for (const auto& [from, to] : patches.spine) {
    const PatchVertex a = joined_(from), b = joined_(to);
    if (common_number(a) == common_number(b)) continue;
    cells[index(Feature::TripleCurve)].push_back(
        {{a, b, b}, source, !contains(leaf.open, Feature::TripleCurve)});
  }
}

void FeatureMeshBuilder::add_fan(const PatchLoop& loop, const Leaf& leaf,
                                 std::vector<Cell>& out) const {
  const std::int64_t source = input_.source_cell(leaf.input);
  const bool certified = !contains(leaf.open, loop.feature);
  const auto same = [this](const PatchVertex& a, const PatchVertex& b) {
    return common_number(a) == common_number(b);
  };
  for_each_triangle(loop, leaf, complex_.field, [&](PatchVertex a, PatchVertex b, PatchVertex c) {
    a = joined_(a), b = joined_(b), c = joined_(c);
    if (!same(a, b) && !same(b, c) && !same(a, c)) out.push_back({{a, b, c}, source, certified});
  });
}

FeatureMesh FeatureMeshBuilder::assemble(Feature feature, const std::vector<Cells>& parts) const {
  const auto f = static_cast<std::size_t>(feature);
  const bool is_curve = feature == Feature::TripleCurve;
  constexpr std::uint32_t kUnused = 0xffffffff;
  std::vector<std::uint32_t> of_crossing(crossings_.crossings().size(), kUnused);
  std::vector<std::uint32_t> of_spine(spine_points_.points().size(), kUnused);
  const auto slot = [&](const PatchVertex& v) -> std::uint32_t& {
    return (v.on_spine ? of_spine : of_crossing)[v.number];
  };
  std::size_t cells = 0;
  for (const Cells& part : parts) {
    cells += part[f].size();
    for (const Cell& cell : part[f])
      for (const PatchVertex& v : cell.vertices) slot(v) = 0;
  }

  FeatureMesh mesh;
  const auto number_used = [&](std::vector<std::uint32_t>& numbers, bool on_spine) {
    for (std::uint32_t n = 0; n < numbers.size(); ++n) {
      if (numbers[n] == kUnused) continue;
      numbers[n] = static_cast<std::uint32_t>(mesh.points.size());
      add_vertex(feature, {n, on_spine}, mesh);
    }
  };
  number_used(of_crossing, false);
  number_used(of_spine, true);

  if (!complex_.copies.empty()) {
    mesh.identified.resize(mesh.points.size());
    const auto original_of = [&](const PatchVertex& v) {
      if (v.on_spine || !joined_.at_node[v.number]) return slot(lowest_copy(feature, v));
      for (const std::uint32_t copy : copies_of_vertex(v.number))
        if (of_crossing[copy] != kUnused) return of_crossing[copy];
      return kUnused;
    };
    const auto identify = [&](const std::vector<std::uint32_t>& numbers, bool on_spine) {
      for (std::uint32_t n = 0; n < numbers.size(); ++n) {
        if (numbers[n] == kUnused) continue;
        const std::uint32_t original = original_of({n, on_spine});
        mesh.identified[numbers[n]] = original == kUnused ? numbers[n] : original;
      }
    };
    identify(of_crossing, false);
    identify(of_spine, true);
  }

  (is_curve ? mesh.segments.reserve(cells) : mesh.triangles.reserve(cells));
  for (const Cells& part : parts)
    for (const Cell& cell : part[f]) {
      const std::uint32_t a = slot(cell.vertices[0]), b = slot(cell.vertices[1]);
      if (is_curve) {
        mesh.segments.push_back({a, b});
      } else {
        mesh.triangles.push_back({a, b, slot(cell.vertices[2])});
      }
      mesh.source_cell.push_back(cell.source);
      mesh.certified.push_back(cell.certified);
    }
  return mesh;
}

Point FeatureMeshBuilder::position(const PatchVertex& v) const {
  if (v.on_spine) return spine_points_.position(complex_, spine_points_.points()[v.number]);
  return crossings_.crossings()[v.number].position;
}

void FeatureMeshBuilder::add_vertex(Feature feature, const PatchVertex& v,
                                    FeatureMesh& mesh) const {
  const bool on_curve = v.on_spine || feature == Feature::TripleCurve;
  const auto [p, q, mode] = on_curve ? kInvariantsOnTripleCurve : invariants(feature, v);
  if (!v.on_spine && joined_.at_node[v.number])
    mesh.nodes.push_back(static_cast<std::uint32_t>(mesh.points.size()));
  mesh.points.push_back(position(v));
  mesh.p.push_back(p);
  mesh.q.push_back(q);
  mesh.mode.push_back(mode);
  if (feature == Feature::TripleCurve)
    mesh.position_error.push_back(v.on_spine ? spine_points_.points()[v.number].error : 0);
  if (keep_tensors_) mesh.tensors.push_back(tensor(v));
}

std::array<double, 3> FeatureMeshBuilder::invariants(Feature feature, const PatchVertex& v) const {
  const Crossing& crossing = crossings_.crossings()[v.number];
  return invariants_on(table_, feature, crossing.p, crossing.q);
}

/// The tensors at the corners of the vertex's edge or face, weighted like its position.
Tensor<double> FeatureMeshBuilder::tensor(const PatchVertex& v) const {
  Tensor<double> sum{};
  const auto add = [&](VertexId corner, double weight) {
    const ApproximateTensor t = complex_.field.approximate_tensor(corner);
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += std::ldexp(weight * t.a[k], -complex_.field.scale_exponent());
  };
  if (v.on_spine) {
    const SpinePoint& point = spine_points_.points()[v.number];
    for (std::size_t i = 0; i < 3; ++i) add(point.face[i], point.barycentric[i]);
  } else {
    const auto& ends = crossings_.edges()[joined_.edge_of[v.number]].ends;
    const double t = crossings_.crossings()[v.number].t;
    add(ends[0], 1 - t);
    add(ends[1], t);
  }
  return sum;
}

/// The vertex of the lowest periodic copy of the edge or face that a vertex lies on; itself, if
/// that is none of the mesh.
PatchVertex FeatureMeshBuilder::lowest_copy(Feature feature, const PatchVertex& v) const {
  int number = -1;
  if (v.on_spine) {
    number = spine_points_.find(complex_.copies.lowest(spine_points_.points()[v.number].face));
  } else {
    const auto ends = complex_.copies.lowest(crossings_.edges()[joined_.edge_of[v.number]].ends);
    if (const CrossedEdge* edge = crossings_.find(ends[0], ends[1]))
      number = crossings_.crossing_of(*edge, feature);
  }
  return number < 0 ? v : PatchVertex{static_cast<std::uint32_t>(number), v.on_spine};
}

/// The crossings that stand for the copies of the node or isotropic vertex at which one lies, the
/// lowest copy first. A feature need not pass through the tets at each of them.
std::vector<std::uint32_t> FeatureMeshBuilder::copies_of_vertex(std::uint32_t crossing) const {
  const std::array lowest =
      complex_.copies.lowest(std::array{joined_.vertex_of(crossings_, crossing)});
  auto copies = complex_.copies.copies(lowest);
  std::sort(copies.begin() + 1, copies.end());
  std::vector<std::uint32_t> found;
  for (const auto& [v] : copies)
    if (const auto number = joined_.at_vertex(v)) found.push_back(*number);
  return found;
}

}  // namespace triplex

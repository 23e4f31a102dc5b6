// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_mesh.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace triplex {
namespace {

constexpr std::size_t kChunk = 4096;  // leaves per part; parts are joined in order

double squared_distance(const Point& a, const Point& b) {
  double s = 0;
  for (int k = 0; k < 3; ++k) s += (a[k] - b[k]) * (a[k] - b[k]);
  return s;
}

/// p, q and mode with the values that the feature has by definition put in.
std::array<double, 3> on_feature(Feature feature, double p, double q) {
  const double w = std::sqrt(std::fmax(0, -p) / 3);
  switch (row(feature).sheet) {
    case Sheet::Balanced:
      return {0, q, std::numeric_limits<double>::infinity()};
    case Sheet::Neutral:
      return {p, 0, 0};
    case Sheet::DegenerateLinear:
      return {p, 2 * w * w * w, 1};
    case Sheet::DegeneratePlanar:
      return {p, -2 * w * w * w, 1};
  }
  return {p, q, 0};
}
/// The vertex from which a loop is fanned. It must not depend on where the loop starts or which way
/// it runs. No diagonal should lie in a face of the tet, where a neighbour might use it too (this
/// can only happen in open tets, where a page may have two arcs on a face); then a spine point;
/// then the lowest.
std::size_t apex_of(const PatchLoop& loop) {
  const std::size_t n = loop.size();
  const auto rank = [&](std::size_t i) {
    int diagonals_in_faces = 0;
    for (std::size_t k = 2; k + 1 < n; ++k)
      diagonals_in_faces += (loop[i].faces & loop[(i + k) % n].faces) != 0;
    return std::tuple(diagonals_in_faces, !loop[i].on_spine, loop[i].number);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (rank(i) < rank(best)) best = i;
  return best;
}

constexpr std::array<double, 3> kOnSpine = {0, 0, std::numeric_limits<double>::quiet_NaN()};

}  // namespace

FeatureMeshBuilder::FeatureMeshBuilder(const TensorField& input, const RefinedComplex& complex,
                                       const std::vector<Sector>& labels,
                                       const EdgeCrossings& crossings,
                                       const FaceSpinePoints& spine_points)
    : input_(input),
      complex_(complex),
      labels_(labels),
      crossings_(crossings),
      spine_points_(spine_points) {}

std::array<FeatureMesh, kFeatures> FeatureMeshBuilder::build(
    const std::vector<std::uint32_t>& active_leaves, FeatureSet features) const {
  std::vector<Cells> parts((active_leaves.size() + kChunk - 1) / kChunk);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    const std::size_t end = std::min((n + 1) * kChunk, active_leaves.size());
    for (std::size_t i = n * kChunk; i < end; ++i)
      add_leaf(complex_.leaves[active_leaves[i]], features, parts[n]);
  });
  std::array<FeatureMesh, kFeatures> meshes;
  tbb::parallel_for(0, kFeatures, [&](int f) {
    if (features & bit(f)) meshes[f] = assemble(static_cast<Feature>(f), parts);
  });
  return meshes;
}

void FeatureMeshBuilder::add_leaf(const Leaf& leaf, FeatureSet features, Cells& cells) const {
  const CellPatches patches = patches_of(leaf, labels_, crossings_, spine_points_, features);
  const std::int64_t source = source_cell(leaf.input);
  const auto certified = [&](int feature) { return !(leaf.open & bit(feature)); };
  for (int page = 0; page < kPages; ++page)
    for (const PatchLoop& loop : patches.pages[page])
      add_fan(loop, source, certified(page), cells[page]);
  constexpr int kCurve = static_cast<int>(Feature::TripleCurve);
  for (const auto& [a, b] : patches.spine)
    cells[kCurve].push_back({{a, b, b}, source, certified(kCurve)});
}

void FeatureMeshBuilder::add_fan(const PatchLoop& loop, std::int64_t source, bool certified,
                                 std::vector<Cell>& out) const {
  std::size_t apex = apex_of(loop);
  if (loop.size() == 4 && !loop[apex].on_spine) {
    const auto corner = [&](std::size_t i) { return position(loop[(apex + i) % 4]); };
    if (squared_distance(corner(1), corner(3)) < squared_distance(corner(0), corner(2)))
      apex = (apex + 1) % 4;
  }
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    out.push_back({{loop[apex], loop[(apex + i) % loop.size()], loop[(apex + i + 1) % loop.size()]},
                   source,
                   certified});
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
  std::array<double, 3> values = kOnSpine;
  if (!v.on_spine) {
    const Crossing& crossing = crossings_.crossings()[v.number];
    values = on_feature(feature, crossing.p, crossing.q);
  }
  mesh.points.push_back(position(v));
  mesh.p.push_back(values[0]);
  mesh.q.push_back(values[1]);
  mesh.mode.push_back(values[2]);
}

std::int64_t FeatureMeshBuilder::source_cell(TetId tet) const {
  return input_.source_cells.empty() ? static_cast<std::int64_t>(index(tet))
                                     : input_.source_cells[index(tet)];
}

}  // namespace triplex

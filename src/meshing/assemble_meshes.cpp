// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assemble_meshes.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "triplex/feature/invariants_on.hpp"

namespace triplex {
namespace {

constexpr std::uint32_t kUnused = 0xffffffff;

/// Makes every point one of its own, and then those of corners copies of their originals' points.
void identify_corners(const PatchComplex& complex, const std::vector<std::uint32_t>& of_corner,
                      FeatureMesh& mesh) {
  if (complex.corner_originals.empty()) return;
  mesh.identified.resize(mesh.points.size());
  std::iota(mesh.identified.begin(), mesh.identified.end(), 0u);
  // A surface may meet copies of a vertex without the original: the first that it meets then is.
  std::vector<std::uint32_t> originals = of_corner;
  for (std::size_t n = 0; n < of_corner.size(); ++n) {
    if (of_corner[n] == kUnused) continue;
    std::uint32_t& original = originals[complex.corner_originals[n]];
    if (original == kUnused) original = of_corner[n];
    mesh.identified[of_corner[n]] = original;
  }
}

class FeatureAssembler {
 public:
  FeatureAssembler(const PatchComplex& complex, const MeshedArcs& arcs, Feature feature)
      : complex_(complex),
        arcs_(arcs),
        feature_(feature),
        of_corner_(complex.corners.size(), kUnused),
        first_of_arc_(complex.arcs.size(), kUnused) {}

  void add_patch(const Patch& patch, const MeshedPatch& meshed) {
    numbers_.clear();
    const std::size_t outline = meshed.outline.size();
    for (std::size_t i = 0; i < meshed.values.size(); ++i) {
      const std::uint32_t number = i < outline ? shared(meshed.outline[i], meshed, i)
                                               : add_point(meshed.inside[i - outline], meshed, i);
      for (std::size_t k = 0; k < 3; ++k)
        mesh_.normals[number][k] += meshed.values[i].normal[static_cast<Eigen::Index>(k)];
      numbers_.push_back(number);
    }
    for (const auto& [a, b, c] : meshed.triangles) {
      mesh_.triangles.push_back({numbers_[a], numbers_[b], numbers_[c]});
      mesh_.source_cell.push_back(patch.source_cell);
      mesh_.certified.push_back(patch.certified);
      mesh_.error_bound.push_back(meshed.error);
    }
  }

  FeatureMesh take() {
    for (Point& n : mesh_.normals) {
      const double length = std::hypot(n[0], n[1], n[2]);
      for (double& x : n) x = length > 0 ? x / length : 0;
    }
    std::ranges::sort(mesh_.nodes);
    identify_corners(complex_, of_corner_, mesh_);
    identify_arcs();
    return std::move(mesh_);
  }

 private:
  void identify_arcs() {
    for (std::uint32_t n = 0; n < complex_.arc_originals.size(); ++n) {
      const auto& [arc, reversed, places] = complex_.arc_originals[n];
      const std::uint32_t copy = first_of_arc_[n], original = first_of_arc_[arc];
      if (copy == kUnused || original == kUnused) continue;
      const auto count = static_cast<std::uint32_t>(arcs_[n].points.size());
      for (std::uint32_t k = 0; k < count; ++k)
        mesh_.identified[copy + k] = original + (reversed ? count - 1 - k : k);
    }
  }

  std::uint32_t shared(const OutlineVertex& v, const MeshedPatch& meshed, std::size_t i) {
    if (!v.is_corner()) return of_arc(v, meshed, i);
    std::uint32_t& number = of_corner_[v.number];
    if (number != kUnused) return number;
    const PatchCorner& corner = complex_.corners[v.number];
    number = add_point(corner.position, meshed, i);
    if (corner.vertices == 1) mesh_.nodes.push_back(number);
    set_last(corner.vertices == 3 ? kInvariantsOnTripleCurve
                                  : invariants_on(complex_.table, feature_, corner.p, corner.q));
    return number;
  }

  /// The points of an arc are numbered together when the first of them is met.
  std::uint32_t of_arc(const OutlineVertex& v, const MeshedPatch& meshed, std::size_t i) {
    std::uint32_t& first = first_of_arc_[v.number];
    if (first != kUnused) return first + v.point;
    const std::vector<Point>& points = arcs_[v.number].points;
    first = static_cast<std::uint32_t>(mesh_.points.size());
    // The patch at hand runs through them forwards or backwards, from vertex i on.
    const bool forwards = v.point == 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      add_point(points[k], meshed, forwards ? i + k : i + points.size() - 1 - k);
      if (complex_.arcs[v.number].vertices == 4) set_last(kInvariantsOnTripleCurve);
    }
    return first + v.point;
  }

  void set_last(const std::array<double, 3>& invariants) {
    mesh_.p.back() = invariants[0], mesh_.q.back() = invariants[1];
    mesh_.mode.back() = invariants[2];
  }

  std::uint32_t add_point(const Point& x, const MeshedPatch& meshed, std::size_t i) {
    mesh_.points.push_back(x);
    mesh_.normals.push_back({});
    const auto [p, q, mode] =
        invariants_on(complex_.table, feature_, meshed.values[i].p, meshed.values[i].q);
    mesh_.p.push_back(p);
    mesh_.q.push_back(q);
    mesh_.mode.push_back(mode);
    if (!meshed.tensors.empty()) mesh_.tensors.push_back(meshed.tensors[i]);
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  const PatchComplex& complex_;
  const MeshedArcs& arcs_;
  const Feature feature_;
  std::vector<std::uint32_t> of_corner_, first_of_arc_, numbers_;
  FeatureMesh mesh_;
};

/// The triple degenerate curve from its arcs.
FeatureMesh assemble_curve(const PatchComplex& complex, const MeshedArcs& arcs) {
  FeatureMesh mesh;
  std::vector<std::uint32_t> of_corner(complex.corners.size(), kUnused);
  const auto add = [&](const Point& x, double error) {
    mesh.points.push_back(x);
    mesh.p.push_back(kInvariantsOnTripleCurve[0]);
    mesh.q.push_back(kInvariantsOnTripleCurve[1]);
    mesh.mode.push_back(kInvariantsOnTripleCurve[2]);
    mesh.position_error.push_back(error);
    return static_cast<std::uint32_t>(mesh.points.size() - 1);
  };
  const auto at_corner = [&](std::uint32_t n) {
    if (of_corner[n] == kUnused)
      of_corner[n] = add(complex.corners[n].position, complex.corners[n].error);
    return of_corner[n];
  };
  for (const CurvePiece& piece : complex.curve) {
    const MeshedArc& arc = arcs[piece.use.arc];
    const std::size_t count = arc.points.size();
    const auto& ends = complex.arcs[piece.use.arc].ends;
    const double deviation = arc.deviation + arc.position_error;
    std::uint32_t from = at_corner(ends[piece.use.reversed ? 1 : 0]);
    const auto add_segment = [&](std::uint32_t to) {
      mesh.segments.push_back({from, to});
      mesh.source_cell.push_back(piece.source_cell);
      mesh.certified.push_back(piece.certified);
      mesh.error_bound.push_back(deviation);
      from = to;
    };
    for (std::size_t k = 0; k < count; ++k)
      add_segment(add(arc.points[piece.use.reversed ? count - 1 - k : k],
                      std::isfinite(deviation) ? arc.point_error + arc.position_error : deviation));
    add_segment(at_corner(ends[piece.use.reversed ? 0 : 1]));
  }
  identify_corners(complex, of_corner, mesh);
  return mesh;
}

}  // namespace

MeshedPatches assemble_meshes(const PatchComplex& complex, const MeshedArcs& arcs,
                              const std::vector<MeshedPatch>& patches) {
  std::vector<std::vector<std::uint32_t>> of_feature(
      static_cast<std::size_t>(complex.table.size()));
  for (std::uint32_t n = 0; n < patches.size(); ++n)
    of_feature[index(complex.patches[n].feature)].push_back(n);
  MeshedPatches result;
  result.features.resize(of_feature.size());
  result.patch_of.resize(of_feature.size());
  tbb::parallel_for(std::size_t{0}, of_feature.size(), [&](std::size_t f) {
    if (of_feature[f].empty()) return;
    FeatureAssembler assembler(complex, arcs, static_cast<Feature>(f));
    for (const std::uint32_t n : of_feature[f]) {
      assembler.add_patch(complex.patches[n], patches[n]);
      result.patch_of[f].insert(result.patch_of[f].end(), patches[n].triangles.size(), n);
    }
    result.features[f] = assembler.take();
  });
  if (!complex.curve.empty())
    result.features[index(Feature::TripleCurve)] = assemble_curve(complex, arcs);
  return result;
}

}  // namespace triplex

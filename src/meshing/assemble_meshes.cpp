// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assemble_meshes.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "triplex/feature/invariants_on.hpp"

namespace triplex {
namespace {

constexpr std::uint32_t kUnused = 0xffffffff;

class FeatureAssembler {
 public:
  FeatureAssembler(const PatchComplex& complex, const MeshedArcs& arcs, Feature feature)
      : complex_(complex),
        arcs_(arcs),
        feature_(feature),
        of_corner_(complex.corners.size(), kUnused),
        of_arc_point_(arcs.points().size(), kUnused) {
    // Points on the curve have the invariants that the curve has by definition.
    for (std::uint32_t n = 0; n < complex.arcs.size(); ++n)
      if (complex.arcs[n].vertices == 4) curve_arcs_.push_back(n);
  }

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
    return std::move(mesh_);
  }

 private:
  bool is_on_curve(const OutlineVertex& v) const {
    if (!v.on_arc) return complex_.corners[v.number].vertices == 3;
    const auto arc = std::ranges::upper_bound(curve_arcs_, v.number, {},
                                              [&](std::uint32_t n) { return arcs_.first(n); });
    return arc != curve_arcs_.begin() &&
           v.number < arcs_.first(*std::prev(arc)) + arcs_.count(*std::prev(arc));
  }

  std::uint32_t shared(const OutlineVertex& v, const MeshedPatch& meshed, std::size_t i) {
    std::uint32_t& number = (v.on_arc ? of_arc_point_ : of_corner_)[v.number];
    if (number != kUnused) return number;
    const PatchCorner* const corner = v.on_arc ? nullptr : &complex_.corners[v.number];
    number = static_cast<std::uint32_t>(mesh_.points.size());
    if (corner && corner->vertices == 1) mesh_.nodes.push_back(number);
    add_point(corner ? corner->position : arcs_.points()[v.number], meshed, i);
    const auto set = [&](const std::array<double, 3>& x) {
      mesh_.p.back() = x[0], mesh_.q.back() = x[1], mesh_.mode.back() = x[2];
    };
    if (is_on_curve(v))
      set(kInvariantsOnTripleCurve);
    else if (corner)
      set(invariants_on(complex_.table, feature_, corner->p, corner->q));
    return number;
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
  std::vector<std::uint32_t> of_corner_, of_arc_point_, curve_arcs_, numbers_;
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
    const std::uint32_t arc = piece.use.arc, first = arcs.first(arc), count = arcs.count(arc);
    const auto& ends = complex.arcs[arc].ends;
    const double deviation = arcs.deviation(arc);
    std::uint32_t from = at_corner(ends[piece.use.reversed ? 1 : 0]);
    const auto add_segment = [&](std::uint32_t to) {
      mesh.segments.push_back({from, to});
      mesh.source_cell.push_back(piece.source_cell);
      mesh.certified.push_back(piece.certified);
      mesh.error_bound.push_back(deviation);
      from = to;
    };
    for (std::uint32_t k = 0; k < count; ++k)
      add_segment(add(arcs.points()[first + (piece.use.reversed ? count - 1 - k : k)],
                      std::isfinite(deviation) ? arcs.point_error(arc) : deviation));
    add_segment(at_corner(ends[piece.use.reversed ? 0 : 1]));
  }
  return mesh;
}

}  // namespace

std::vector<FeatureMesh> assemble_meshes(const PatchComplex& complex, const MeshedArcs& arcs,
                                         const std::vector<MeshedPatch>& patches) {
  std::vector<std::vector<std::uint32_t>> of_feature(
      static_cast<std::size_t>(complex.table.size()));
  for (std::uint32_t n = 0; n < patches.size(); ++n)
    of_feature[index(complex.patches[n].feature)].push_back(n);
  std::vector<FeatureMesh> meshes(of_feature.size());
  tbb::parallel_for(std::size_t{0}, meshes.size(), [&](std::size_t f) {
    if (of_feature[f].empty()) return;
    FeatureAssembler assembler(complex, arcs, static_cast<Feature>(f));
    for (const std::uint32_t n : of_feature[f]) assembler.add_patch(complex.patches[n], patches[n]);
    meshes[f] = assembler.take();
  });
  if (!complex.curve.empty()) meshes[index(Feature::TripleCurve)] = assemble_curve(complex, arcs);
  return meshes;
}

}  // namespace triplex

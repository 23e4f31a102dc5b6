// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/road_summary.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "other_page.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Place = std::array<Point, 2>;  // of an edge, by the coordinates of its ends, ascending

Place place_of(const FeatureMesh& mesh, std::uint32_t a, std::uint32_t b) {
  Place place{mesh.points[a], mesh.points[b]};
  if (place[1] < place[0]) std::swap(place[0], place[1]);
  return place;
}

/// Where pages of one method may end: its triple curve, and the edges of the other page.
std::vector<Place> ends_of_pages(const FeatureTable& table, std::span<const FeatureMesh> features,
                                 Feature f) {
  std::vector<Place> places;
  const FeatureMesh& curve = features[index(Feature::TripleCurve)];
  for (const auto& [a, b] : curve.segments) places.push_back(place_of(curve, a, b));
  if (const auto partner = detail::other_page(table, f)) {
    const FeatureMesh& page = features[index(*partner)];
    for (const auto& t : page.triangles)
      for (std::size_t k = 0; k < 3; ++k) places.push_back(place_of(page, t[k], t[(k + 1) % 3]));
  }
  std::ranges::sort(places);
  return places;
}

std::vector<Defect> defects_inside(const DomainBoundary& domain, const FeatureTable& table,
                                   std::span<const FeatureMesh> features, Feature f) {
  const FeatureMesh& mesh = features[index(f)];
  std::vector<Defect> defects = mesh_defects(view_of(mesh));
  std::erase_if(defects, [&](const Defect& d) {
    return d.kind == DefectKind::NonmanifoldVertex &&
           std::ranges::binary_search(mesh.nodes, d.points[0]);
  });
  const auto is_open = [](const Defect& d) {
    return d.kind == DefectKind::OpenEdge || d.kind == DefectKind::Crack;
  };
  if (std::ranges::any_of(defects, is_open)) {
    const std::vector<Edge> boundary = domain.edges_of(mesh);
    const std::vector<Place> ends = ends_of_pages(table, features, f);
    std::erase_if(defects, [&](const Defect& d) {
      return is_open(d) &&
             (std::ranges::binary_search(boundary, Edge{d.points[0], d.points[1]}) ||
              std::ranges::binary_search(ends, place_of(mesh, d.points[0], d.points[1])));
    });
  }
  return defects;
}

}  // namespace

RoadSummary summarize(const DomainBoundary& boundary, const FeatureTable& table,
                      std::span<const FeatureMesh> features, Feature f) {
  const FeatureMesh& mesh = features[index(f)];
  RoadSummary summary;
  summary.betti = betti_numbers(view_of(mesh));
  summary.is_curve = !mesh.segments.empty() || table.row(f).kind == FeatureKind::Curve;
  if (summary.is_curve) {
    const CurveTopology t = curve_topology(mesh.segments, mesh.points.size());
    summary.vertices = t.vertices;
    summary.cells = t.segments;
    summary.euler = static_cast<std::int64_t>(t.vertices) - static_cast<std::int64_t>(t.segments);
    summary.measure = length_approx(mesh.points, mesh.segments);
    return summary;
  }
  const SurfaceTopology t = surface_topology(mesh.triangles, mesh.points.size());
  summary.vertices = t.vertices;
  summary.cells = t.triangles;
  summary.euler = t.euler;
  summary.measure = area_approx(mesh.points, mesh.triangles);
  summary.defects = defects_inside(boundary, table, features, f);
  return summary;
}

}  // namespace triplex

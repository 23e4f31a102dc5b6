// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/mesh_defects.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "incidence.hpp"
#include "simplex_tree.hpp"
#include "triplex/topology/disjoint_sets.hpp"

namespace triplex {
namespace {

using detail::Corners;
using detail::Side;

bool collinear(const Point& a, const Point& b, const Point& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto at = [](const Point& p) { return Kernel::Point_3(p[0], p[1], p[2]); };
  return CGAL::collinear(at(a), at(b), at(c));
}

Point along(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

class Finder {
 public:
  Finder(const MeshView& mesh, const DefectOptions& options) : mesh_(mesh), options_(options) {}

  std::vector<Defect> run() {
    const std::vector<bool> repeated = detail::repeated_triangles(mesh_.triangles);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh_.triangles[t];
      if (repeated[t])
        add(DefectKind::DuplicateTriangle, {a, b, c});
      else if (collinear(mesh_.points[a], mesh_.points[b], mesh_.points[c]))
        add(DefectKind::DegenerateTriangle, {a, b, c});
    }
    const std::vector<Side> sides = detail::sorted_sides(mesh_.triangles, repeated);
    look_at_edges(sides);
    look_at_vertices(sides, repeated);
    look_at_ends();
    std::ranges::sort(defects_, [](const Defect& a, const Defect& b) {
      return std::tie(a.kind, a.points) < std::tie(b.kind, b.points);
    });
    return std::move(defects_);
  }

 private:
  void add(DefectKind kind, std::vector<std::uint32_t> points) {
    std::ranges::sort(points);
    Defect defect{kind, static_cast<std::uint8_t>(points.size()), {}, {}};
    for (std::size_t i = 0; i < 3; ++i) defect.points[i] = points[std::min(i, points.size() - 1)];
    for (const std::uint32_t v : points)
      for (std::size_t k = 0; k < 3; ++k)
        defect.position[k] += mesh_.points[v][k] / static_cast<double>(points.size());
    defects_.push_back(defect);
  }

  void look_at_edges(std::span<const Side> sides) {
    detail::for_each_edge(sides, [&](std::span<const Side> edge) {
      const std::vector<std::uint32_t> ends = {edge[0].low, edge[0].high};
      if (edge.size() == 1) single_.push_back(edge[0]);
      if (edge.size() == 2 && edge[0].forward == edge[1].forward)
        add(DefectKind::OrientationConflict, ends);
      if (edge.size() > 2) add(DefectKind::NonmanifoldEdge, ends);
    });
  }

  /// Corner 3 t + i is vertex i of triangle t; corners at a vertex that edges join are one fan.
  void look_at_vertices(std::span<const Side> sides, const std::vector<bool>& repeated) {
    DisjointSets fans(3 * mesh_.triangles.size());
    const auto corner = [](const Side& side, bool at_low) {
      return 3 * side.triangle + (side.forward == at_low ? side.corner : (side.corner + 1) % 3);
    };
    detail::for_each_edge(sides, [&](std::span<const Side> edge) {
      for (std::size_t k = 1; k < edge.size(); ++k)
        for (const bool at_low : {true, false})
          fans.unite(corner(edge[0], at_low), corner(edge[k], at_low));
    });
    std::vector<std::uint8_t> count(mesh_.points.size(), 0);  // 0, 1, or 2 for more
    for (std::uint32_t c = 0; c < 3 * mesh_.triangles.size(); ++c) {
      if (repeated[c / 3] || fans.find(c) != c) continue;
      const std::uint32_t v = mesh_.triangles[c / 3][c % 3];
      if (count[v] == 1) add(DefectKind::NonmanifoldVertex, {v});
      count[v] = static_cast<std::uint8_t>(std::min(count[v] + 1, 2));
    }
  }

  /// Edges of one triangle: cracks, or open.
  void look_at_ends() {
    std::vector<Corners> edges;
    for (const Side& s : single_)
      edges.push_back({mesh_.points[s.low], mesh_.points[s.high], mesh_.points[s.high]});
    const detail::SimplexTree tree(std::move(edges));
    for (const Side& s : single_)
      for (const double x : mesh_.points[s.low]) rounding_ = std::max(rounding_, std::abs(x));
    rounding_ *= 8 * std::numeric_limits<double>::epsilon();
    for (std::uint32_t e = 0; e < single_.size(); ++e) {
      const Point& a = tree.simplex(e)[0];
      const Point& b = tree.simplex(e)[1];
      if (is_crack(tree, e))
        add(DefectKind::Crack, {single_[e].low, single_[e].high});
      else if (!options_.may_end || !options_.may_end(a) || !options_.may_end(b) ||
               !options_.may_end(detail::middle(a, b)))
        add(DefectKind::OpenEdge, {single_[e].low, single_[e].high});
    }
  }

  bool is_crack(const detail::SimplexTree& tree, std::uint32_t e) const {
    const Point& a = tree.simplex(e)[0];
    const Point& b = tree.simplex(e)[1];
    const Side& side = single_[e];
    const Point& apex = mesh_.points[mesh_.triangles[side.triangle][(side.corner + 2) % 3]];
    const double base = std::sqrt(detail::squared_distance(a, b));
    const double height = std::sqrt(detail::nearest_on_simplex(apex, {a, b, b}).squared);
    if (std::min(base, height) < 100 * rounding_) return false;  // of no extent
    const double width = std::min({options_.tolerance, base / 10, height / 10}) + rounding_;
    return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double t) {
      return tree.nearest_other(along(a, b, t), e, width * width).has_value();
    });
  }

  const MeshView& mesh_;
  const DefectOptions& options_;
  std::vector<Side> single_;  // edges of one triangle
  double rounding_ = 0;       // of points along them
  std::vector<Defect> defects_;
};

}  // namespace

std::string_view name_of(DefectKind kind) {
  constexpr std::array<std::string_view, kDefectKinds> kNames = {"open-edge",
                                                                 "crack",
                                                                 "nonmanifold-edge",
                                                                 "nonmanifold-vertex",
                                                                 "orientation-conflict",
                                                                 "duplicate-triangle",
                                                                 "degenerate-triangle"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::function<bool(const Point&)> on_boundary_of(const BoundingBox& box, double tolerance) {
  return [box, tolerance](const Point& p) {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(p[k] - box.low[k]) <= tolerance || std::abs(p[k] - box.high[k]) <= tolerance)
        return true;
    return false;
  };
}

std::vector<Defect> mesh_defects(const MeshView& mesh, const DefectOptions& options) {
  check_mesh(mesh);
  return Finder(mesh, options).run();
}

std::array<std::uint64_t, kDefectKinds> count_defects(std::span<const Defect> defects) {
  std::array<std::uint64_t, kDefectKinds> counts{};
  for (const Defect& defect : defects) ++counts[static_cast<std::size_t>(defect.kind)];
  return counts;
}

}  // namespace triplex

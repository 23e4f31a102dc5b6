// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangulate_patch.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

#include "divide_chords.hpp"
#include "least_disc.hpp"
#include "patch_error.hpp"

namespace triplex {
namespace {

struct FaceInfo {
  bool inside = false;
};
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_tag>;
using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;
using Point2 = Kernel::Point_2;

/// Triangles with a smaller angle in the plane are split, if the boundary does not forbid it:
/// Ruppert's bound, 20.7 degrees, up to which inserting circumcentres ends.
const double kLeastSine = std::sqrt(0.125);
/// A patch that needs more points than this is left as far as it got.
constexpr std::size_t kMostInside = 1'000'000;
/// No edge inside a patch is made shorter than this part of its cell.
constexpr double kShortest = 0x1p-24;

double squared(const Point2& a, const Point2& b) { return CGAL::squared_distance(a, b); }

/// The sine of the smallest angle, squared.
double squared_least_sine(const Point2& a, const Point2& b, const Point2& c) {
  std::array<double, 3> sides = {squared(a, b), squared(b, c), squared(a, c)};
  std::ranges::sort(sides);
  const double twice_area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
  return twice_area * twice_area / (sides[1] * sides[2]);
}

class PatchMesher {
 public:
  PatchMesher(const PatchOutline& outline, const Chart& plane, bool has_chart, double tolerance)
      : outline_(outline), plane_(plane), has_chart_(has_chart) {
    if (!has_chart) return;
    allowed_ = tolerance - error_at_boundary(outline, plane);
    if (!(allowed_ > 4 * error_at(outline.boundary.front()))) allowed_ = 0;
  }

  /// False: the outline is no simple polygon in this plane.
  bool start() {
    try {
      std::vector<Vertex> corners;
      double twice_area = 0;
      Point2 last = in_plane(outline_.boundary.back());
      Face hint;
      for (const Weights& w : outline_.boundary) {
        const Point2 p = in_plane(w);
        twice_area += last.x() * p.y() - last.y() * p.x();
        const Vertex v = t_.insert(p, hint);
        v->info() = static_cast<std::uint32_t>(corners.size());
        hint = v->face();
        corners.push_back(v);
        last = p;
      }
      if (t_.number_of_vertices() != corners.size()) return false;
      for (std::size_t i = 0; i < corners.size(); ++i)
        t_.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        Face face;
        int k = 0;
        if (!t_.is_edge(corners[i], corners[(i + 1) % corners.size()], face, k)) return false;
      }
      clockwise_ = twice_area < 0;
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    mark_inside();
    return true;
  }

  void refine() {
    std::deque<std::array<Vertex, 3>> waiting;
    for (const Face face : t_.finite_face_handles())
      if (face->info().inside)
        waiting.push_back({face->vertex(0), face->vertex(1), face->vertex(2)});
    while (!waiting.empty() && inside_.size() < kMostInside) {
      const auto [a, b, c] = waiting.front();
      waiting.pop_front();
      Face face;
      if (!t_.is_face(a, b, c, face)) continue;
      const Vertex v = split(face);
      if (v == Vertex{}) continue;
      auto around = t_.incident_faces(v), done = around;
      do {
        const Face next = around;
        if (!t_.is_infinite(next) && next->info().inside)
          waiting.push_back({next->vertex(0), next->vertex(1), next->vertex(2)});
      } while (++around != done);
    }
  }

  PatchTriangles take(bool proven) {
    PatchTriangles result;
    for (const Face face : t_.finite_face_handles()) {
      if (!face->info().inside) continue;
      std::array<std::uint32_t, 3> triangle;
      for (int k = 0; k < 3; ++k) triangle[static_cast<std::size_t>(k)] = face->vertex(k)->info();
      if (clockwise_) std::swap(triangle[1], triangle[2]);
      // From the lowest corner, for an order that depends on the triangles alone.
      std::ranges::rotate(triangle, std::ranges::min_element(triangle));
      result.triangles.push_back(triangle);
    }
    std::ranges::sort(result.triangles);
    result.inside = std::move(inside_);
    divide_chords(
        outline_.boundary, [&](const Weights& w) { return proven ? over(w) : std::nullopt; },
        result);
    if (proven) {
      double up = 0;
      const auto at = [&](std::uint32_t v) { return weights(v, result.inside); };
      for (const auto& [a, b, c] : result.triangles)
        up = std::max(up, triplex::error_up(outline_, plane_, {at(a), at(b), at(c)}, allowed_));
      result.error = (up + error_at_boundary(outline_, plane_)) * (1 + 0x1p-20);
      for (const Weights& w : result.inside)
        result.vertex_error = std::max(result.vertex_error, error_at(w));
    }
    return result;
  }

 private:
  Point2 in_plane(const Weights& w) const {
    const auto [x, y] = plane_.project(outline_.cell.position(w));
    return {x, y};
  }
  const Weights& weights(std::uint32_t v, const std::vector<Weights>& inside) const {
    const std::size_t count = outline_.boundary.size();
    return v < count ? outline_.boundary[v] : inside[v - count];
  }
  const Weights& weights(const Vertex& v) const { return weights(v->info(), inside_); }

  /// Everything that is not connected with the outside.
  void mark_inside() {
    for (const Face face : t_.all_face_handles()) face->info().inside = true;
    std::vector<Face> stack = {t_.infinite_face()};
    t_.infinite_face()->info().inside = false;
    while (!stack.empty()) {
      const Face face = stack.back();
      stack.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Face next = face->neighbor(k);
        if (!next->info().inside || face->is_constrained(k)) continue;
        next->info().inside = false;
        stack.push_back(next);
      }
    }
  }

  /// How far a vertex can be from the surface: rounding.
  double error_at(const Weights& w) const {
    return outline_.f.largest_value<1>({outline_.cell.tensor(w)}, outline_.cell.bounds()) /
           plane_.rise * (1 + 0x1p-20);
  }

  double error_up(const Face& face) const {
    return triplex::error_up(
        outline_, plane_,
        {weights(face->vertex(0)), weights(face->vertex(1)), weights(face->vertex(2))}, allowed_);
  }

  Vertex split(const Face& face) {
    const bool too_far = has_chart_ && allowed_ > 0 && !(error_up(face) <= allowed_);
    const Point2 &a = face->vertex(0)->point(), &b = face->vertex(1)->point(),
                 &c = face->vertex(2)->point();
    const bool too_thin = squared_least_sine(a, b, c) < kLeastSine * kLeastSine;
    if (!too_far && !too_thin) return {};
    if (const Vertex v = insert_circumcentre(face); v != Vertex{}) return v;
    return too_far ? insert_on_longest_edge(face) : Vertex{};
  }

  /// Unless the boundary is in the way or too near: in the circle over one of its segments.
  Vertex insert_circumcentre(const Face& face) {
    const Point2 centre = t_.circumcenter(face);
    if (squared(centre, face->vertex(0)->point()) < squared_shortest()) return {};
    if (!std::isfinite(centre.x()) || !std::isfinite(centre.y())) return {};
    Triangulation::Locate_type type;
    int k = 0;
    const Face at = t_.locate(centre, type, k, face);
    if ((type != Triangulation::FACE && type != Triangulation::EDGE) || t_.is_infinite(at) ||
        !at->info().inside)
      return {};
    std::vector<Face> conflicts;
    std::vector<Triangulation::Edge> edges;
    t_.get_conflicts_and_boundary(centre, std::back_inserter(conflicts), std::back_inserter(edges),
                                  at);
    if (std::ranges::find(conflicts, face) == conflicts.end()) return {};
    for (const auto& [beside, i] : edges) {
      if (!beside->is_constrained(i)) continue;
      const auto u = beside->vertex(Triangulation::cw(i))->point() - centre;
      const auto v = beside->vertex(Triangulation::ccw(i))->point() - centre;
      if (u * v < 0) return {};
    }
    return insert(centre, at);
  }

  Vertex insert_on_longest_edge(const Face& face) {
    int longest = -1;
    double length = 0;
    for (int k = 0; k < 3; ++k) {
      if (face->is_constrained(k)) continue;
      const double other = squared(face->vertex(Triangulation::cw(k))->point(),
                                   face->vertex(Triangulation::ccw(k))->point());
      if (other > length) longest = k, length = other;
    }
    if (longest < 0)
      return insert(CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(),
                                   face->vertex(2)->point()),
                    face);
    if (length < squared_shortest()) return {};
    return insert(CGAL::midpoint(face->vertex(Triangulation::cw(longest))->point(),
                                 face->vertex(Triangulation::ccw(longest))->point()),
                  face);
  }
  double squared_shortest() const {
    const double shortest = kShortest * outline_.cell.size();
    return shortest * shortest;
  }

  /// A new vertex of the surface over a point of a triangle.
  Vertex insert(const Point2& p, const Face& face) {
    const auto lifted = lift(p, face);
    if (!lifted) return {};
    const Point2 placed = in_plane(*lifted);
    Triangulation::Locate_type type;
    int k = 0;
    const Face at = t_.locate(placed, type, k, face);
    if ((type != Triangulation::FACE && type != Triangulation::EDGE) || t_.is_infinite(at) ||
        !at->info().inside || (type == Triangulation::EDGE && at->is_constrained(k)))
      return {};
    inside_.push_back(*lifted);
    const Vertex v = t_.insert(placed, type, at, k);
    v->info() = static_cast<std::uint32_t>(outline_.boundary.size() + inside_.size() - 1);
    auto around = t_.incident_faces(v), done = around;
    do {
      const Face next = around;
      if (!t_.is_infinite(next)) next->info().inside = true;
    } while (++around != done);
    return v;
  }
  std::optional<Weights> lift(const Point2& p, const Face& face) const {
    const auto area = [](const Point2& a, const Point2& b, const Point2& c) {
      return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    };
    const Point2 &a = face->vertex(0)->point(), &b = face->vertex(1)->point(),
                 &c = face->vertex(2)->point();
    const double whole = area(a, b, c);
    if (!(whole > 0)) return std::nullopt;
    const double u = area(p, b, c) / whole, v = area(a, p, c) / whole;
    if (!(std::min({u, v, 1 - u - v}) >= -1 && std::max({u, v, 1 - u - v}) <= 2))
      return std::nullopt;
    const Weights flat = u * weights(face->vertex(0)) +
                         (v * weights(face->vertex(1)) + (1 - u - v) * weights(face->vertex(2)));
    return over(flat);
  }
  /// The point of the surface above or below one of the cell, if it is in the cell.
  std::optional<Weights> over(const Weights& flat) const {
    const auto lifted =
        move_to_surface(outline_.cell, outline_.f, flat, plane_.up_weights, outline_.cell.size());
    return lifted && *std::ranges::min_element(*lifted) >= 0 ? lifted : std::nullopt;
  }

  const PatchOutline& outline_;
  const Chart& plane_;
  const bool has_chart_;
  double allowed_ = 0;
  Triangulation t_;
  bool clockwise_ = false;
  std::vector<Weights> inside_;
};

/// The plane across the vector area of the outline: only to look at it.
std::optional<Chart> plane_of(const PatchOutline& outline) {
  Vector area = Vector::Zero();
  Vector last = outline.cell.position(outline.boundary.back()) - outline.cell.corner(0);
  for (const Weights& w : outline.boundary) {
    const Vector x = outline.cell.position(w) - outline.cell.corner(0);
    area += last.cross(x);
    last = x;
  }
  if (!(area.norm() > 0)) return std::nullopt;
  Chart plane;
  plane.origin = outline.cell.corner(0);
  plane.up = area.normalized();
  plane.across1 = plane.up.unitOrthogonal();
  plane.across2 = plane.up.cross(plane.across1);
  return plane;
}

/// Where nothing is known of the surface, chords are divided in their middles.
std::optional<Weights> stay(const Weights&) { return std::nullopt; }

PatchTriangles fan(std::span<const Weights> corners) {
  PatchTriangles result;
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) result.triangles.push_back({0, i, i + 1});
  divide_chords(corners, stay, result);
  return result;
}

PatchTriangles without_chart(const PatchOutline& outline) {
  if (outline.boundary.size() > 3)
    if (const auto plane = plane_of(outline)) {
      PatchMesher mesher(outline, *plane, false, 0);
      if (mesher.start()) return mesher.take(false);
    }
  return fan(outline.boundary);
}

}  // namespace

PatchTriangles triangulate_patch(const PatchOutline& outline, double tolerance) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!outline.chart) return without_chart(outline);
  const bool is_proven = outline.deviation < kInfinite && outline.value < kInfinite;
  PatchMesher mesher(outline, *outline.chart, is_proven, tolerance);
  if (mesher.start()) {
    if (is_proven && tolerance < kInfinite) mesher.refine();
    return mesher.take(is_proven);
  }
  if (outline.boundary.size() > kMostCornersOfLeastDisc) return without_chart(outline);
  PatchTriangles result;
  std::vector<std::array<double, 2>> corners;
  for (const Weights& w : outline.boundary)
    corners.push_back(outline.chart->project(outline.cell.position(w)));
  result.triangles = least_disc(corners);
  result.is_tangled = is_proven;
  if (is_proven) result.error = error_of_tangled(outline, result.triangles);
  divide_chords(outline.boundary, stay, result);  // the same set of points
  if (!result.inside.empty()) result.vertex_error = result.error;
  return result;
}

}  // namespace triplex

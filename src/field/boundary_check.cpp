// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "describe.hpp"
#include "first_index.hpp"
#include "half_faces.hpp"
#include "triplex/field/bad_input.hpp"
#include "triplex/field/orientation.hpp"

namespace triplex::detail {
namespace {

// ---- exact predicates on triangles with exact orientation tests ----

using Point2 = std::array<double, 2>;
using Triangle = std::array<Point, 3>;

int orient(const Point& a, const Point& b, const Point& c, const Point& d) {
  return static_cast<int>(orientation(a, b, c, d));
}

int orient(const Point2& a, const Point2& b, const Point2& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return CGAL::orientation(Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1]),
                           Kernel::Point_2(c[0], c[1]));
}

/// The point without its coordinate `axis`.
Point2 project(const Point& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

/// An axis along which the triangle does not project to a segment. \pre it is no segment itself.
int projection_axis(const Triangle& t) {
  for (int axis = 2; axis > 0; --axis) {
    if (orient(project(t[0], axis), project(t[1], axis), project(t[2], axis)) != 0) return axis;
  }
  return 0;
}

bool in_range(double lo, double x, double hi) {
  return std::min(lo, hi) <= x && x <= std::max(lo, hi);
}

bool on_segment(const Point2& p, const Point2& a, const Point2& b) {
  return orient(a, b, p) == 0 && in_range(a[0], p[0], b[0]) && in_range(a[1], p[1], b[1]);
}

bool segments_meet(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  if (orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0) return true;
  return on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b);
}

bool in_triangle(const Point2& p, const std::array<Point2, 3>& t) {
  const int s[3] = {orient(t[0], t[1], p), orient(t[1], t[2], p), orient(t[2], t[0], p)};
  return (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0);
}

std::array<Point2, 3> project(const Triangle& t, int axis) {
  return {project(t[0], axis), project(t[1], axis), project(t[2], axis)};
}

/// Whether p lies in the closed triangle.
bool in_triangle(const Point& p, const Triangle& t) {
  if (orient(t[0], t[1], t[2], p) != 0) return false;
  const int axis = projection_axis(t);
  return in_triangle(project(p, axis), project(t, axis));
}

/// Whether a segment meets a triangle that lies in a plane with it.
bool coplanar_meet(const Point& p, const Point& q, const Triangle& t) {
  const int axis = projection_axis(t);
  const auto flat = project(t, axis);
  const Point2 a = project(p, axis), b = project(q, axis);
  return in_triangle(a, flat) || segments_meet(a, b, flat[0], flat[1]) ||
         segments_meet(a, b, flat[1], flat[2]) || segments_meet(a, b, flat[2], flat[0]);
}

/// Whether the closed segment pq meets the closed triangle.
bool meet(const Point& p, const Point& q, const Triangle& t) {
  const int side_p = orient(t[0], t[1], t[2], p);
  const int side_q = orient(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return coplanar_meet(p, q, t);
  const int s[3] = {orient(p, q, t[0], t[1]), orient(p, q, t[1], t[2]), orient(p, q, t[2], t[0])};
  return (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) || (s[0] <= 0 && s[1] <= 0 && s[2] <= 0);
}

/// Whether all of one triangle lies strictly on one side of the plane of the other.
bool separated(const Triangle& a, const Triangle& b) {
  const int s = orient(b[0], b[1], b[2], a[0]);
  return s != 0 && s == orient(b[0], b[1], b[2], a[1]) && s == orient(b[0], b[1], b[2], a[2]);
}

bool disjoint_triangles_meet(const Triangle& a, const Triangle& b) {
  if (separated(a, b) || separated(b, a)) return false;
  for (int i = 0; i < 3; ++i) {
    if (meet(a[i], a[(i + 1) % 3], b) || meet(b[i], b[(i + 1) % 3], a)) return true;
  }
  return false;
}

// ---- pairs of boundary faces ----

class BoundaryCheck {
 public:
  BoundaryCheck(const TensorField& field, const std::vector<BoundaryFace>& boundary)
      : field_(field), boundary_(boundary) {}

  /// Whether the two faces meet outside the simplex of their common vertices.
  bool overlap(std::size_t i, std::size_t j) const {
    // Common vertices first, in both.
    auto a = boundary_[i].vertices, b = boundary_[j].vertices;
    int common = 0;
    for (int k = 0; k < 3; ++k) {
      for (int l = common; l < 3; ++l) {
        if (a[k] != b[l]) continue;
        std::swap(a[k], a[common]);
        std::swap(b[l], b[common]);
        ++common;
        break;
      }
    }
    const Triangle s = triangle(a), t = triangle(b);
    if (common == 0) return disjoint_triangles_meet(s, t);
    // From a common corner, whatever else is common reaches the side opposite to it.
    if (common == 1) return meet(s[1], s[2], t) || meet(t[1], t[2], s);
    // With a common side they must be in one plane and on the same side of it.
    if (orient(s[0], s[1], s[2], t[2]) != 0) return false;
    const int axis = projection_axis(s);
    const auto u = project(s, axis), v = project(t, axis);
    return orient(u[0], u[1], u[2]) == orient(v[0], v[1], v[2]);
  }

  [[noreturn]] void refuse(std::size_t i, std::size_t j) const {
    refuse_hanging(boundary_[i], boundary_[j]);
    refuse_hanging(boundary_[j], boundary_[i]);
    throw BadInput(
        fmt::format("{} and {} cross or overlap, the mesh does not conform; mesh again so that "
                    "neighbours share "
                    "whole faces",
                    describe(boundary_[i]), describe(boundary_[j])));
  }

 private:
  Triangle triangle(const std::array<std::uint32_t, 3>& v) const {
    const auto& x = field_.mesh.points;
    return {x[v[0]], x[v[1]], x[v[2]]};
  }

  std::string describe(const BoundaryFace& f) const {
    return fmt::format("face (points {}, {}, {}) of cell {}", f.vertices[0], f.vertices[1],
                       f.vertices[2], field_.source_cell(TetId(f.tet)));
  }

  /// If a vertex of `face` lies in `other` without being a corner of it.
  void refuse_hanging(const BoundaryFace& face, const BoundaryFace& other) const {
    for (const std::uint32_t v : face.vertices) {
      if (std::ranges::find(other.vertices, v) != other.vertices.end()) continue;
      if (!in_triangle(field_.mesh.points[v], triangle(other.vertices))) continue;
      throw BadInput(fmt::format(
          "hanging node: {} lies on {} but is no corner of it, the mesh does not conform; mesh "
          "again, or split the coarser neighbour too",
          describe_point(field_, v), describe(other)));
    }
  }

  const TensorField& field_;
  const std::vector<BoundaryFace>& boundary_;
};

}  // namespace

void check_boundary(const TensorField& field, const std::vector<BoundaryFace>& boundary) {
  using FaceBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  std::vector<FaceBox> boxes;
  boxes.reserve(boundary.size());
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    Point lo = field.mesh.points[boundary[i].vertices[0]], hi = lo;
    for (int k = 1; k < 3; ++k) {
      const Point& x = field.mesh.points[boundary[i].vertices[k]];
      for (int axis = 0; axis < 3; ++axis) {
        lo[axis] = std::min(lo[axis], x[axis]);
        hi[axis] = std::max(hi[axis], x[axis]);
      }
    }
    boxes.emplace_back(CGAL::Bbox_3(lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]),
                       static_cast<std::uint32_t>(i));
  }
  // The first pair at fault, as one number.
  constexpr auto kNone = std::numeric_limits<std::uint64_t>::max();
  std::atomic<std::uint64_t> first{kNone};
  const BoundaryCheck check(field, boundary);
  CGAL::box_self_intersection_d<CGAL::Parallel_tag>(
      boxes.begin(), boxes.end(), [&](const FaceBox& a, const FaceBox& b) {
        const auto [i, j] = std::minmax({a.info(), b.info()});
        const std::uint64_t pair = std::uint64_t{i} << 32 | j;
        if (pair < first.load(std::memory_order_relaxed) && check.overlap(i, j)) {
          lower_to(first, pair);
        }
      });
  if (first != kNone) check.refuse(first >> 32, first & 0xffffffffu);
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_contact.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <utility>

namespace triplex::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner = Kernel::Point_3;
using Flat = Kernel::Point_2;

Corner at(const Point& p) { return {p[0], p[1], p[2]}; }

/// Two cells with their common vertices in front, in the same order.
class Pair {
 public:
  Pair(const Cell& a, const Cell& b, std::span<const Point> points)
      : sizes_{a.size, b.size}, vertices_{a.vertices, b.vertices} {
    for (int i = 0; i < sizes_[0]; ++i) {
      const auto begin = vertices_[1].begin(), end = begin + sizes_[1];
      const auto same = std::find(begin + shared_, end, vertices_[0][static_cast<std::size_t>(i)]);
      if (same == end) continue;
      std::iter_swap(begin + shared_, same);
      std::swap(vertices_[0][static_cast<std::size_t>(shared_)],
                vertices_[0][static_cast<std::size_t>(i)]);
      ++shared_;
    }
    for (std::size_t cell = 0; cell < 2; ++cell)
      for (std::size_t i = 0; i < static_cast<std::size_t>(sizes_[cell]); ++i)
        corners_[cell][i] = at(points[vertices_[cell][i]]);
  }

  int shared() const { return shared_; }

  /// Whether they meet beyond their common face.
  bool meet() const {
    if (sizes_[0] == 2 && sizes_[1] == 2) return segments_meet();
    if (sizes_[0] == 2) return segment_meets(0);
    if (sizes_[1] == 2) return segment_meets(1);
    switch (shared_) {
      case 0:
        return CGAL::do_intersect(triangle(0), triangle(1));
      case 1:
        return wedge_meets();
      case 2:
        return coplanar() && overlap();
      default:
        return true;  // the same triangle twice
    }
  }

  /// \pre they meet.
  ContactKind kind() const {
    if (sizes_[0] == 2 && sizes_[1] == 2)
      return collinear() ? ContactKind::Overlap : ContactKind::Touching;
    if (sizes_[0] == 3 && sizes_[1] == 3 && coplanar())
      return overlap() ? ContactKind::Overlap : ContactKind::Touching;
    return pierced(0) || pierced(1) ? ContactKind::Crossing : ContactKind::Touching;
  }

 private:
  const Corner& corner(std::size_t cell, int i) const {
    return corners_[cell][static_cast<std::size_t>(i)];
  }
  Kernel::Triangle_3 triangle(std::size_t cell) const {
    return {corner(cell, 0), corner(cell, 1), corner(cell, 2)};
  }
  Kernel::Segment_3 side(std::size_t cell, int i, int j) const {
    return {corner(cell, i), corner(cell, j)};
  }
  /// The side of the plane of a triangle on which a point lies.
  CGAL::Orientation above(std::size_t cell, const Corner& p) const {
    return CGAL::orientation(corner(cell, 0), corner(cell, 1), corner(cell, 2), p);
  }

  bool coplanar() const {
    for (int i = shared_; i < 3; ++i)
      if (above(0, corner(1, i)) != CGAL::COPLANAR) return false;
    return true;
  }

  /// One common vertex: beyond it they meet if and only if one meets the side of the other that
  /// lies opposite.
  bool wedge_meets() const {
    for (const std::size_t cell : {0u, 1u}) {
      const CGAL::Orientation one = above(cell, corner(1 - cell, 1));
      if (one != CGAL::COPLANAR && above(cell, corner(1 - cell, 2)) == one) return false;
    }
    return CGAL::do_intersect(triangle(0), side(1, 1, 2)) ||
           CGAL::do_intersect(triangle(1), side(0, 1, 2));
  }

  /// The segment is cell `cell`, the other one a triangle.
  bool segment_meets(std::size_t cell) const {
    const std::size_t other = 1 - cell;
    if (shared_ == 0) return CGAL::do_intersect(triangle(other), side(cell, 0, 1));
    if (shared_ == 2) return false;  // it is a side
    // Both leave a common vertex: the one that ends first ends on the other.
    if (above(other, corner(cell, 1)) != CGAL::COPLANAR) return false;
    return CGAL::do_intersect(triangle(other), corner(cell, 1)) ||
           CGAL::do_intersect(side(other, 1, 2), side(cell, 0, 1));
  }

  bool collinear() const {
    return CGAL::collinear(corner(0, 0), corner(0, 1), corner(1, 1)) &&
           (shared_ > 0 || CGAL::collinear(corner(0, 0), corner(0, 1), corner(1, 0)));
  }
  bool segments_meet() const {
    if (shared_ == 0) return CGAL::do_intersect(side(0, 0, 1), side(1, 0, 1));
    if (shared_ == 2) return true;  // the same segment twice
    return collinear() &&
           (side(0, 0, 1).has_on(corner(1, 1)) || side(1, 0, 1).has_on(corner(0, 1)));
  }

  /// Whether the inside of a side of the other cell passes through the inside of triangle `cell`.
  bool pierced(std::size_t cell) const {
    if (sizes_[cell] != 3) return false;
    const int sides = sizes_[1 - cell] == 3 ? 3 : 1;
    for (int i = 0; i < sides; ++i) {
      const Corner& p = corner(1 - cell, i);
      const Corner& q = corner(1 - cell, (i + 1) % 3);
      if (above(cell, p) * above(cell, q) != CGAL::NEGATIVE) continue;
      const CGAL::Orientation turn = CGAL::orientation(p, q, corner(cell, 0), corner(cell, 1));
      if (turn != CGAL::COPLANAR &&
          CGAL::orientation(p, q, corner(cell, 1), corner(cell, 2)) == turn &&
          CGAL::orientation(p, q, corner(cell, 2), corner(cell, 0)) == turn)
        return true;
    }
    return false;
  }

  /// Whether coplanar triangles have a common area: no line through a side of one has them on
  /// different sides. Decided in a coordinate plane onto which theirs projects.
  bool overlap() const {
    std::array<std::array<Flat, 3>, 2> flat;
    for (int left_out = 0; left_out < 3; ++left_out) {
      for (std::size_t cell = 0; cell < 2; ++cell)
        for (std::size_t i = 0; i < 3; ++i)
          flat[cell][i] = {corners_[cell][i][(left_out + 1) % 3],
                           corners_[cell][i][(left_out + 2) % 3]};
      if (!CGAL::collinear(flat[0][0], flat[0][1], flat[0][2])) break;
    }
    for (const std::size_t cell : {0u, 1u}) {
      const auto& own = flat[cell];
      const CGAL::Orientation inside = CGAL::orientation(own[0], own[1], own[2]);
      for (std::size_t i = 0; i < 3; ++i)
        if (std::ranges::none_of(flat[1 - cell], [&](const Flat& p) {
              return CGAL::orientation(own[i], own[(i + 1) % 3], p) == inside;
            }))
          return false;
    }
    return true;
  }

  std::array<int, 2> sizes_;
  std::array<std::array<std::uint32_t, 3>, 2> vertices_;
  int shared_ = 0;
  std::array<std::array<Corner, 3>, 2> corners_;
};

}  // namespace

bool is_degenerate(const Cell& cell, std::span<const Point> points) {
  const auto& [a, b, c] = cell.vertices;
  if (cell.size == 2) return a == b;
  return a == b || b == c || c == a || CGAL::collinear(at(points[a]), at(points[b]), at(points[c]));
}

std::optional<CellContact> contact_of(const Cell& a, const Cell& b, std::span<const Point> points) {
  const Pair pair(a, b, points);
  if (!pair.meet()) return std::nullopt;
  return CellContact{pair.kind(), static_cast<std::uint8_t>(pair.shared())};
}

}  // namespace triplex::detail

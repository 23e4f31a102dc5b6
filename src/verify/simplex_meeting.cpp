// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simplex_meeting.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <optional>

namespace triplex::detail {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle = std::array<std::uint32_t, 3>;

SimplexKey key(std::initializer_list<std::uint32_t> vertices) {
  SimplexKey k = {kNoVertex, kNoVertex, kNoVertex};
  std::ranges::copy(vertices, k.begin());
  std::ranges::sort(k);
  return k;
}

class Finder {
 public:
  explicit Finder(std::span<const Point> points) : points_(points) {}

  int above(const Triangle& t, std::uint32_t v) const {
    return CGAL::orientation(at(t[0]), at(t[1]), at(t[2]), at(v));
  }

  /// The smallest simplex of `t` that holds the point where the line through `p` and `q`, which
  /// are on different sides of its plane, meets that.
  std::optional<SimplexKey> pierced(const Triangle& t, std::uint32_t p, std::uint32_t q) const {
    return held(t, [&](std::uint32_t a, std::uint32_t b) {
      return CGAL::orientation(at(p), at(q), at(a), at(b));
    });
  }

  /// The same of a vertex in its plane.
  std::optional<SimplexKey> holding(const Triangle& t, std::uint32_t v) const {
    int left_out = 0;
    while (CGAL::collinear(flat(t[0], left_out), flat(t[1], left_out), flat(t[2], left_out)))
      ++left_out;
    return held(t, [&](std::uint32_t a, std::uint32_t b) {
      return CGAL::orientation(flat(a, left_out), flat(b, left_out), flat(v, left_out));
    });
  }

 private:
  Kernel::Point_3 at(std::uint32_t v) const {
    return {points_[v][0], points_[v][1], points_[v][2]};
  }
  Kernel::Point_2 flat(std::uint32_t v, int left_out) const {
    const auto k = static_cast<std::size_t>(left_out);
    return {points_[v][(k + 1) % 3], points_[v][(k + 2) % 3]};
  }

  /// turn(a, b): the side of the line through a and b, two corners in a row, on which a point of
  /// the plane lies.
  template <class Turn>
  std::optional<SimplexKey> held(const Triangle& t, const Turn& turn) const {
    std::array<int, 3> side;
    for (std::size_t i = 0; i < 3; ++i) side[i] = turn(t[i], t[(i + 1) % 3]);
    const auto [low, high] = std::ranges::minmax(side);
    if (low < 0 && high > 0) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i)  // on two sides: their common corner
      if (side[i] == 0 && side[(i + 1) % 3] == 0) return key({t[(i + 1) % 3]});
    for (std::size_t i = 0; i < 3; ++i)
      if (side[i] == 0) return key({t[i], t[(i + 1) % 3]});
    return key({t[0], t[1], t[2]});
  }

  std::span<const Point> points_;
};

using Rational = CGAL::Gmpq;
using Exact = CGAL::Simple_cartesian<Rational>;

int size_of(const SimplexKey& k) { return k[1] == kNoVertex ? 1 : k[2] == kNoVertex ? 2 : 3; }

/// Where on the way from the first to the second end an edge meets the plane of a triangle, or the
/// line of another edge.
Rational parameter(const std::array<Exact::Point_3, 2>& edge, const SimplexKey& other,
                   const std::array<Exact::Point_3, 3>& x) {
  const Exact::Vector_3 d = edge[1] - edge[0], r = x[0] - edge[0], u = x[1] - x[0];
  if (size_of(other) == 3) {
    const Exact::Vector_3 n = CGAL::cross_product(u, x[2] - x[0]);
    return (r * n) / (d * n);
  }
  const Exact::Vector_3 n = CGAL::cross_product(d, u);  // not zero: they have one common point
  return (CGAL::cross_product(r, u) * n) / (n * n);
}

}  // namespace

Meetings meetings_of(const Triangle& first, const Triangle& second, std::span<const Point> points) {
  const Finder find(points);
  Meetings result;
  const auto look = [&](const Triangle& a, const Triangle& b, const auto& add) {
    std::array<int, 3> side;
    for (std::size_t i = 0; i < 3; ++i) side[i] = find.above(b, a[i]);
    if (side == std::array{0, 0, 0}) {
      result.coplanar = true;
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (side[i] * side[j] < 0)
        if (const auto held = find.pierced(b, a[i], a[j])) add(key({a[i], a[j]}), *held);
      if (side[i] == 0)
        if (const auto held = find.holding(b, a[i])) add(key({a[i]}), *held);
    }
  };
  look(first, second, [&](const SimplexKey& f, const SimplexKey& s) {
    result.ends.push_back({f, s});
  });
  look(second, first, [&](const SimplexKey& s, const SimplexKey& f) {
    result.ends.push_back({f, s});
  });
  std::ranges::sort(result.ends);
  result.ends.erase(std::unique(result.ends.begin(), result.ends.end()), result.ends.end());
  return result;
}

Point place_of(const Meeting& meeting, std::span<const Point> points) {
  if (size_of(meeting.first) == 1) return points[meeting.first[0]];
  if (size_of(meeting.second) == 1) return points[meeting.second[0]];
  const bool first = size_of(meeting.first) == 2;
  const SimplexKey& edge = first ? meeting.first : meeting.second;
  const SimplexKey& other = first ? meeting.second : meeting.first;
  const auto at = [&](std::uint32_t v) {
    return Exact::Point_3(points[v][0], points[v][1], points[v][2]);
  };
  const std::array ends = {at(edge[0]), at(edge[1])};
  std::array<Exact::Point_3, 3> corners;
  for (std::size_t i = 0; i < static_cast<std::size_t>(size_of(other)); ++i)
    corners[i] = at(other[i]);
  const Exact::Point_3 place = ends[0] + parameter(ends, other, corners) * (ends[1] - ends[0]);
  return {CGAL::to_double(place.x()), CGAL::to_double(place.y()), CGAL::to_double(place.z())};
}

}  // namespace triplex::detail

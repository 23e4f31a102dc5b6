// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simplex_distance.hpp"

#include <algorithm>

namespace triplex::detail {
namespace {

Foot foot_at(const Point& p, const Point& x) { return {squared_distance(p, x), x}; }

Foot nearest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Point u = minus(b, a);
  const double along = dot(minus(p, a), u);
  const double length = dot(u, u);
  if (!(along > 0)) return foot_at(p, a);
  if (along >= length) return foot_at(p, b);
  const double t = along / length;
  return foot_at(p, {a[0] + t * u[0], a[1] + t * u[1], a[2] + t * u[2]});
}

}  // namespace

Foot nearest_on_simplex(const Point& p, const Corners& simplex) {
  const auto& [a, b, c] = simplex;
  Foot best = nearest_on_segment(p, a, b);
  if (b == c) return best;
  for (const Foot& foot : {nearest_on_segment(p, b, c), nearest_on_segment(p, c, a)})
    if (foot.squared < best.squared) best = foot;
  // The foot of the perpendicular on the plane, by its barycentric coordinates where they are
  // positive. Where rounding puts them wrong the point is still in the triangle, so an upper bound.
  const Point u = minus(b, a);
  const Point v = minus(c, a);
  const Point w = minus(p, a);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double whole = uu * vv - uv * uv;
  const double s = (vv * wu - uv * wv) / whole;
  const double t = (uu * wv - uv * wu) / whole;
  if (!(whole > 0 && s > 0 && t > 0 && s + t < 1)) return best;
  const Foot inner = foot_at(p, {a[0] + (s * u[0] + t * v[0]), a[1] + (s * u[1] + t * v[1]),
                                 a[2] + (s * u[2] + t * v[2])});
  return inner.squared < best.squared ? inner : best;
}

double squared_reach(const Corners& corners, const Corners& simplex) {
  double reach = 0;
  for (const Point& p : corners) reach = std::max(reach, nearest_on_simplex(p, simplex).squared);
  return reach;
}

}  // namespace triplex::detail

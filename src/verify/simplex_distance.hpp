// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex::detail {

/// A triangle, a segment (the last two corners equal) or a point (all equal).
using Corners = std::array<Point, 3>;

inline Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double squared_distance(const Point& a, const Point& b) {
  const Point d = minus(a, b);
  return dot(d, d);
}
inline Point middle(const Point& a, const Point& b) {
  return {a[0] + 0.5 * (b[0] - a[0]), a[1] + 0.5 * (b[1] - a[1]), a[2] + 0.5 * (b[2] - a[2])};
}

/// A point of a simplex near to a given one, and its squared distance.
struct Foot {
  double squared;
  Point point;
};

/// The nearest point of a simplex, degenerate ones too, up to rounding; exactly the corner, with
/// distance 0, where `p` is one. The distance returned is never less than the true one by more
/// than rounding, as it is that to `point`.
Foot nearest_on_simplex(const Point& p, const Corners& simplex);

/// The largest squared distance of a point of the simplex spanned by `corners` to `simplex`: that
/// of a corner, as the distance to a convex set is convex.
double squared_reach(const Corners& corners, const Corners& simplex);

}  // namespace triplex::detail

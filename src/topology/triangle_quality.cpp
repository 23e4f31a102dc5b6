// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/triangle_quality.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triplex {
namespace {

/// The smallest angle in radians, opposite to the shortest side: atan2 of twice the area and the dot
/// product of the other two sides, which keeps its digits for needles.
double smallest_angle(const Point& a, const Point& b, const Point& c) {
  const auto angle_at = [](const Point& x, const Point& y, const Point& z) {
    std::array<double, 3> u, v;
    for (std::size_t k = 0; k < 3; ++k) u[k] = y[k] - x[k], v[k] = z[k] - x[k];
    const double area = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                   u[0] * v[1] - u[1] * v[0]);
    return std::atan2(area, u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
  };
  return std::min({angle_at(a, b, c), angle_at(b, c, a), angle_at(c, a, b)});
}

}  // namespace

AngleHistogram smallest_angles_approx(std::span<const Point> points,
                                      std::span<const std::array<std::uint32_t, 3>> triangles) {
  AngleHistogram histogram;
  for (const auto& [a, b, c] : triangles) {
    const double degrees =
        smallest_angle(points[a], points[b], points[c]) * 180 / std::numbers::pi;
    histogram.smallest = std::min(histogram.smallest, degrees);
    ++histogram.counts[std::min<std::size_t>(static_cast<std::size_t>(degrees / 10), 5)];
  }
  return histogram;
}

}  // namespace triplex

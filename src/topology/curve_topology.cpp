// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/curve_topology.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "compensated_sum.hpp"
#include "disjoint_sets.hpp"

namespace triplex {

CurveTopology curve_topology(std::span<const std::array<std::uint32_t, 2>> segments,
                             std::size_t points) {
  DisjointSets sets(points);
  std::vector<std::uint32_t> degree(points, 0);
  for (const auto& [a, b] : segments) {
    if (a >= points || b >= points) {
      throw std::invalid_argument("curve_topology: vertex index out of range");
    }
    if (a == b) throw std::invalid_argument("curve_topology: a segment uses a vertex twice");
    ++degree[a];
    ++degree[b];
    sets.unite(a, b);
  }
  CurveTopology result;
  result.segments = segments.size();
  std::vector<bool> open(points, false);  // by the representative of the component
  for (std::uint32_t v = 0; v < points; ++v) {
    if (degree[v] == 0) continue;
    ++result.vertices;
    if (degree[v] == 1) ++result.ends;
    if (degree[v] > 2) ++result.branches;
    if (degree[v] != 2) open[sets.find(v)] = true;
  }
  for (std::uint32_t v = 0; v < points; ++v) {
    if (degree[v] == 0 || sets.find(v) != v) continue;
    ++result.components;
    if (!open[v]) ++result.closed;
  }
  return result;
}

double length_approx(std::span<const Point> points,
                     std::span<const std::array<std::uint32_t, 2>> segments) {
  CompensatedSum sum;
  for (const auto& [a, b] : segments) {
    sum.add(std::hypot(points[b][0] - points[a][0], points[b][1] - points[a][1],
                       points[b][2] - points[a][2]));
  }
  return sum.value();
}

}  // namespace triplex

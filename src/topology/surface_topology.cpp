// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/surface_topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "compensated_sum.hpp"
#include "triplex/topology/disjoint_sets.hpp"

namespace triplex {
namespace {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

// Corner c = 3 t + i is vertex i of triangle t. Side c runs from corner c to the next corner.
std::uint32_t next_corner(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
std::uint32_t vertex_at(Triangles triangles, std::uint32_t c) { return triangles[c / 3][c % 3]; }

struct Side {
  std::uint32_t far_end;  // the larger of the side's two vertices
  std::uint32_t corner;
};

void check_indices(Triangles triangles, std::size_t points) {
  if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3) {
    throw std::invalid_argument("surface_topology: too many triangles");
  }
  for (const auto& [a, b, c] : triangles) {
    if (a >= points || b >= points || c >= points) {
      throw std::invalid_argument("surface_topology: vertex index out of range");
    }
    if (a == b || b == c || c == a) {
      throw std::invalid_argument("surface_topology: a triangle uses a vertex twice");
    }
  }
}

// The sides of all triangles, grouped by their smaller vertex; first[v] .. first[v + 1] are v's.
struct SidesByVertex {
  std::vector<std::uint32_t> first;
  std::vector<Side> sides;
};

SidesByVertex sides_by_smaller_vertex(Triangles triangles, std::size_t points) {
  SidesByVertex result;
  result.first.assign(points + 1, 0);
  const auto corners = static_cast<std::uint32_t>(3 * triangles.size());
  for (std::uint32_t c = 0; c < corners; ++c) {
    const std::uint32_t v = std::min(vertex_at(triangles, c), vertex_at(triangles, next_corner(c)));
    ++result.first[v + 1];
  }
  for (std::size_t v = 0; v < points; ++v) result.first[v + 1] += result.first[v];
  std::vector<std::uint32_t> cursor(result.first.begin(), result.first.end() - 1);
  result.sides.resize(corners);
  for (std::uint32_t c = 0; c < corners; ++c) {
    const auto [low, high] =
        std::minmax({vertex_at(triangles, c), vertex_at(triangles, next_corner(c))});
    result.sides[cursor[low]++] = {high, c};
  }
  for (std::size_t v = 0; v < points; ++v) {
    std::sort(result.sides.begin() + result.first[v], result.sides.begin() + result.first[v + 1],
              [](const Side& a, const Side& b) {
                return a.far_end != b.far_end ? a.far_end < b.far_end : a.corner < b.corner;
              });
  }
  return result;
}

// Collects the counts edge by edge.
class Collector {
 public:
  Collector(Triangles triangles, std::size_t points)
      : triangles_(triangles), by_vertex_(points), boundary_(points), fans_(3 * triangles.size()) {
    used_.assign(points, false);
    on_boundary_.assign(points, false);
    result_.triangles = triangles.size();
    for (const auto& triangle : triangles) {
      for (const std::uint32_t v : triangle) {
        if (!used_[v]) ++result_.vertices;
        used_[v] = true;
      }
    }
    result_.components = result_.vertices;
  }

  // One edge (low, high) with all the sides that lie on it.
  void add_edge(std::uint32_t low, std::span<const Side> sides) {
    const std::uint32_t high = sides.front().far_end;
    ++result_.edges;
    if (by_vertex_.unite(low, high)) --result_.components;
    if (sides.size() == 1) add_boundary_edge(low, high);
    if (sides.size() == 2 &&
        vertex_at(triangles_, sides[0].corner) == vertex_at(triangles_, sides[1].corner)) {
      ++result_.orientation_conflicts;
    }
    if (sides.size() > 2) ++result_.nonmanifold_edges;
    for (std::size_t k = 1; k < sides.size(); ++k) join_fans(sides[0].corner, sides[k].corner);
  }

  SurfaceTopology finish() {
    result_.euler = static_cast<std::int64_t>(result_.vertices) -
                    static_cast<std::int64_t>(result_.edges) +
                    static_cast<std::int64_t>(result_.triangles);
    count_nonmanifold_vertices();
    return result_;
  }

 private:
  void add_boundary_edge(std::uint32_t low, std::uint32_t high) {
    ++result_.boundary_edges;
    for (const std::uint32_t v : {low, high}) {
      if (!on_boundary_[v]) ++result_.boundary_loops;
      on_boundary_[v] = true;
    }
    if (boundary_.unite(low, high)) --result_.boundary_loops;
  }

  // Two triangles that share an edge belong to one fan at each of its ends.
  void join_fans(std::uint32_t side, std::uint32_t other) {
    std::uint32_t start = other;
    std::uint32_t end = next_corner(other);
    if (vertex_at(triangles_, side) != vertex_at(triangles_, start)) std::swap(start, end);
    fans_.unite(side, start);
    fans_.unite(next_corner(side), end);
  }

  // A vertex is manifold when the corners at it form one fan.
  void count_nonmanifold_vertices() {
    const auto corners = static_cast<std::uint32_t>(3 * triangles_.size());
    std::vector<std::uint8_t> fans(used_.size(), 0);  // 0, 1, or 2 for more
    for (std::uint32_t c = 0; c < corners; ++c) {
      if (fans_.find(c) != c) continue;
      std::uint8_t& count = fans[vertex_at(triangles_, c)];
      if (count == 1) ++result_.nonmanifold_vertices;
      count = static_cast<std::uint8_t>(std::min(count + 1, 2));
    }
  }

  Triangles triangles_;
  SurfaceTopology result_;
  DisjointSets by_vertex_;
  DisjointSets boundary_;
  DisjointSets fans_;
  std::vector<bool> used_;
  std::vector<bool> on_boundary_;
};

}  // namespace

SurfaceTopology surface_topology(Triangles triangles, std::size_t points) {
  check_indices(triangles, points);
  const SidesByVertex grouped = sides_by_smaller_vertex(triangles, points);
  Collector collector(triangles, points);
  for (std::uint32_t v = 0; v < points; ++v) {
    const std::span<const Side> sides(grouped.sides.data() + grouped.first[v],
                                      grouped.sides.data() + grouped.first[v + 1]);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
      while (end < sides.size() && sides[end].far_end == sides[begin].far_end) ++end;
      collector.add_edge(v, sides.subspan(begin, end - begin));
    }
  }
  return collector.finish();
}

double area_approx(std::span<const Point> points, Triangles triangles) {
  CompensatedSum sum;
  for (const auto& [a, b, c] : triangles) {
    const Point& o = points[a];
    const Point u{points[b][0] - o[0], points[b][1] - o[1], points[b][2] - o[2]};
    const Point v{points[c][0] - o[0], points[c][1] - o[1], points[c][2] - o[2]};
    sum.add(0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]));
  }
  return sum.value();
}

}  // namespace triplex

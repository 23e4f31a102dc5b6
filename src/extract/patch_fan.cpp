// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_fan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

namespace triplex {
namespace {

/// The vertex from which a loop is fanned. It must not depend on where the loop starts or which way
/// it runs. No diagonal should lie in a face of the tet, where a neighbour might use it too (this
/// can only happen in open tets, where a page may have two arcs on a face); then a spine point;
/// then the lowest.
std::size_t apex_of(const PatchLoop& loop) {
  const std::size_t n = loop.size;
  const auto rank = [&](std::size_t i) {
    int diagonals_in_faces = 0;
    for (std::size_t k = 2; k + 1 < n; ++k)
      diagonals_in_faces += (loop[i].faces & loop[(i + k) % n].faces) != 0;
    return std::tuple(diagonals_in_faces, !loop[i].on_spine, loop[i].number);
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (rank(i) < rank(best)) best = i;
  return best;
}

/// The ends of the edge that a crossing lies on, in the tet: an edge is on the faces that lack
/// neither of its ends.
std::array<std::size_t, 2> ends_of(const PatchVertex& v) {
  const unsigned ends = ~static_cast<unsigned>(v.faces) & 0b1111u;
  return {static_cast<std::size_t>(std::countr_zero(ends)),
          static_cast<std::size_t>(std::bit_width(ends) - 1)};
}

/// Four times the squared distance of the middles of two edges.
double between_middles(const std::array<Point, 4>& x, const PatchVertex& u, const PatchVertex& v) {
  const auto [a, b] = ends_of(u);
  const auto [c, d] = ends_of(v);
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double difference = (x[a][k] + x[b][k]) - (x[c][k] + x[d][k]);
    sum += difference * difference;
  }
  return sum;
}

}  // namespace

std::size_t fan_apex(const PatchLoop& loop, const Leaf& leaf, const RefinableField& field) {
  const std::size_t apex = apex_of(loop);
  const auto on_edge = [](const PatchVertex& v) { return !v.on_spine; };
  if (loop.size != 4 || !std::all_of(loop.vertices.begin(), loop.vertices.begin() + 4, on_edge))
    return apex;
  std::array<Point, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i] = field.position(leaf.vertices[i]);
  // Of equals the one with the edge of the lowest ends.
  const std::size_t lowest = static_cast<std::size_t>(
      std::ranges::min_element(loop.vertices.begin(), loop.vertices.begin() + 4, {}, ends_of) -
      loop.vertices.begin());
  const double here = between_middles(corners, loop[lowest], loop[(lowest + 2) % 4]);
  const double other = between_middles(corners, loop[(lowest + 1) % 4], loop[(lowest + 3) % 4]);
  return other < here ? (lowest + 1) % 4 : lowest;
}

bool meets_edge_twice(const PatchLoop& loop) {
  for (std::size_t i = 0; i < loop.size; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!loop[i].on_spine && !loop[j].on_spine && loop[i].faces == loop[j].faces) return true;
  return false;
}

std::vector<std::array<std::size_t, 3>> triangulate(const PatchLoop& loop) {
  // The least number of diagonals in faces for the polygon i, i + 1, ..., j, and the corner that
  // makes a triangle with i and j.
  const std::size_t n = loop.size;
  constexpr std::size_t kMost = PatchLoop::kMost;
  std::array<std::array<int, kMost>, kMost> cost{};
  std::array<std::array<std::size_t, kMost>, kMost> corner{};
  const auto side_cost = [&](std::size_t i, std::size_t j) {
    const bool is_diagonal = j > i + 1 && !(i == 0 && j == n - 1);
    return is_diagonal && (loop[i].faces & loop[j].faces) != 0 ? 1 : 0;
  };
  for (std::size_t length = 2; length < n; ++length)
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t j = i + length;
      cost[i][j] = static_cast<int>(n) + 1;
      for (std::size_t k = i + 1; k < j; ++k)
        if (const int c = cost[i][k] + cost[k][j]; c < cost[i][j]) cost[i][j] = c, corner[i][j] = k;
      cost[i][j] += side_cost(i, j);
    }
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 2>> todo = {{0, n - 1}};
  while (!todo.empty()) {
    const auto [i, j] = todo.back();
    todo.pop_back();
    if (j < i + 2) continue;
    const std::size_t k = corner[i][j];
    triangles.push_back({i, k, j});
    todo.push_back({i, k});
    todo.push_back({k, j});
  }
  return triangles;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace triplex::detail {

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

/// One side of a triangle, from its lower to its higher vertex.
struct Side {
  std::uint32_t low, high;
  std::uint32_t triangle;
  std::uint32_t corner;  ///< 0, 1, 2: where the triangle passes into the side
  bool forward;          ///< the triangle passes through it from low to high
};

/// Per triangle: whether it has the vertices of one before it, in whatever order.
std::vector<bool> repeated_triangles(Triangles triangles);

/// The sides of the triangles but those marked in `left_out`, edge by edge, triangles ascending.
std::vector<Side> sorted_sides(Triangles triangles, const std::vector<bool>& left_out);

/// Calls visit(sides of one edge) for every edge, in the order of `sorted_sides`.
template <class Visit>
void for_each_edge(std::span<const Side> sides, Visit visit) {
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low &&
           sides[end].high == sides[begin].high)
      ++end;
    visit(sides.subspan(begin, end - begin));
  }
}

}  // namespace triplex::detail

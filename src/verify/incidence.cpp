// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "incidence.hpp"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>

namespace triplex::detail {

std::vector<bool> repeated_triangles(Triangles triangles) {
  struct Key {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t triangle;
  };
  std::vector<Key> keys(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    keys[t] = {triangles[t], t};
    std::ranges::sort(keys[t].vertices);
  }
  tbb::parallel_sort(keys, [](const Key& a, const Key& b) {
    return std::tie(a.vertices, a.triangle) < std::tie(b.vertices, b.triangle);
  });
  std::vector<bool> repeated(triangles.size(), false);
  for (std::size_t k = 1; k < keys.size(); ++k)
    if (keys[k].vertices == keys[k - 1].vertices) repeated[keys[k].triangle] = true;
  return repeated;
}

std::vector<Side> sorted_sides(Triangles triangles, const std::vector<bool>& left_out) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (left_out[t]) continue;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i];
      const std::uint32_t to = triangles[t][(i + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), t, i, from < to});
    }
  }
  tbb::parallel_sort(sides, [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/refine/periodic_copies.hpp"

#include <algorithm>

namespace triplex {

PeriodicCopies::PeriodicCopies(const TensorField& input, const RefinableField& field,
                               const PeriodicAxes& axes) {
  const auto pairs = find_periodic_pairs(input, axes);
  const std::vector<VertexId> vertex_of = field.vertices_of_input();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const auto& [low, high] : pairs[axis]) add_midpoint(axis, vertex_of[high], vertex_of[low]);
}

std::vector<std::array<VertexId, 2>> PeriodicCopies::copies(
    const std::array<VertexId, 2>& edge) const {
  std::vector<std::array<VertexId, 2>> found = {edge};
  for (std::size_t n = 0; n < found.size(); ++n)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const Map* map : {&to_low_[axis], &to_high_[axis]}) {
        auto copy = found[n];
        if (move(*map, copy) && !std::ranges::count(found, copy)) found.push_back(copy);
      }
  return found;
}

}  // namespace triplex

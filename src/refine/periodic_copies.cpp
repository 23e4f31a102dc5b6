// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/refine/periodic_copies.hpp"

namespace triplex {

PeriodicCopies::PeriodicCopies(const TensorField& input, const RefinableField& field,
                               const PeriodicAxes& axes) {
  const auto pairs = find_periodic_pairs(input, axes);
  const std::vector<VertexId> vertex_of = field.vertices_of_input();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const auto& [low, high] : pairs[axis]) add_midpoint(axis, vertex_of[high], vertex_of[low]);
}

}  // namespace triplex

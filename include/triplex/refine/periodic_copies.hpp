// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "triplex/field/periodic.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// The copies of vertices, edges and faces on opposite sides of a periodic domain, kept as the mesh
/// is refined. A simplex lies in a side if all its vertices do; its copy there has the copies of
/// these, in the same order. Source: proofs/refinement.md.
class PeriodicCopies {
 public:
  PeriodicCopies() = default;  ///< of a domain that is not periodic
  /// \throw BadInput as `find_periodic_pairs`.
  PeriodicCopies(const TensorField& input, const RefinableField& field, const PeriodicAxes& axes);

  bool empty() const { return to_low_[0].empty() && to_low_[1].empty() && to_low_[2].empty(); }

  /// All copies of a simplex, itself first.
  template <std::size_t N>
  std::vector<std::array<VertexId, N>> copies(const std::array<VertexId, N>& simplex) const {
    std::vector<std::array<VertexId, N>> found = {simplex};
    for (std::size_t n = 0; n < found.size(); ++n)
      for (std::size_t axis = 0; axis < 3; ++axis)
        for (const Map* map : {&to_low_[axis], &to_high_[axis]}) {
          auto copy = found[n];
          if (move(*map, copy) && !std::ranges::count(found, copy)) found.push_back(copy);
        }
    return found;
  }
  /// The midpoints of an edge and of its copy along an axis: high side, low side.
  void add_midpoint(std::size_t axis, VertexId high, VertexId low) {
    to_low_[axis][high] = low;
    to_high_[axis][low] = high;
  }
  /// The copy of a simplex on the low side across one axis, if it lies on the high side.
  template <std::size_t N>
  bool lower(std::size_t axis, std::array<VertexId, N>& simplex) const {
    return move(to_low_[axis], simplex);
  }
  /// The copy that lies on no high side.
  template <std::size_t N>
  std::array<VertexId, N> lowest(std::array<VertexId, N> simplex) const {
    for (std::size_t axis = 0; axis < 3; ++axis) lower(axis, simplex);
    return simplex;
  }

 private:
  using Map = std::unordered_map<VertexId, VertexId>;
  template <std::size_t N>
  static bool move(const Map& map, std::array<VertexId, N>& simplex) {
    std::array<VertexId, N> moved;
    for (std::size_t i = 0; i < N; ++i) {
      const auto found = map.find(simplex[i]);
      if (found == map.end()) return false;
      moved[i] = found->second;
    }
    simplex = moved;
    return true;
  }

  std::array<Map, 3> to_low_, to_high_;  // per axis
};

}  // namespace triplex

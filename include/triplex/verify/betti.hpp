// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "triplex/verify/mesh_view.hpp"

namespace triplex {

/// Betti numbers over Z/2: components, independent loops, independent closed surfaces. (A Klein
/// bottle encloses one closed surface over Z/2, like a torus.)
struct BettiNumbers {
  std::uint64_t b0 = 0;
  std::uint64_t b1 = 0;
  std::uint64_t b2 = 0;

  std::int64_t euler() const {
    return static_cast<std::int64_t>(b0 + b2) - static_cast<std::int64_t>(b1);
  }
  friend bool operator==(const BettiNumbers&, const BettiNumbers&) = default;
};

/// The Betti numbers of the complex of the triangles, their edges, the segments and the points that
/// these use. From the indices alone; coordinates do not matter, and repeated cells count once.
/// Guarantee: exact for every such complex, manifold or not: b0 by union-find, b2 as the dimension
/// of the cycles, b1 from Euler's formula.
/// Cost: that of sorting the edges, and elimination over Z/2 with one row for each edge of three
/// triangles or more: little on surfaces that meet along few curves, cubic at worst.
/// Errors: as `check_mesh`, for the cells. \throw std::invalid_argument.
BettiNumbers betti_numbers(const MeshView& mesh);

}  // namespace triplex

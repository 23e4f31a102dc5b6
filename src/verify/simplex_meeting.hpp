// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex::detail {

/// A vertex, an edge or a triangle by its vertices, ascending; kNoVertex behind them.
inline constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
using SimplexKey = std::array<std::uint32_t, 3>;

/// A point by the smallest simplices of two triangles that hold it: their insides have only that
/// point in common.
struct Meeting {
  SimplexKey first, second;
  friend auto operator<=>(const Meeting&, const Meeting&) = default;
};

/// The ends of the common part of two triangles: none, one, or two; more (or none, with
/// `coplanar`) if they lie in one plane. Exact.
struct Meetings {
  std::vector<Meeting> ends;
  bool coplanar = false;
};
/// \pre neither triangle is degenerate; equal points have equal numbers.
Meetings meetings_of(const std::array<std::uint32_t, 3>& first,
                     const std::array<std::uint32_t, 3>& second, std::span<const Point> points);

/// Its place; each coordinate is the exact one rounded towards zero.
Point place_of(const Meeting& meeting, std::span<const Point> points);

}  // namespace triplex::detail

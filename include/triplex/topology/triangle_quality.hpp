// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// How many triangles have their smallest angle in [0, 10), [10, 20), ... [50, 60] degrees. No angle
/// is larger than that of an equilateral triangle; triangles without an area are among the first.
struct AngleHistogram {
  std::array<std::uint64_t, 6> counts{};
  double smallest = 60;  ///< degrees; 60 if there are no triangles
};

/// In doubles. Shape: triangles index points.
AngleHistogram smallest_angles_approx(std::span<const Point> points,
                                      std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace triplex {

/// A unit vector that stands for a line through the origin: v and -v mean the same. The sign is
/// `with_fixed_sign`'s. All three components are NaN where there is no direction, or no unique one.
using Direction = std::array<double, 3>;

inline constexpr Direction kNoDirection = {std::numeric_limits<double>::quiet_NaN(),
                                           std::numeric_limits<double>::quiet_NaN(),
                                           std::numeric_limits<double>::quiet_NaN()};

/// v or -v, whichever has a positive leading component: the first whose magnitude is at least 9/10
/// of the largest, so that rounding does not turn vectors like (1, -1, 0) around. Like every such
/// rule it jumps somewhere: directions are lines, and their signs carry no meaning.
inline Direction with_fixed_sign(Direction v) {
  const double largest = std::fmax(std::fmax(std::fabs(v[0]), std::fabs(v[1])), std::fabs(v[2]));
  for (const double x : v) {
    if (std::fabs(x) < 0.9 * largest) continue;
    if (x < 0) v = {-v[0], -v[1], -v[2]};
    break;
  }
  return {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0};  // no negative zeros
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace triplex {

/// A polygon has n^3 / 6 triangles to choose from: no more corners than this.
inline constexpr std::size_t kMostCornersOfLeastDisc = 400;

/// Triangulates a polygon that may touch or cross itself as a disc without points inside: the one
/// with the least sum of areas, by dynamic programming over the diagonals. Of equal ones the first.
/// \pre 3 to kMostCornersOfLeastDisc corners.
std::vector<std::array<std::uint32_t, 3>> least_disc(
    std::span<const std::array<double, 2>> corners);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace triplex {

/// Witnesses are numbers that a certificate is tested with: any value is sound, a good one
/// succeeds.

/// The leading 26 bits of x, so that products with witnesses stay short in exact arithmetic.
inline double few_bits(double x) {
  const double c = x * (0x1p27 + 1);
  return c - (c - x);  // Dekker's split
}

/// A direction d with d . g > 0 for all vectors g, if the hull of the vectors avoids the origin:
/// the point of the hull nearest to the origin is one (every g satisfies g . z >= |z|^2). Unused
/// components of vectors in fewer dimensions are zero.
///
/// Computed in doubles, largest component about one, few bits; the caller tests d . g > 0 on the
/// ladder. Zero vector: the hull contains the origin, as far as doubles can tell. Source: Gilbert,
/// Johnson, Keerthi 1988.
std::array<double, 3> separating_direction(std::span<const std::array<double, 3>> vectors);

}  // namespace triplex

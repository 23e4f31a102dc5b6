// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace triplex {

/// A 3x3 tensor, row-major: entry (i, j) at index 3 i + j; for a velocity gradient d u_i / d x_j.
template <class NT>
using Tensor = std::array<NT, 9>;

/// A point in space, in the units of the input file.
using Point = std::array<double, 3>;

/// Three times the deviator, 3 T - tr(T) I: integer combinations only, so exact in any ring.
/// p and q of the result are 9 and 27 times those of the deviator.
template <class NT>
Tensor<NT> triple_deviator(const Tensor<NT>& t) {
  const NT xx = t[0] - t[4] + (t[0] - t[8]);
  const NT yy = t[4] - t[0] + (t[4] - t[8]);
  const NT zz = t[8] - t[0] + (t[8] - t[4]);
  const NT three(3);
  return {xx,           three * t[1], three * t[2],
          three * t[3], yy,           three * t[5],
          three * t[6], three * t[7], zz};
}

}  // namespace triplex

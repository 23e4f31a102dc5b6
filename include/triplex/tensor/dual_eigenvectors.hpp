// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/direction.hpp"

namespace triplex {

/// The ellipse of a tensor in the complex domain: the orbits of x' = A x in the plane that A maps
/// into itself, apart from their common growth and decay.
struct DualEigenvectors {
  Direction long_axis = kNoDirection;   ///< the major dual-eigenvector
  Direction short_axis = kNoDirection;  ///< the minor dual-eigenvector, orthogonal to it
  /// The short semi-axis over the long one, in [0, 1]: 1 a circle, 0 a line.
  double axis_ratio = std::numeric_limits<double>::quiet_NaN();
  /// sqrt(1 - axis_ratio^2), in [0, 1]: 0 a circle, 1 a line.
  double eccentricity = std::numeric_limits<double>::quiet_NaN();
};

/// The dual-eigenvectors of T. In the real Schur form with the block [[a, -c], [c, b]], a >= b, c >
/// 0 and h = (a-b)/2 they are (v1 +- v2) / sqrt(2), and axis_ratio^2 = (c - h) / (c + h).
///   complex domain       as above; both axes are `kNoDirection` if h comes out as 0: a circle;
///   degenerate surfaces  the limit from the complex domain: the repeating eigenvector, the vector
///                        orthogonal to it in the plane, and a line; at nodes nothing: all NaN;
///   spine                likewise, with the plane on which A^2 vanishes; NaN if A has rank below
///   2; real domain          all NaN.
/// Guarantee: which of these cases holds is proven. Error: with e = 2^-38 |A| (1 + |A| / g), g as
/// in `real_schur`: relative e / c in the axis ratio, e / c in eccentricity^2, and an angle of e /
/// h in the axes, so those of a near circle mean little. Signs by `with_fixed_sign`. \pre as for
/// `invariants`. Source: paper, sections Dual-Eigenvectors and Degenerate Surface.
DualEigenvectors dual_eigenvectors(const Tensor<double>& t);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// The real Schur form of a tensor, T = Q (S + mean I) Q^T, with S that of the deviator:
///
///   complex domain  a -c  d   c > 0, a >= b: the symmetric part of the upper block is diagonal;
///                   c  b  e   (a-b)^2 < 4 c^2 and the complex eigenvalues are those of the block
///                   0  0 -a-b
///   D >= 0          a  c  d   the first two eigenvalues are descending: medium, minor where q > 0;
///                   0  b  e   major, medium where q < 0; major, minor where q = 0. The third is
///                   the 0  0 -a-b dominant one, but on the real neutral surface the zero one.
///
/// The first two columns of Q span a plane that T maps into itself; across the degenerate surfaces
/// that plane is continuous. The form jumps at the real neutral surface, as the dominant
/// eigenvector does, and at the degenerate surfaces the first two columns turn by 45 degrees within
/// the plane.
struct RealSchur {
  Tensor<double> rotation{};  ///< Q, row-major, det Q = 1; its columns are v1, v2, v3
  Tensor<double> deviator{};  ///< S, row-major, in tensor units, zeros exact
  double mean = 0;            ///< tr(T) / 3

  /// S + mean I: the form of T itself. A deviator far below the trace is lost in it.
  Tensor<double> form() const;
};

/// The real Schur form of T.
/// Guarantee: the kind of the form is proven (D is certified) and so are the equalities: a = b on
/// the degenerate surfaces, S strictly upper triangular on the spine, with c the only entry that is
/// not 0 if its rank is one, S = 0 and Q = I for multiples of the identity. The diagonal of S, and
/// (a-b)^2 / 4 - c^2 in the complex domain, carry the eigenvalues with the accuracy of
/// `deviator_eigenvalues` (of roundings of c if that is larger). Error: Q is orthogonal to a few
/// roundings, and |Q S Q^T - A| <= 2^-40 |A| (1 + |A| / g) with g the distance of the third
/// eigenvalue from the nearest other; on the spine and on the degenerate surfaces without the last
/// factor. v1 has the sign of `with_fixed_sign`, v2 too unless c > 0 decides it, v3 = v1 x v2.
/// \pre as for `invariants`. Source: paper, sections Dual-Eigenvectors to Balanced Surface, whose
/// condition for a balanced form to be real is corrected: a + b = 0, not a = b = 0.
RealSchur real_schur(const Tensor<double>& t);

}  // namespace triplex

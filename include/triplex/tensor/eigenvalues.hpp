// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {

/// The eigenvalues of a tensor, in tensor units.
struct Eigenvalues {
  /// True in the real domain and on its boundary (D >= 0): `real` holds all three. False in the
  /// complex domain (D < 0): real[0] is the real eigenvalue, the others are re +- i im, im > 0.
  bool all_real = true;
  /// Descending: major, medium, minor. On the degenerate surfaces the repeating eigenvalue appears
  /// twice, bit for bit equal; on the triple degenerate curve all three are equal.
  std::array<double, 3> real{};
  double re = 0;
  double im = 0;  ///< may underflow to 0 if |im| is below 2^-1074
};

/// The eigenvalues of T from p, q and D of its deviator, by the trigonometric and hyperbolic
/// formulas. Guarantee: `all_real` and the equalities are proven. Error of each value: about 2^-44
/// of the largest modulus of an eigenvalue of the deviator, plus a few roundings of tr(T)/3,
/// however ill-conditioned the eigenvalues are (p, q and D are accurate to 2^-45 each);
/// `Eigenvalues` of the deviator alone by `deviator_eigenvalues`. \pre as for `invariants`. Source:
/// paper, Eq. 2 and 3, with two corrections. Eq. 2 as printed labels the minor eigenvalue lambda_2
/// and the medium one lambda_3: diag(1,0,-1) gives (1,-1,0). Eq. 3 has the wrong sign for p < 0 and
/// p > 0: the real eigenvalue has the sign of q, as l^3 + p l = q requires.
Eigenvalues eigenvalues(const Tensor<double>& t);
Eigenvalues deviator_eigenvalues(const Tensor<double>& t);

/// The relative error of p, q and D that the errors above are for: the best that `invariants`
/// offers.
inline constexpr double kEigenvalueAccuracy = 0x1p-45;

/// The eigenvalues of the deviator times 2^shift, from its invariants: nothing is lost where the
/// tensor, or its deviator, is close to the end of the range of doubles. Errors as above if the
/// relative error of `i` is `kEigenvalueAccuracy`, else larger in proportion.
Eigenvalues deviator_eigenvalues(const Invariants& i, int shift = 0);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/sign.hpp"
#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// A real number of any size: mantissa * 2^exponent, 1/2 <= |mantissa| < 1, or zero. Squares, cubes
/// and sixth powers of tensor entries near 1e300 or among the denormals do not fit into a double.
struct ScaledReal {
  double mantissa = 0;
  int exponent = 0;

  /// As a double: overflows to infinity and underflows as IEEE doubles do.
  double value() const;
  /// value * 2^shift as a double.
  double scaled(int shift) const;
};

/// The invariants of the deviator A = T - tr(T)/3 I with certified signs.
struct Invariants {
  ScaledReal p;             ///< minor(A) = -tr(A^2)/2, in tensor units squared
  ScaledReal q;             ///< det(A), in tensor units cubed
  ScaledReal discriminant;  ///< D = -4 p^3 - 27 q^2, in tensor units to the sixth
  Sign sign_p = Sign::Zero;
  Sign sign_q = Sign::Zero;
  Sign sign_discriminant = Sign::Zero;
  Stage stage = Stage::Filter;  ///< Exact if any of the three needed exact arithmetic
};

/// p, q and D of the deviator. Shape: any finite tensor, from denormal to |t| <= 2^1020.
/// Guarantee: the three signs are proven; each value has relative error at most `relative_error`,
/// so cancellation never spoils it (exact arithmetic steps in). \pre 2^-45 <= relative_error <= 1.
/// Source: proofs/invariants.md.
Invariants invariants(const Tensor<double>& t, double relative_error = 0x1p-30);

/// tr(T) in tensor units. Error: three roundings, relative to the diagonal; exact zero not
/// certified.
double trace_approx(const Tensor<double>& t);
/// The sign of tr(T), proven.
Sign trace_sign(const Tensor<double>& t);
/// A = T - tr(T)/3 I in doubles, each entry within a few roundings of the largest difference.
Tensor<double> deviator_approx(const Tensor<double>& t);
/// minor(A), det(A) and D of the deviator as doubles; relative error 2^-30, or IEEE
/// over-/underflow.
double minor_approx(const Tensor<double>& t);
double det_approx(const Tensor<double>& t);
double discriminant_approx(const Tensor<double>& t);
/// The Frobenius norm |T|, in tensor units; no overflow or underflow on the way.
double magnitude_approx(const Tensor<double>& t);
/// eta = tr(T) / (sqrt(3) |T|), in [-1, 1]; 0 for the zero tensor, where it is undefined.
double isotropicity_approx(const Tensor<double>& t);

}  // namespace triplex

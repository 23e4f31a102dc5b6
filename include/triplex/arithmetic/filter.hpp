// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace triplex {

/// Unit roundoff of a double in round-to-nearest.
inline constexpr double kRoundoff = 0x1p-53;

/// gamma(n) bounds the relative error of n roundings: n u / (1 - n u). The factor 1 + 2^-20 also
/// covers the roundings of the bound's own evaluation, a handful of operations in doubles.
constexpr double gamma(int n) { return n * kRoundoff / (1 - n * kRoundoff) * (1 + 0x1p-20); }

/// Below this magnitude of the tensor entries the filters step aside: products of six entries would
/// come near the underflow threshold, 6 * 150 + 53 < 1022, where roundings are no longer relative.
inline constexpr double kSmallestFiltered = 0x1p-150;

/// What is known of the doubles that stand for exact tensors: |fl(a)| <= magnitude for every entry
/// and |fl(a) - a| <= error. Filters are valid when `usable`.
struct EntryBounds {
  double magnitude = 0;
  double error = 0;

  bool usable() const { return magnitude >= kSmallestFiltered && error <= 0x1p-10 * magnitude; }
  void include(const EntryBounds& other) {
    magnitude = std::fmax(magnitude, other.magnitude);
    error = std::fmax(error, other.error);
  }
};

/// Bounds on the Bernstein coefficients P = -tr(A_i A_j) and Q = M(A_i, A_j) : A_k computed in
/// doubles by `forms_of` from entries with |a| <= M and error e.
///   P: nine products, each with at most 9 roundings:            |P| <= 9 M^2, error <= 9 gamma(9)
///   M^2
///      plus 9 ((M+e)^2 - M^2) <= 9 (2 + 2^-10) M e for the entries.
///   Q: 9 x 4 triple products, each with at most 3 + 1 + 8 = 12 roundings: |Q| <= 36 M^3,
///      error <= 36 gamma(12) M^3, plus 36 ((M+e)^3 - M^3) <= 36 (3 + 2^-8) M^2 e.
/// The magnitudes bound the computed coefficients; a simplex replaces them by the largest it has.
/// Source: proofs/filter.md.
/// `Real` is double, or several doubles that take the same steps.
template <class Real>
struct FormBoundsOf {
  Real p_magnitude{0.0}, p_error{0.0};
  Real q_magnitude{0.0}, q_error{0.0};

  FormBoundsOf() = default;
  explicit FormBoundsOf(const EntryBounds& entries)
      : FormBoundsOf(Real(entries.magnitude), Real(entries.error)) {}
  /// From the magnitude m and the error e of the entries.
  FormBoundsOf(const Real& m, const Real& e) {
    constexpr double kSlack = 1 + 0x1p-20;
    p_magnitude = 9 * m * m * kSlack;
    p_error = 9 * gamma(9) * m * m + 9 * (2 + 0x1p-9) * m * e;
    q_magnitude = 36 * m * m * m * kSlack;
    q_error = 36 * gamma(12) * m * m * m + 36 * (3 + 0x1p-7) * m * m * e;
  }
};
using FormBounds = FormBoundsOf<double>;

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/direction.hpp"

namespace triplex {

/// The real right eigenvectors of a tensor, T v = l v.
struct Eigenvectors {
  /// As in `Eigenvalues`: all three, or only that of the real eigenvalue.
  bool all_real = true;
  /// Of the eigenvalues in the order of `Eigenvalues::real`: major, medium, minor; in the complex
  /// domain the real eigenvector, and `kNoDirection` twice.
  std::array<Direction, 3> vectors{};
  /// For each the dimension of its eigenspace: 1 if the direction is unique, 2 or 3 if the vector
  /// is one choice of many, 0 if there is none.
  std::array<int, 3> dimensions{};
};

/// The real eigenvectors of T, which are those of its deviator A.
/// Guarantee: `all_real` and the dimensions are proven. Error where D is not 0: |A v - l v| <=
/// 2^-40 |A| in the Frobenius norm, so v is an exact eigenvector of a tensor that close; its own
/// angle may be off by that times |A| over the distance of the eigenvalues. No claim of
/// independence is made for nearly equal ones, except that the vectors of an exactly symmetric
/// tensor are orthogonal to rounding. Error where D = 0: a few roundings, by exact arithmetic.
/// Where eigenvalues repeat:
///   degenerate surfaces  the repeating eigenvalue's only eigenvector, in both places, bit for bit;
///   nodes                there two orthonormal vectors that span the two-dimensional eigenspace;
///   spine                the only eigenvector three times; for a deviator of rank one, A = x y^T,
///                        the directions of x, of x cross y and again of x cross y; for a multiple
///                        of the identity the axes of the coordinate system.
/// Signs by `with_fixed_sign`. \pre as for `invariants`. Source: paper, section Tensor Background;
/// proofs/repeating_eigenspace.md.
Eigenvectors eigenvectors(const Tensor<double>& t);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/exact.hpp"
#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/direction.hpp"

namespace triplex {

/// The kernel of a singular 3x3 matrix of dyadic rationals. Its dimension is exact; directions are
/// off by a few roundings.
struct ExactKernel {
  int dimension = 1;
  /// Dimension 1: the kernel. Dimension 2: an orthonormal basis. Dimension 3: two unit axes.
  Direction first{}, second{};
  Direction normal{};  ///< dimension 2: what the kernel is orthogonal to, the direction of the rows
};

/// \pre det(m) = 0.
ExactKernel exact_kernel(const Tensor<Exact>& m);

/// Multiples of A - l I for the two eigenvalues l of a deviator with D = 0, by the division-free
/// forms of its tripled deviator A': the repeating eigenvalue of A' is Q / (2 P), the dominant one
/// -Q / P. Source: proofs/repeating_eigenspace.md.
struct DegeneratePencil {
  Tensor<Exact> repeating;  ///< 2 P A' - Q I; A' itself on the spine
  Tensor<Exact> dominant;   ///< P A' + Q I; zero on the spine, where no eigenvalue dominates
};
/// \pre D = 0.
DegeneratePencil degenerate_pencil(const Tensor<double>& t);

template <class NT>
Tensor<NT> transpose(const Tensor<NT>& m) {
  return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]};
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// The number of independent eigenvectors of the repeating eigenvalue: 0 where no eigenvalue
/// repeats (D is not 0), else 1, 2 or 3. A tensor with 2 or 3 is derogatory. With p < 0 the value 2
/// means a node of the degenerate surface (every exactly degenerate symmetric tensor is one); with
/// p = q = 0 it means a nilpotent deviator of rank one; 3 is a multiple of the identity.
/// Guarantee: exact, by the rank of a matrix of dyadic rationals. \pre as for `invariants`.
/// Source: proofs/repeating_eigenspace.md.
int repeating_eigenspace_dimension(const Tensor<double>& t);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/tensor/direction.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {

/// The real Schur form of the deviator at size one: A = 2^exponent V s V^T, V with columns v.
/// Contract and errors: `RealSchur`.
struct UnitSchur {
  std::array<Direction, 3> v{};
  Tensor<double> s{};
  int exponent = 0;
  double im = 0;  ///< the imaginary part of the complex eigenvalues, at the size of s
};

/// \pre i = invariants(t, kEigenvalueAccuracy).
UnitSchur unit_schur(const Tensor<double>& t, const Invariants& i);

}  // namespace triplex

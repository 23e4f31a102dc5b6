// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/dual_eigenvectors.hpp"

#include <algorithm>
#include <cmath>

#include "linear_algebra.hpp"
#include "triplex/tensor/eigenspace.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "unit_schur.hpp"

namespace triplex {

DualEigenvectors dual_eigenvectors(const Tensor<double>& t) {
  const Invariants i = invariants(t, kEigenvalueAccuracy);
  const bool on_boundary = i.sign_discriminant == Sign::Zero;
  if (i.sign_discriminant == Sign::Positive) return {};
  if (on_boundary && repeating_eigenspace_dimension(t) > 1) return {};
  const UnitSchur schur = unit_schur(t, i);
  const auto& [v1, v2, v3] = schur.v;
  if (on_boundary) return {v1, v2, 0, 1};

  // (c - h) / (c + h) = (im / (c + h))^2, without cancellation.
  const double c = schur.s[3];
  const double h = (schur.s[0] - schur.s[4]) / 2;
  DualEigenvectors dual;
  dual.axis_ratio = std::min(1.0, schur.im / (c + h));
  dual.eccentricity = std::min(1.0, std::sqrt(2 * h / (c + h)));
  if (h == 0) return dual;
  dual.long_axis = with_fixed_sign(normalized(combination(1, v1, 1, v2)));
  dual.short_axis = with_fixed_sign(normalized(combination(1, v1, -1, v2)));
  return dual;
}

}  // namespace triplex

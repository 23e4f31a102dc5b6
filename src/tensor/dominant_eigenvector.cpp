// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/dominant_eigenvector.hpp"

#include "triplex/tensor/domain.hpp"
#include "triplex/tensor/eigenvectors.hpp"

namespace triplex {
namespace {

DominantEigenvector one(const Direction& v) { return {1, {v, kNoDirection}}; }

}  // namespace

DominantEigenvector dominant_eigenvector(const Tensor<double>& t) {
  const Invariants i = invariants(t, 1.0);
  const Eigenvectors e = eigenvectors(t);
  if (!e.all_real || i.sign_q == Sign::Positive) return one(e.vectors[0]);
  if (i.sign_q == Sign::Negative) return one(e.vectors[2]);
  if (i.sign_p != Sign::Zero) return {2, {e.vectors[0], e.vectors[2]}};
  return e.dimensions[0] == 1 ? one(e.vectors[0]) : DominantEigenvector{};
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Where the parts of a tensor are that is block triangular along an axis: the 2 x 2 block beside
/// the axis, the number on it, and the two couplings.
struct BlockEntries {
  std::size_t ii, ij, ji, jj, kk;
  std::array<std::size_t, 2> column, row;
  explicit BlockEntries(int axis) {
    const auto k = static_cast<std::size_t>(axis);
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    ii = 4 * i, jj = 4 * j, kk = 4 * k, ij = 3 * i + j, ji = 3 * j + i;
    column = {3 * i + k, 3 * j + k};
    row = {3 * k + i, 3 * k + j};
  }
};

/// Error of the polarised coefficient, in doubles, of a quadratic form of the entries of two
/// tensors whose terms are at most `terms` products of two entries, no term under more than 5
/// roundings: errors e of entries up to M change it by terms ((M + e)^2 - M^2).
inline double quadratic_form_error(const EntryBounds& b, int terms) {
  const double m = b.magnitude, e = b.error;
  return (1 + 0x1p-20) * terms * (e * (2 * m + e) + gamma(5) * m * m);
}

/// The tensors of the vertices in doubles, with the bounds of their entries.
template <int N>
std::pair<std::array<Tensor<double>, N>, EntryBounds> approximate_tensors(
    const Simplex<N>& simplex) {
  std::array<Tensor<double>, N> a;
  EntryBounds bounds;
  for (int i = 0; i < N; ++i) {
    const ApproximateTensor& v = simplex.field().approximate(simplex.vertices()[i]);
    a[i] = v.a;
    bounds.include(v.bounds);
  }
  return {a, bounds};
}

}  // namespace triplex

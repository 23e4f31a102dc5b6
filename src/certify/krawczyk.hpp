// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace triplex {

/// K(Z) = m - C f(m) + (I - C J(Z)) (Z - m), for m in Z, enclosures of f(m) and of J(Z), and any
/// matrix C. It holds every zero of f in Z; if it lies inside Z, f has exactly one there. Source:
/// proofs/node.md. \pre of intervals: inside an `IntervalRounding`.
template <class NT, std::size_t N>
std::array<NT, N> krawczyk(const std::array<NT, N>& m, const std::array<NT, N>& values,
                           const std::array<std::array<NT, N>, N>& jacobian,
                           const std::array<std::array<NT, N>, N>& inverse,
                           const std::array<NT, N>& z) {
  std::array<NT, N> image = m;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) {
      NT r(i == j ? 1 : 0);
      for (std::size_t k = 0; k < N; ++k) r = r - inverse[i][k] * jacobian[k][j];
      image[i] = image[i] - inverse[i][j] * values[j] + r * (z[j] - m[j]);
    }
  return image;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/determinant.h>

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Four points by barycentric coordinates in a tet of the input, up to positive factors.
template <class NT>
using TetCoordinates = std::array<std::array<NT, 4>, 4>;

template <class NT>
Certainty sign_of_determinant(const TetCoordinates<NT>& m) {
  const NT d =
      CGAL::determinant(m[0][0], m[0][1], m[0][2], m[0][3], m[1][0], m[1][1], m[1][2], m[1][3],
                        m[2][0], m[2][1], m[2][2], m[2][3], m[3][0], m[3][1], m[3][2], m[3][3]);
  return certainty(d, 0);
}

/// The signs of the barycentric coordinates of a point in a tet that is not flat: they are
/// quotients of determinants (Cramer's rule). Of exact numbers `Unknown` is zero.
template <class NT>
std::array<Certainty, 4> coordinate_signs(const TetCoordinates<NT>& tet,
                                          const std::array<NT, 4>& point) {
  const int whole = static_cast<int>(sign_of_determinant(tet));
  std::array<Certainty, 4> signs;
  for (std::size_t i = 0; i < 4; ++i) {
    TetCoordinates<NT> replaced = tet;
    replaced[i] = point;
    signs[i] = static_cast<Certainty>(whole * static_cast<int>(sign_of_determinant(replaced)));
  }
  return signs;
}

}  // namespace triplex

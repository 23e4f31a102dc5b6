// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// How the tensors of a field spread over the eigenvalue space. Every vertex counts with a quarter
/// of the volume of each tet around it; shares are of the whole volume, and what is between
/// vertices is not looked at.
struct SpaceDensity {
  int per_edge;  ///< bins along each edge of the hexagon
  int rows;      ///< bins along the isotropicity, from -1 to 1
  /// [row][edge][bin along the edge], counter-clockwise from the top corner as `special_modes`.
  std::vector<double> share;
  double on_axis = 0;  ///< triple degenerate tensors, multiples of the identity included
  double zero = 0;     ///< zero tensors: they have no place in the space
  /// By domain, as numbered in `Classification`; vertices on features are in none.
  std::array<double, 6> domains{};
  double on_features = 0;

  double at(int row, int edge, int bin) const {
    return share[static_cast<std::size_t>((row * 6 + edge) * per_edge + bin)];
  }
  /// Over all isotropicities.
  double at(int edge, int bin) const;
};

/// `share`, `on_axis` and `zero` add up to 1, and so do `domains` and `on_features`, but for
/// rounding. Which domain is exact; which bin is not, as `hexagon_approx` is not. \pre per_edge,
/// rows >= 1.
SpaceDensity space_density_approx(const TensorField& field, int per_edge, int rows);

}  // namespace triplex

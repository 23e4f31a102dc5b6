// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// A distance: in units of length, or as a part of the longest edge of the input's tet at hand.
struct Tolerance {
  double value = 0;
  bool relative = false;

  double at(double longest_edge) const { return relative ? value * longest_edge : value; }
};

/// Reads "1e-3" (a length) or "1e-3r" (relative to the tet); nothing unless positive and finite.
std::optional<Tolerance> parse_tolerance(std::string_view text);

/// Of a tet of the field, rounded.
double longest_edge_approx(const TensorField& input, TetId tet);

}  // namespace triplex

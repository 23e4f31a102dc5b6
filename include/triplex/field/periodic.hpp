// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Axes along which opposite sides of the domain are one: x, y, z.
using PeriodicAxes = std::array<bool, 3>;
constexpr bool any(const PeriodicAxes& axes) { return axes[0] || axes[1] || axes[2]; }

/// Two points of the input that are one: they differ in the coordinate of one axis only, the lowest
/// and the highest there is.
struct PeriodicPair {
  std::uint32_t low, high;
};

/// The pairs along each periodic axis (none along the others).
/// Guarantee: every used point of one side has exactly one partner on the other, with equal
/// tensors, and the triangles of the two sides correspond; no vertex has tets that reach both
/// sides, so that the identified mesh is a simplicial complex.
/// \throw BadInput naming the point or the side at fault. \pre the field passed `check_input`.
std::array<std::vector<PeriodicPair>, 3> find_periodic_pairs(const TensorField& field,
                                                             const PeriodicAxes& axes);

}  // namespace triplex

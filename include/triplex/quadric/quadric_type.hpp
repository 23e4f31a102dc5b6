// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include "triplex/quadric/inertia.hpp"

namespace triplex {

/// The real affine types of the zero set of a quadratic function in space.
enum class QuadricType : std::uint8_t {
  Empty,
  SinglePoint,
  SingleLine,
  SinglePlane,  ///< of a function that is linear
  DoublePlane,  ///< of the square of a linear function
  ParallelPlanes,
  CrossingPlanes,
  ParabolicCylinder,
  HyperbolicCylinder,
  EllipticCylinder,
  Cone,
  HyperbolicParaboloid,
  EllipticParaboloid,
  TwoSheetHyperboloid,
  OneSheetHyperboloid,
  Ellipsoid,
  Everything,
};
inline constexpr std::size_t kQuadricTypes = 17;

/// ellipsoid, one-sheet-hyperboloid and so on.
std::string_view name_of(QuadricType type);

/// The type from the inertia of the form in four homogeneous coordinates and that of its
/// restriction to the plane at infinity. Guarantee: exact; no eigenvalue is computed.
/// \pre they belong to one form. Source: proofs/quadric_type.md.
QuadricType quadric_type(const Inertia& form, const Inertia& at_infinity);

/// The type of the form of a tet.
QuadricType quadric_type(const SimplexForm<4>& form);
QuadricType quadric_type(const QuadraticForm<Exact, 4>& form);

}  // namespace triplex

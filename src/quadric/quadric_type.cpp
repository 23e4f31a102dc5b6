// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/quadric_type.hpp"

#include <array>

namespace triplex {
namespace {

QuadricType nonsingular(const Inertia& form, const Inertia& infinity) {
  if (form.definite()) return QuadricType::Empty;
  if (form.positive == 2)
    return infinity.rank() == 3 ? QuadricType::OneSheetHyperboloid
                                : QuadricType::HyperbolicParaboloid;
  if (infinity.rank() == 2) return QuadricType::EllipticParaboloid;
  return infinity.definite() ? QuadricType::Ellipsoid : QuadricType::TwoSheetHyperboloid;
}

// A cone over a conic: the apex is a point of space if the rank at infinity is 3.
QuadricType cone_or_cylinder(const Inertia& form, const Inertia& infinity) {
  const bool apex_in_space = infinity.rank() == 3;
  if (form.definite()) return apex_in_space ? QuadricType::SinglePoint : QuadricType::Empty;
  if (apex_in_space) return QuadricType::Cone;
  if (infinity.rank() == 1) return QuadricType::ParabolicCylinder;
  return infinity.definite() ? QuadricType::EllipticCylinder : QuadricType::HyperbolicCylinder;
}

// Two planes, real or conjugate: their line is in space if the rank at infinity is 2.
QuadricType two_planes(const Inertia& form, const Inertia& infinity) {
  const bool line_in_space = infinity.rank() == 2;
  if (form.definite()) return line_in_space ? QuadricType::SingleLine : QuadricType::Empty;
  if (line_in_space) return QuadricType::CrossingPlanes;
  return infinity.rank() == 1 ? QuadricType::ParallelPlanes : QuadricType::SinglePlane;
}

}  // namespace

std::string_view name_of(QuadricType type) {
  constexpr std::array<std::string_view, kQuadricTypes> kNames = {"empty",
                                                                  "point",
                                                                  "line",
                                                                  "single-plane",
                                                                  "double-plane",
                                                                  "parallel-planes",
                                                                  "crossing-planes",
                                                                  "parabolic-cylinder",
                                                                  "hyperbolic-cylinder",
                                                                  "elliptic-cylinder",
                                                                  "cone",
                                                                  "hyperbolic-paraboloid",
                                                                  "elliptic-paraboloid",
                                                                  "two-sheet-hyperboloid",
                                                                  "one-sheet-hyperboloid",
                                                                  "ellipsoid",
                                                                  "everything"};
  return kNames[static_cast<std::size_t>(type)];
}

QuadricType quadric_type(const Inertia& form, const Inertia& at_infinity) {
  switch (form.rank()) {
    case 4:
      return nonsingular(form, at_infinity);
    case 3:
      return cone_or_cylinder(form, at_infinity);
    case 2:
      return two_planes(form, at_infinity);
    case 1:
      return at_infinity.rank() == 1 ? QuadricType::DoublePlane : QuadricType::Empty;
    default:
      return QuadricType::Everything;
  }
}

QuadricType quadric_type(const SimplexForm<4>& form) {
  if (form.surface().kind == QuadricSurface::Kind::Traceless) {
    // (tr T)(sum x): a plane if the trace differs at two vertices, else one sign or none
    for (int v = 1; v < 4; ++v)
      if (form.sign_of([&](const auto& f) { return f(v, v) - f(0, 0); }) != Sign::Zero)
        return QuadricType::SinglePlane;
    return form.sign_of([](const auto& f) { return f(0, 0); }) == Sign::Zero
               ? QuadricType::Everything
               : QuadricType::Empty;
  }
  const auto whole = form.decide([](const auto& f) { return inertia(f); });
  const auto infinite = form.decide([](const auto& f) { return inertia(at_infinity(f)); });
  return quadric_type(whole, infinite);
}

QuadricType quadric_type(const QuadraticForm<Exact, 4>& form) {
  return quadric_type(*inertia(form), *inertia(at_infinity(form)));
}

}  // namespace triplex

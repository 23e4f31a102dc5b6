// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "triplex/arithmetic/filter.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// The least and the largest value of something, with certainty.
struct Bounds {
  double low = 0, high = 0;
  double largest() const { return std::fmax(std::fabs(low), std::fabs(high)); }
};

/// The function f of tensors whose zero set is the surface of a feature, with bounds on convex
/// hulls of tensors; a linear field takes hulls of points to hulls of tensors.
///
///   balanced P;  neutral Q;  curved sheet, seen through its map, G = Q - s 12 v^3 with
///   v = sqrt(max(0,-P)/6)  (P and Q: bernstein/forms.hpp, of the tripled deviator)
///   magnitude |T|^2 - s^2;  isotropicity 3 eta^2 |T|^2 - tr(T)^2;  traceless -tr(T)
///
/// Bounds are computed in doubles and widened by derived errors. Source: proofs/mesh_accuracy.md.
class SurfaceFunction {
 public:
  /// `scale`: log2 of the factor that all tensors were multiplied by.
  SurfaceFunction(const FeatureTable& table, Feature feature, int scale);

  /// Whether f takes T itself; else it takes the tripled deviator.
  bool takes_trace() const { return kind_ >= Kind::Magnitude; }
  /// The sign of f on the side to which the triangles' normals point.
  double orientation() const { return orientation_; }

  double value(const Tensor<double>& a) const;
  /// The derivative at a in the direction of `along`.
  double derivative(const Tensor<double>& a, const Tensor<double>& along) const;

  /// A bound on |f| on the hull of N tensors known within `bounds`. Of second order in their
  /// distances where f vanishes at all of them. N = 1, 2, 3.
  template <int N>
  double largest_value(const std::array<Tensor<double>, N>& hull, const EntryBounds& bounds) const;

  /// Vectors whose hull holds, up to rounding, the derivatives along three directions (two: the
  /// third is zero) at all points of the hull: a witness comes from them.
  std::vector<std::array<double, 3>> derivatives_approx(
      std::span<const Tensor<double>> hull, std::span<const Tensor<double>> directions) const;

  /// Bounds on the derivative along a direction on the hull of some tensors; `bounds` hold for them
  /// and for the direction.
  Bounds derivative_on(std::span<const Tensor<double>> hull, const Tensor<double>& along,
                       const EntryBounds& bounds) const;

 private:
  enum class Kind : std::uint8_t { Balanced, Neutral, Curved, Magnitude, Isotropicity, Traceless };

  double height(double P) const;  // h: f = Q - h(P) on a curved sheet
  template <int N>
  double largest_curved(const Forms<double, N>& f, const FormBounds& bounds) const;
  double gram_coefficient(const Tensor<double>& a, const Tensor<double>& b) const;
  Bounds curved_derivative_on(std::span<const Tensor<double>> hull, const Tensor<double>& along,
                              const FormBounds& bounds) const;

  Kind kind_ = Kind::Balanced;
  double orientation_ = 1;
  double side_ = 1;                     // s of a curved sheet
  double p_factor_ = 1, q_factor_ = 1;  // of its map
  double square_ = 0, eta_ = 0;         // s^2; 3 eta^2
};

}  // namespace triplex

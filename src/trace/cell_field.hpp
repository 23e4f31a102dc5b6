// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "eigenvector_branch.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// The linear field of one tet, in doubles, and its barycentric coordinates: everything that
/// tracing needs to know of it.
class CellField {
 public:
  CellField(const TensorField& field, TetId tet);

  TetId tet() const { return tet_; }
  double size() const { return size_; }  ///< longest edge
  /// A few roundings of the tet's coordinates: no position is known better.
  double position_rounding() const { return position_rounding_; }
  /// Barycentric coordinates closer to 0 than this count as 0: rounding of the position.
  double rounding() const { return rounding_; }
  std::array<double, 4> barycentric(const Point& x) const;
  /// How fast coordinate i grows along a direction.
  double slope(int i, const Vector& direction) const { return dot(gradients_[i], direction); }
  /// The slope as a cosine: over the length of the gradient.
  double entry(int i, const Vector& direction) const { return slope(i, direction) * heights_[i]; }
  Tensor<double> tensor(const Point& x) const;
  /// `tensor`, times a power of two that makes the tet's entries about one.
  Tensor<double> scaled_tensor(const Point& x) const;

  /// How fast `scaled_tensor` grows along a direction.
  Tensor<double> scaled_growth(const Vector& direction) const;

 private:
  TetId tet_;
  Point origin_{};
  std::array<Vector, 4> gradients_{};
  std::array<double, 4> heights_{};
  std::array<Tensor<double>, 4> tensors_{}, scaled_{};
  double size_ = 0, rounding_ = 0, position_rounding_ = 0;
};

}  // namespace triplex::detail

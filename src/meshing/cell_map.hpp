// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "triplex/arithmetic/filter.hpp"
#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

using Vector = Eigen::Vector3d;

/// Barycentric coordinates in a cell, in the order of its vertices; they sum to one up to rounding.
/// Those of a direction sum to zero.
using Weights = std::array<double, 4>;

inline Weights operator+(const Weights& a, const Weights& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
}
inline Weights operator*(double s, const Weights& a) {
  return {s * a[0], s * a[1], s * a[2], s * a[3]};
}
/// The same point with weights that add up to one but for three roundings: the largest gives way.
inline Weights corrected(Weights w) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (std::fabs(w[i]) > std::fabs(w[largest])) largest = i;
  w[largest] = 0;
  w[largest] = 1 - ((w[0] + w[1]) + (w[2] + w[3]));
  return w;
}
/// The point of the segment from a to b at t.
inline Weights between(const Weights& a, const Weights& b, double t) { return (1 - t) * a + t * b; }

/// One tet of the refined mesh in doubles: its corners and the tensors there, with bounds on what
/// rounding does to points and tensors made of them with weights of at most kMostWeight in all.
/// Source: proofs/mesh_accuracy.md.
class CellMap {
 public:
  /// `with_trace`: of T itself; else of the tripled deviator.
  CellMap(const RefinableField& field, const std::array<VertexId, 4>& cell, bool with_trace);

  static constexpr double kMostWeight = 2;
  static double total(const Weights& w) {
    return std::fabs(w[0]) + std::fabs(w[1]) + std::fabs(w[2]) + std::fabs(w[3]);
  }

  const std::array<VertexId, 4>& vertices() const { return vertices_; }
  const Vector& corner(std::size_t i) const { return corners_[i]; }
  /// The longest edge.
  double size() const { return size_; }
  /// From the first corner that counts, so that a coordinate which all of them share is kept.
  Vector position(const Weights& w) const;
  /// From corner 0; of a direction, the vector.
  Vector offset(const Weights& w) const {
    return w[1] * edges_[0] + w[2] * edges_[1] + w[3] * edges_[2];
  }
  Tensor<double> tensor(const Weights& w) const;
  /// Of the tensors that `tensor` returns.
  const EntryBounds& bounds() const { return bounds_; }
  /// Whether bounds on forms of these tensors hold: entries are neither too small nor too
  /// uncertain.
  bool is_usable() const { return is_usable_; }
  /// How far `position` may be from the point with these weights, corrected so that they sum to
  /// one.
  double position_error() const { return position_error_; }

  /// The direction with this vector; nothing if the cell is too flat to tell.
  std::optional<Weights> direction(const Vector& vector) const;
  /// The same for a vector in the plane of the face that lacks a corner, whose weight is zero.
  std::optional<Weights> direction_in_face(std::size_t lacking, const Vector& vector) const;
  /// The gradient of a function with these derivatives along the edges from corner 0.
  std::optional<Vector> gradient(const Vector& along_edges) const;
  /// At most the least distance of a corner from the opposite face; 0 if the cell is too flat.
  double least_height() const { return least_height_; }
  Weights edge_direction(std::size_t i) const {
    Weights w{-1, 0, 0, 0};
    w[i] = 1;
    return w;
  }

 private:
  void invert_edges();

  std::array<VertexId, 4> vertices_;
  std::array<Vector, 4> corners_;
  std::array<Vector, 3> edges_;    // from corner 0
  std::array<Vector, 3> inverse_;  // rows: the gradients of weights 1, 2, 3
  bool invertible_ = false, is_usable_ = false;
  std::array<Tensor<double>, 4> tensors_;
  EntryBounds bounds_;
  double size_ = 0, position_error_ = 0, least_height_ = 0;
};

}  // namespace triplex

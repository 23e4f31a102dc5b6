// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace triplex {

CellMap::CellMap(const RefinableField& field, const std::array<VertexId, 4>& cell, bool with_trace)
    : vertices_(cell) {
  double farthest = 0;  // coordinate
  EntryBounds corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point x = field.position(cell[i]);
    corners_[i] = Vector(x[0], x[1], x[2]);
    farthest = std::max(farthest, corners_[i].cwiseAbs().maxCoeff());
    const ApproximateTensor t =
        with_trace ? field.approximate_tensor(cell[i]) : field.approximate(cell[i]);
    tensors_[i] = t.a;
    corners.include(t.bounds);
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      size_ = std::max(size_, (corners_[i] - corners_[j]).norm());
  for (std::size_t i = 0; i < 3; ++i) edges_[i] = corners_[i + 1] - corners_[0];

  // A sum of four products, weights of at most 2 in all: four roundings of terms of at most 2 M in
  // all, twice the error of the corners, and what the sum of the weights lacks of one: at most
  // 2^-50 (the weights come from a handful of operations), times the largest entry.
  constexpr double kLackOfWeight = 0x1p-50;
  is_usable_ = corners.usable();
  bounds_.magnitude = kMostWeight * corners.magnitude * (1 + 0x1p-20);
  bounds_.error =
      (kMostWeight * corners.error + (kMostWeight * gamma(4) + kLackOfWeight) * corners.magnitude) *
      (1 + 0x1p-20);
  // Corners are rounded once or twice, edges once more, each of the three products and sums as
  // well; per coordinate that is relative to the farthest one and to the edges, which are at most
  // twice that long: 2 + 2 * 2 * 6 roundings; the weights' lack of one; and corners known by
  // enclosures.
  double radius = 0;
  for (const VertexId v : cell) radius = std::max(radius, field.position_radius(v));
  position_error_ = kMostWeight * radius +
                    std::sqrt(3.0) * farthest * (gamma(26) + 2 * kLackOfWeight) * (1 + 0x1p-20);
  invert_edges();
}

/// The computed inverse M of the edges' matrix E is trusted if |I - M E| is small: then the true
/// inverse is within a factor of 1 + 2^-19 of M.
void CellMap::invert_edges() {
  const double volume = edges_[0].dot(edges_[1].cross(edges_[2]));
  if (volume == 0 || !std::isfinite(1 / volume)) return;
  inverse_[0] = edges_[1].cross(edges_[2]) / volume;
  inverse_[1] = edges_[2].cross(edges_[0]) / volume;
  inverse_[2] = edges_[0].cross(edges_[1]) / volume;
  double defect = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      defect = std::max(defect, std::fabs(inverse_[i].dot(edges_[j]) - (i == j ? 1 : 0)));
  invertible_ = defect < 0x1p-24;
  if (!invertible_) return;
  const Vector of_first = -(inverse_[0] + inverse_[1] + inverse_[2]);
  double steepest = of_first.norm();
  for (const Vector& row : inverse_) steepest = std::max(steepest, row.norm());
  least_height_ = std::max(0.0, (1 - 0x1p-18) / steepest - 4 * position_error_);
}

Tensor<double> CellMap::tensor(const Weights& w) const {
  Tensor<double> a;
  for (std::size_t k = 0; k < 9; ++k)
    a[k] = (w[0] * tensors_[0][k] + w[1] * tensors_[1][k]) +
           (w[2] * tensors_[2][k] + w[3] * tensors_[3][k]);
  return a;
}

Vector CellMap::position(const Weights& w) const {
  std::size_t base = 0;
  while (base < 3 && w[base] == 0) ++base;
  Vector x = corners_[base];
  for (std::size_t i = base + 1; i < 4; ++i)
    if (w[i] != 0) x += w[i] * (corners_[i] - corners_[base]);
  return x;
}

namespace {

constexpr double kDirectionError = 0x1p-24;

}  // namespace

std::optional<Weights> CellMap::direction(const Vector& vector) const {
  if (!invertible_) return std::nullopt;
  Weights w{0, inverse_[0].dot(vector), inverse_[1].dot(vector), inverse_[2].dot(vector)};
  w[0] = -(w[1] + w[2] + w[3]);
  if (!((offset(w) - vector).norm() <= kDirectionError * vector.norm())) return std::nullopt;
  return w;
}

std::optional<Weights> CellMap::direction_in_face(std::size_t lacking, const Vector& vector) const {
  auto w = direction(vector);
  if (!w) return std::nullopt;
  std::size_t other = lacking == 0 ? 1 : 0;
  (*w)[other] += (*w)[lacking];
  (*w)[lacking] = 0;
  if (!((offset(*w) - vector).norm() <= kDirectionError * vector.norm())) return std::nullopt;
  return w;
}

std::optional<Vector> CellMap::gradient(const Vector& d) const {
  if (!invertible_) return std::nullopt;
  return d[0] * inverse_[0] + d[1] * inverse_[1] + d[2] * inverse_[2];
}

}  // namespace triplex

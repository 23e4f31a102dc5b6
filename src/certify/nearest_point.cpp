// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nearest_point.hpp"

#include <Eigen/Dense>

#include "triplex/bernstein/forms.hpp"

namespace triplex {

Tensor<double> nearest_to_origin(std::span<const Tensor<double>> tensors) {
  constexpr int kMost = 4;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;
  const int n = static_cast<int>(tensors.size());
  Matrix gram(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) gram(i, j) = double_dot(tensors[i], tensors[j]);

  // Of the subsets with weights >= 0, the point with the smallest norm.
  Vector best = Vector::Zero(n);
  double best_square = HUGE_VAL;
  for (unsigned subset = 1; subset < 1u << n; ++subset) {
    std::array<int, kMost> member{};
    int count = 0;
    for (int i = 0; i < n; ++i)
      if (subset >> i & 1u) member[count++] = i;
    Matrix part(count, count);
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < count; ++j) part(i, j) = gram(member[i], member[j]);
    Vector weights = part.ldlt().solve(Vector::Ones(count));
    const double sum = weights.sum();
    if (!(sum > 0) || !(weights.minCoeff() >= 0)) continue;
    weights /= sum;
    const double square = weights.dot(part * weights);
    if (!(square < best_square)) continue;
    best_square = square;
    best.setZero();
    for (int i = 0; i < count; ++i) best[member[i]] = weights[i];
  }

  Tensor<double> point{};
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < 9; ++k) point[k] += best[i] * tensors[i][k];
  return point;
}

}  // namespace triplex

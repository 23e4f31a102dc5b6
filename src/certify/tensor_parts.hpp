// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/simplex.hpp"

/// Simplices of tensors as intervals, which a test may halve where the mesh need not be bisected.
namespace triplex {

template <int N>
using TensorCell = std::array<Tensor<Interval>, N>;

/// The tensors of the vertices. \pre inside an `IntervalRounding`.
template <int N>
TensorCell<N> tensor_cell(const Simplex<N>& simplex) {
  TensorCell<N> cell;
  for (int i = 0; i < N; ++i) {
    const ApproximateTensor& v = simplex.field().approximate(simplex.vertices()[i]);
    const Interval error(-v.bounds.error, v.bounds.error);
    for (int k = 0; k < 9; ++k) cell[i][k] = Interval(v.a[k]) + error;
  }
  return cell;
}

/// The rate of change along the direction with these weights of the differences v_k - v_0.
template <int N, class Direction>
Tensor<Interval> change_along(const TensorCell<N>& cell, const Direction& direction) {
  Tensor<Interval> change;
  for (std::size_t i = 0; i < 9; ++i) {
    change[i] = Interval(0);
    for (int k = 1; k < N; ++k) change[i] += Interval(direction[k - 1]) * (cell[k][i] - cell[0][i]);
  }
  return change;
}

inline double middle(const Interval& x) { return x.inf() + (x.sup() - x.inf()) / 2; }

inline Eigen::Matrix3d middle(const Tensor<Interval>& t) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = middle(t[static_cast<std::size_t>(i)]);
  return m;
}
template <int N>
Eigen::Matrix3d centre_of(const TensorCell<N>& cell) {
  Eigen::Matrix3d centre = Eigen::Matrix3d::Zero();
  for (const auto& tensor : cell) centre += middle(tensor) / N;
  return centre;
}

/// D > 0 throughout, by its Bernstein coefficients.
template <int N>
bool is_real(const TensorCell<N>& cell) {
  const auto minus_d = minus_discriminant(forms_of<Interval, N>(cell));
  return std::ranges::all_of(minus_d, [](const Interval& d) { return d.sup() < 0; });
}
/// D > 0, of a deviator; a guess.
inline bool is_real_approx(const Eigen::Matrix3d& a) {
  const double p = -(a * a).trace() / 2, q = a.determinant();
  return -4 * p * p * p - 27 * q * q > 0;
}

/// The edge along which `length(a, b)` is largest; the first of equals.
template <int N, class Length>
std::array<int, 2> longest_edge(const Length& length) {
  std::array<int, 2> edge{0, 1};
  double longest = -1;
  for (int a = 0; a < N; ++a)
    for (int b = a + 1; b < N; ++b)
      if (const double l = length(a, b); l > longest) longest = l, edge = {a, b};
  return edge;
}
template <int N>
std::array<int, 2> longest_edge(const TensorCell<N>& cell) {
  return longest_edge<N>([&](int a, int b) {
    double sum = 0;
    for (int i = 0; i < 9; ++i) {
      const double x = middle(cell[a][i]) - middle(cell[b][i]);
      sum += x * x;
    }
    return sum;
  });
}

/// The two halves of a cell, cut in the middle of an edge.
template <int N>
std::array<TensorCell<N>, 2> halves(const TensorCell<N>& cell, const std::array<int, 2>& edge) {
  const auto [a, b] = edge;
  std::array<TensorCell<N>, 2> parts = {cell, cell};
  for (int i = 0; i < 9; ++i)
    parts[0][a][i] = parts[1][b][i] = (cell[a][i] + cell[b][i]) * Interval(0.5);
  return parts;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_exclusion.hpp"

#include <algorithm>
#include <cmath>

#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

/// Degree two in the barycentric coordinates, degree two in l.
constexpr int kCoefficients = kPairs<4> * 3;
using Coefficients = std::array<Tensor<double>, kCoefficients>;

/// Twice the Bernstein coefficients of cof(A - l I) = cof(A) + l A^T + l^2 I (A has no trace):
/// with l_a, l_b in {lo, hi}, mixed cofactor of A_i and A_j, plus (l_a + l_b)/2 (A_i + A_j)^T, plus
/// 2 l_a l_b I.
Coefficients coefficients_of(const NodeCell& cell, const Range& l) {
  const std::array<double, 3> linear = {l.lo, (l.lo + l.hi) / 2, l.hi};
  const std::array<double, 3> square = {2 * l.lo * l.lo, 2 * l.lo * l.hi, 2 * l.hi * l.hi};
  Coefficients c;
  for (std::size_t n = 0; n < static_cast<std::size_t>(kPairs<4>); ++n) {
    const auto [i, j] = pairs<4>()[n];
    const Tensor<double>& a = cell.tensors[static_cast<std::size_t>(i)];
    const Tensor<double>& b = cell.tensors[static_cast<std::size_t>(j)];
    const Tensor<double> m = mixed_cofactor(a, b);
    for (std::size_t e = 0; e < 3; ++e) {
      Tensor<double>& r = c[3 * n + e];
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
          const std::size_t k = 3 * row + column, t = 3 * column + row;
          r[k] = m[k] + linear[e] * (a[t] + b[t]);
        }
      for (const std::size_t k : {0u, 4u, 8u}) r[k] += square[e];
    }
  }
  return c;
}

/// With entries |a| <= M of error e and |l| <= L: the mixed cofactor is 4 products, 3 roundings
/// each, and moves by 4 ((M + e)^2 - M^2) <= 9 M e; the middle term is at most 2 L M, 3 roundings,
/// and moves by 2 L e; the last is at most 2 L^2, 2 roundings; 2 more add them up. A product with c
/// takes 9 more and adds up 9 of them: together
///   |c|_1 (gamma(5) S + (9 M + 2 L) e + gamma(10) (S + error)),  S = 4 M^2 + 2 L M + 2 L^2.
double error_of_product(const NodeCell& cell, const Range& l) {
  const double m = cell.bounds.magnitude, e = cell.bounds.error;
  const double largest = std::max(std::fabs(l.lo), std::fabs(l.hi));
  const double s = 4 * m * m + 2 * largest * m + 2 * largest * largest;
  return (gamma(16) * s + (9 * m + 2 * largest) * e) * (1 + 0x1p-20);
}

double norm_1(const Tensor<double>& c) {
  double sum = 0;
  for (const double x : c) sum += std::fabs(x);
  return sum * (1 + 0x1p-20);
}

}  // namespace

std::optional<Range> eigenvalue_range(const NodeCell& cell, Sign sign) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const auto& [i, j] : pairs<4>()) {
    const double p = minus_trace_of_product(cell.tensors[static_cast<std::size_t>(i)],
                                            cell.tensors[static_cast<std::size_t>(j)]);
    least = std::min(least, p);
    most = std::max(most, p);
  }
  const double error = FormBounds(cell.bounds).p_error;
  if (least > error) return std::nullopt;
  // Few roundings each, of numbers of one sign.
  const double low = std::sqrt(std::max(0.0, -(most + error)) / 6) * (1 - 0x1p-48);
  const double high = std::sqrt((error - least) / 6) * (1 + 0x1p-48);
  return sign == Sign::Positive ? Range{low, high} : Range{-high, -low};
}

bool excludes_node(const NodeCell& cell, const Range& eigenvalue) {
  const Coefficients c = coefficients_of(cell, eigenvalue);
  const double error = error_of_product(cell, eigenvalue);
  // The witness: towards the point of the hull nearest to the origin, by Gilbert's steps.
  constexpr int kSteps = 24;
  Tensor<double> z{};
  for (const auto& g : c)
    for (std::size_t k = 0; k < 9; ++k) z[k] += g[k] / kCoefficients;
  for (int step = 0; step < kSteps; ++step) {
    double value = HUGE_VAL;
    const Tensor<double>* nearest = nullptr;
    for (const auto& g : c) {
      const double d = double_dot(z, g);
      if (d < value) {
        value = d;
        nearest = &g;
      }
    }
    if (value > error * norm_1(z)) return true;
    if (nearest == nullptr) return false;
    Tensor<double> step_to;
    for (std::size_t k = 0; k < 9; ++k) step_to[k] = (*nearest)[k] - z[k];
    const double length = double_dot(step_to, step_to);
    const double t = -double_dot(z, step_to) / length;
    if (!(t > 0)) return false;
    for (std::size_t k = 0; k < 9; ++k) z[k] += std::min(t, 1.0) * step_to[k];
  }
  return false;
}

}  // namespace triplex

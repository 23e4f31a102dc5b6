// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/witness.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace triplex {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The corners of the hull's face that currently carries the nearest point: at most four.
struct Corral {
  std::array<Vector, 4> points;
  std::array<double, 4> weights{};
  int size = 0;
};

/// Nearest point to the origin of the affine hull of the chosen corners, if its weights are positive.
bool nearest_in_affine_hull(const Corral& corral, unsigned subset, std::array<double, 4>& weights) {
  std::array<int, 4> chosen{};
  int n = 0;
  for (int i = 0; i < corral.size; ++i)
    if (subset >> i & 1u) chosen[n++] = i;
  // Minimise |sum w_i g_i|^2 with sum w_i = 1: Gram system bordered by ones.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5> system(n + 1, n + 1);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1> rhs(n + 1);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j)
      system(i, j) = dot(corral.points[chosen[i]], corral.points[chosen[j]]);
    system(i, n) = system(n, i) = 1;
    rhs(i) = 0;
  }
  system(n, n) = 0;
  rhs(n) = 1;
  const auto lu = system.fullPivLu();
  if (!lu.isInvertible()) return false;
  const auto solution = lu.solve(rhs).eval();
  weights = {};
  for (int i = 0; i < n; ++i) {
    if (!(solution(i) >= 0)) return false;
    weights[chosen[i]] = solution(i);
  }
  return true;
}

/// Shrinks the corral to the face nearest to the origin and returns the nearest point.
Vector nearest_point(Corral& corral) {
  double best = std::numeric_limits<double>::infinity();
  std::array<double, 4> best_weights{};
  Vector nearest{};
  for (unsigned subset = 1; subset < 1u << corral.size; ++subset) {
    std::array<double, 4> weights;
    if (!nearest_in_affine_hull(corral, subset, weights)) continue;
    Vector z{};
    for (int i = 0; i < corral.size; ++i)
      for (int k = 0; k < 3; ++k) z[k] += weights[i] * corral.points[i][k];
    const double norm = dot(z, z);
    if (norm < best) {
      best = norm;
      best_weights = weights;
      nearest = z;
    }
  }
  Corral kept;
  for (int i = 0; i < corral.size; ++i) {
    if (best_weights[i] <= 0) continue;
    kept.points[kept.size] = corral.points[i];
    kept.weights[kept.size++] = best_weights[i];
  }
  corral = kept;
  return nearest;
}

Vector rounded(const Vector& v, double scale) {
  return {few_bits(v[0] * scale), few_bits(v[1] * scale),
          few_bits(v[2] * scale)};
}

/// Direction with largest component one; a zero vector stays zero.
Vector normalised(const Vector& v) {
  const double m = std::fmax(std::fabs(v[0]), std::fmax(std::fabs(v[1]), std::fabs(v[2])));
  return m > 0 && std::isfinite(1 / m) ? rounded(v, 1 / m) : Vector{};
}

}  // namespace

Vector separating_direction(std::span<const Vector> vectors) {
  double scale = 0;
  Vector mean{};
  for (const Vector& g : vectors) {
    for (int k = 0; k < 3; ++k) {
      mean[k] += g[k];
      scale = std::fmax(scale, std::fabs(g[k]));
    }
  }
  if (!(scale > 0) || !std::isfinite(1 / scale)) return {};

  // The mean serves nearly always; otherwise it is where the search starts.
  const auto support = [&](const Vector& z) {
    std::size_t least = 0;
    double value = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      const double d = dot(vectors[i], z);
      if (d < value) {
        value = d;
        least = i;
      }
    }
    return std::pair(least, value);
  };
  // Clear of zero by 2^-10 of the vectors' size: enough room for any later rung of the ladder.
  const Vector first = normalised(mean);
  auto [least, value] = support(first);
  if (value > 0x1p-10 * scale) return first;

  constexpr int kSteps = 24;             // a quality limit only: the result is tested by the caller
  constexpr double kImprovement = 1e-6;  // relative gain below which the hull is reached
  Corral corral;
  Vector z{};
  for (int step = 0; step < kSteps; ++step) {
    if (corral.size == 4) break;  // four corners hold the origin
    Vector corner;
    for (int k = 0; k < 3; ++k) corner[k] = vectors[least][k] / scale;
    corral.points[corral.size++] = corner;
    z = nearest_point(corral);
    const double norm = dot(z, z);
    if (norm < 1e-24) return {};
    std::tie(least, value) = support(z);
    if (value / scale >= norm * (1 - kImprovement)) break;
  }
  return normalised(z);
}

}  // namespace triplex

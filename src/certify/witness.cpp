// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/witness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace triplex {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector combine(const Vector& g, double s, const Vector& e) {
  return {g[0] + s * e[0], g[1] + s * e[1], g[2] + s * e[2]};
}
Vector difference(const Vector& a, const Vector& b) { return combine(a, -1, b); }

/// The corners of the hull's face that carries the nearest point found so far: at most three, and
/// room for the next.
struct Corral {
  std::array<Vector, 4> points;
  int size = 0;
};

/// Keeps the face of the corral nearest to the origin among those with the newest corner (the
/// others were nearest before it came) and returns the nearest point. Faces whose nearest point is
/// not inside are left to their own faces.
Vector shrink_to_nearest(Corral& corral) {
  const Vector g = corral.points[corral.size - 1];
  Vector nearest = g;
  std::array<int, 2> others = {-1, -1};
  const auto consider = [&](const Vector& z, int i, int j) {
    if (!(dot(z, z) < dot(nearest, nearest))) return;
    nearest = z;
    others = {i, j};
  };
  for (int i = 0; i < corral.size - 1; ++i) {
    const Vector e = difference(corral.points[i], g);
    const double ee = dot(e, e), t = -dot(g, e) / ee;
    if (t > 0 && t < 1) consider(combine(g, t, e), i, -1);
    for (int j = i + 1; j < corral.size - 1; ++j) {
      const Vector f = difference(corral.points[j], g);
      const double ff = dot(f, f), ef = dot(e, f), ge = -dot(g, e), gf = -dot(g, f);
      const double determinant = ee * ff - ef * ef;
      const double s = (ge * ff - gf * ef) / determinant, u = (gf * ee - ge * ef) / determinant;
      if (s > 0 && u > 0 && s + u < 1) consider(combine(combine(g, s, e), u, f), i, j);
    }
  }
  Corral kept;
  for (const int i : others)
    if (i >= 0) kept.points[kept.size++] = corral.points[i];
  kept.points[kept.size++] = g;
  corral = kept;
  return nearest;
}

Vector rounded(const Vector& v, double scale) {
  return {few_bits(v[0] * scale), few_bits(v[1] * scale), few_bits(v[2] * scale)};
}

/// Direction with largest component one; a zero vector stays zero.
Vector normalised(const Vector& v) {
  const double m = std::max(std::fabs(v[0]), std::max(std::fabs(v[1]), std::fabs(v[2])));
  return m > 0 && std::isfinite(1 / m) ? rounded(v, 1 / m) : Vector{};
}

}  // namespace

Vector separating_direction(std::span<const Vector> vectors) {
  double scale = 0;
  Vector mean{};
  for (const Vector& g : vectors) {
    for (int k = 0; k < 3; ++k) {
      mean[k] += g[k];
      scale = std::max(scale, std::fabs(g[k]));
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
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < kSteps; ++step) {
    Vector corner;
    for (int k = 0; k < 3; ++k) corner[k] = vectors[least][k] / scale;
    corral.points[corral.size++] = corner;
    z = shrink_to_nearest(corral);
    const double norm = dot(z, z);
    // At the origin, or no nearer than before: the hull holds the origin, as far as doubles can
    // tell.
    if (norm < 1e-24 || norm >= last) return {};
    last = norm;
    std::tie(least, value) = support(z);
    if (value / scale >= norm * (1 - kImprovement)) break;
  }
  return normalised(z);
}

}  // namespace triplex

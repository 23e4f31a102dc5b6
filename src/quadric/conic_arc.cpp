// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "conic_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "triplex/quadric/adjugate.hpp"

namespace triplex::detail {
namespace {

/// The gradient of F / 2, as far as it is a displacement in the face.
FacePoint half_gradient(const QuadraticForm<double, 3>& f, const FacePoint& x) {
  FacePoint g{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) g[i] += f(i, j) * x[j];
  const double mean = (g[0] + g[1] + g[2]) / 3;
  for (double& gi : g) gi -= mean;
  return g;
}

double squared_length(const FacePoint& x) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; }

/// Whether the arc leaves its chord by next to nothing: at the middle m, where F = B(a,b) / 2, by
/// |B(a,b)| / (4 |g|) to first order, g half the gradient there.
bool is_straight(const QuadraticForm<double, 3>& f, const FacePoint& a, const FacePoint& b) {
  constexpr double kStraight = 0x1p-20;  // of the chord; the ends are known to 2^-30 at worst
  const FacePoint m = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  const FacePoint chord = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const double reach = squared_length(half_gradient(f, m)) * squared_length(chord);
  return std::fabs(bilinear(f, a, b)) < 4 * kStraight * std::sqrt(reach);
}

/// w times the pole of the chord, so that (1-t)^2 a + 2 t (1-t) w c + t^2 b is on the conic: with
/// c = adj(F) (a x b), F(c) = -det(F) B(a,b)^2, so w^2 = 1 / (2 det(F) B(a,b)). Zero where the arc
/// is as straight as its chord but for rounding: both factors are noise there.
FacePoint control_point(const QuadraticForm<double, 3>& f, const FacePoint& a, const FacePoint& b) {
  if (is_straight(f, a, b)) return {0, 0, 0};
  const auto adj = adjugate(f);
  const double d = 2 * determinant(f, adj) * bilinear(f, a, b);
  if (!(d > 0)) return {0, 0, 0};
  const FacePoint n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0]};
  FacePoint c{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) c[i] += adj(i, j) * n[j];
    c[i] /= std::sqrt(d);
  }
  // Coordinate k of the arc is nowhere negative if w c_k >= -sqrt(a_k b_k).
  const auto margin = [&](double sign) {
    double least = 1e300;
    for (int k = 0; k < 3; ++k) least = std::fmin(least, sign * c[k] + std::sqrt(a[k] * b[k]));
    return least;
  };
  if (margin(-1) > margin(1))
    for (double& x : c) x = -x;
  return c;
}

/// One step towards the conic along its gradient in the face.
void polish(const QuadraticForm<double, 3>& f, FacePoint& x) {
  const FacePoint g = half_gradient(f, x);
  const double square = squared_length(g);
  if (!(square > 0)) return;
  const double value = bilinear(f, x, x);
  for (int i = 0; i < 3; ++i) x[i] -= value / (2 * square) * g[i];
}

bool inside(const FacePoint& x) {
  return std::ranges::all_of(x, [](double c) { return c > 0; });
}

}  // namespace

std::vector<FacePoint> sample_arc_approx(const QuadraticForm<double, 3>& form,
                                         const FacePoint& from, const FacePoint& to, int n) {
  const FacePoint c = control_point(form, from, to);
  std::vector<FacePoint> points;
  for (int k = 1; k < n; ++k) {
    const double t = static_cast<double>(k) / n, s = 1 - t;
    FacePoint x{}, chord{};
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      x[i] = s * s * from[i] + 2 * s * t * c[i] + t * t * to[i];
      chord[i] = s * from[i] + t * to[i];
      sum += x[i];
    }
    for (double& xi : x) xi /= sum;
    for (int step = 0; step < 2; ++step) polish(form, x);
    points.push_back(inside(x) ? x : chord);
  }
  return points;
}

std::vector<FacePoint> sample_oval_approx(const QuadraticForm<double, 3>& form, int n) {
  FacePoint c = center(adjugate(form));
  const double sum = c[0] + c[1] + c[2];
  for (double& x : c) x /= sum;
  // c + u (e0 - e2) + v (e1 - e2) with u = (r cos - s l sin) / ..., from G = L L^T
  auto g = at_infinity(form);
  const double scale = -bilinear(form, c, c);
  for (double& x : g.entries) x /= scale;
  const double l00 = std::sqrt(std::fmax(g(0, 0), 0)), l10 = g(0, 1) / l00;
  const double l11 = std::sqrt(std::fmax(g(1, 1) - l10 * l10, 0));
  std::vector<FacePoint> points;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * k / n;
    const double v = std::sin(angle) / l11, u = (std::cos(angle) - l10 * v) / l00;
    FacePoint x = {c[0] + u, c[1] + v, c[2] - u - v};
    polish(form, x);
    points.push_back(inside(x) ? x : c);
  }
  return points;
}

}  // namespace triplex::detail

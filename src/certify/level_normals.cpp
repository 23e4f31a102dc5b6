// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_normals.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "nearest_point.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/certify/witness.hpp"

namespace triplex {
namespace {

double trace(const Tensor<double>& t) { return t[0] + t[4] + t[8]; }
double norm(const Tensor<double>& t) { return std::sqrt(double_dot(t, t)); }

Tensor<double> few_bits(Tensor<double> t) {
  double largest = 0;
  for (const double x : t) largest = std::fmax(largest, std::fabs(x));
  if (!(largest > 0) || !std::isfinite(largest)) return {};
  const double unit = std::ldexp(1.0, -std::ilogb(largest));
  for (double& x : t) x = triplex::few_bits(x * unit);
  return t;
}

double side_of(const LevelSet& level) { return level.value < 0 ? -1 : 1; }
Tensor<double> axis(double length) { return {length, 0, 0, 0, length, 0, 0, 0, length}; }

/// X in the plane of the axis J of a cone and the unit vector U across it.
struct AxialPlane {
  double along, beside;
  Tensor<double> across;

  AxialPlane(const LevelSet& level, const Tensor<double>& X) : j_(side_of(level) / std::sqrt(3.0)) {
    along = j_ * trace(X);
    for (int k = 0; k < 9; ++k) across[k] = X[k] - (k % 4 == 0 ? along * j_ : 0);
    beside = norm(across);
    if (beside > 0)
      for (double& x : across) x /= beside;
  }
  /// sin(a) J - cos(a) U: what lies at an angle phi < 90 degrees + a has it behind for phi > a; it
  /// is dual to the cone for a >= theta, the cone's angle.
  Tensor<double> normal(double a) const {
    Tensor<double> d;
    for (int k = 0; k < 9; ++k)
      d[k] = (k % 4 == 0 ? std::sin(a) * j_ : 0) - std::cos(a) * across[k];
    return d;
  }

 private:
  double j_;
};

double angle_of(const LevelSet& level) { return std::acos(std::fabs(level.value)); }

/// Where all tensors are on the cone's side of tr = 0: the direction of their hull nearest to the
/// axis is that of the nearest point of the tensors scaled to trace one. Of the normals between the
/// plane through it and the cone's own tangent plane the middle one is taken.
Tensor<double> normal_at_nearest_direction(const LevelSet& level,
                                           std::span<const Tensor<double>> tensors) {
  std::vector<Tensor<double>> scaled(tensors.begin(), tensors.end());
  for (Tensor<double>& t : scaled) {
    const double tr = side_of(level) * trace(t);
    for (double& x : t) x /= tr;
  }
  const AxialPlane nearest(level, nearest_to_origin(scaled));
  return few_bits(
      nearest.normal((std::atan2(nearest.beside, nearest.along) + angle_of(level)) / 2));
}

/// In general: the point of the hull nearest to the cone, by Frank and Wolfe's method, as far as
/// needed for the normal there to have all tensors behind it. That normal is minus the point's
/// projection on the polar cone, turned a little to the axis, so that rounding does not take it out
/// of the dual cone.
Tensor<double> normal_at_nearest_point(const LevelSet& level,
                                       std::span<const Tensor<double>> tensors) {
  constexpr int kSteps = 32;
  constexpr double kTurn = 0x1p-16;
  const double theta = angle_of(level);
  Tensor<double> x{};
  for (const auto& t : tensors)
    for (int k = 0; k < 9; ++k) x[k] += t[k] / static_cast<double>(tensors.size());
  for (int step = 0;; ++step) {
    const AxialPlane plane(level, x);
    // Beyond the polar cone's angle, 90 degrees + theta, minus X itself is the normal.
    const double phi = std::atan2(plane.beside, plane.along);
    const Tensor<double> d = plane.normal(std::fmax(theta, phi - std::acos(0.0)) + kTurn);
    const auto worst = std::ranges::max_element(
        tensors, {}, [&](const Tensor<double>& t) { return double_dot(d, t); });
    if (step == kSteps || double_dot(d, *worst) < 0) return few_bits(d);
    for (int k = 0; k < 9; ++k) x[k] += 2.0 / (step + 3) * ((*worst)[k] - x[k]);
  }
}

}  // namespace

Tensor<double> normal_at_mean(const LevelSet& level, std::span<const Tensor<double>> tensors) {
  Tensor<double> mean{};
  for (const auto& t : tensors)
    for (int k = 0; k < 9; ++k) mean[k] += t[k];
  if (level.kind == LevelSet::Kind::Magnitude) return few_bits(mean);
  const AxialPlane plane(level, mean);
  if (plane.along <= 0 || plane.beside == 0) return axis(side_of(level));
  return few_bits(plane.normal((std::atan2(plane.beside, plane.along) + angle_of(level)) / 2));
}

Tensor<double> normal_at_nearest(const LevelSet& level, std::span<const Tensor<double>> tensors) {
  if (level.kind == LevelSet::Kind::Magnitude) return few_bits(nearest_to_origin(tensors));
  const bool ahead = std::ranges::all_of(
      tensors, [&](const Tensor<double>& t) { return side_of(level) * trace(t) > 0; });
  return ahead ? normal_at_nearest_direction(level, tensors)
               : normal_at_nearest_point(level, tensors);
}

}  // namespace triplex

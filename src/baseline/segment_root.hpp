// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace triplex::baseline {

/// Value and derivative at t of a polynomial with these Bernstein coefficients on [0,1].
template <std::size_t Count>
std::pair<double, double> value_and_slope(std::array<double, Count> b, double t) {
  constexpr int kDegree = static_cast<int>(Count) - 1;
  for (int n = kDegree; n > 1; --n)
    for (int k = 0; k < n; ++k) b[k] += t * (b[k + 1] - b[k]);
  const double slope = b[1] - b[0];
  return {b[0] + t * slope, kDegree * slope};
}

/// A root in [0,1] of the polynomial, approximately: Newton's steps from the root of the chord, and
/// bisection where they leave the bracket or do not halve it. Rounding size where the root is
/// simple. \pre the first coefficient is negative, the last is not.
template <std::size_t Count>
double root_approx(const std::array<double, Count>& b) {
  constexpr int kSteps = 80;
  constexpr double kResolution = 0x1p-52;
  double noise = 0;  // values up to here are rounding
  for (const double c : b) noise = std::fmax(noise, 0x1p-52 * std::fabs(c));
  double low = 0, high = 1;
  double t = b.front() / (b.front() - b.back());
  double last_step = 1;
  for (int step = 0; step < kSteps; ++step) {
    const auto [value, slope] = value_and_slope(b, t);
    if (std::fabs(value) <= noise) break;
    (value < 0 ? low : high) = t;
    if (high - low <= kResolution) break;
    double next = t - value / slope;
    if (std::fabs(next - t) <= kResolution * t) break;
    const bool usable = next > low && next < high && std::fabs(next - t) <= 0.5 * last_step;
    if (!usable) next = 0.5 * (low + high);
    last_step = std::fabs(next - t);
    t = next;
  }
  return t;
}

}  // namespace triplex::baseline

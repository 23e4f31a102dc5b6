// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>

#include "triplex/trace/hyperstreamline.hpp"

namespace triplex::test {

/// T = diag(2, B) with B = [[a s, 1], [s, -a s]]: a dominant eigenvector along x everywhere. D has
/// the sign of s + a^2 s^2: real for s > 0, complex for -1/a^2 < s < 0, and on the linear
/// degenerate surface at s = 0 with the repeating eigenvector y. The other eigenvalues are
/// +-sqrt(s + a^2 s^2). \pre s < 4/9: there p and q have no other zero but p = 0 at s = -4/3.
inline Tensor<double> block_tensor(double s, double a = 0) {
  return {2, 0, 0, 0, a * s, 1, 0, s, -a * s};
}

/// A curve along x from `first` to `last` through these abscissae, in `field(x)`; arc length x.
inline Hyperstreamline straight_curve(const std::vector<double>& abscissae,
                                      const std::function<Tensor<double>(double)>& field) {
  Hyperstreamline curve;
  for (const double x : abscissae) {
    const Tensor<double> t = field(x);
    curve.points.push_back({{x, 0, 0}, {1, 0, 0}, x, TetId{0}, t, classify(t)});
  }
  return curve;
}

/// From the real domain at x = -0.25 through the degenerate surface at 0 into the outer complex
/// domain and on to x = 0.25, with its event.
inline Hyperstreamline crossing_curve(double a = 0) {
  Hyperstreamline curve =
      straight_curve({-0.25, -0.1, 0.1, 0.25}, [a](double x) { return block_tensor(-x, a); });
  curve.events.push_back({1, 0.5, {0, 0, 0}, Feature::DegenerateLinear, 2, 1, false});
  return curve;
}

}  // namespace triplex::test

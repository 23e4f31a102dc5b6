// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "linear_fields.hpp"
#include "triplex/tensor/dual_eigenvectors.hpp"
#include "triplex/tensor/eigenvectors.hpp"

namespace triplex {
namespace {

using testing_fields::dot;

double angle(const Direction& a, const Direction& b) {
  const std::array<double, 3> c = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                   a[0] * b[1] - a[1] * b[0]};
  return std::atan2(std::sqrt(dot(c, c)), std::fabs(dot(a, b)));
}

/// Across a degenerate surface D changes its sign at a simple root, so it goes to zero like the
/// distance d, and the difference of the two eigenvalues, real or imaginary, like sqrt(d). The
/// eigenvectors differ by as much from the one of the double eigenvalue to first order, in opposite
/// or imaginary multiples of one vector: so the angle of the real ones and the ratio of the axes
/// go like sqrt(d), while the long axis, to which that multiple does not contribute, goes like d.
TEST(DegenerateRates, ThornsAndLeavesConvergeToTheRepeatingEigenvector) {
  GridOptions options;
  options.n = 2;
  const TensorField field = generate_lorenz(options);
  const Tracer tracer(field);
  int measured = 0;
  for (const Point& seed : {Point{3, 5, 20}, Point{-8, 2, 35}, Point{12, -9, 14}, Point{5, 16, 40},
                            Point{-15, -4, 22}, Point{1, 7, 48}}) {
    const Hyperstreamline stem = tracer.trace(seed);
    for (const StemEvent& e : stem.events) {
      if (e.feature != Feature::DegenerateLinear && e.feature != Feature::DegeneratePlanar)
        continue;
      // Points at exact arc lengths from the crossing, on both of its sides.
      const auto at = [&](double length, int end) {
        TraceOptions near;
        near.max_length = length;
        near.tolerance = 1e-12;
        const Hyperstreamline piece = tracer.trace(e.position, near);
        EXPECT_EQ(piece.ends[end], StemEnd::Length);
        return end == 0 ? piece.points.front() : piece.points.back();
      };
      const double far = 1e-3, close = 1e-5;
      const int real_end = at(far, 0).place.in_real_domain() ? 0 : 1;
      if (!at(far, real_end).place.in_real_domain()) continue;
      if (at(far, 1 - real_end).place.in_real_domain()) continue;
      const bool linear = e.feature == Feature::DegenerateLinear;
      const auto thorns = [&](const Tensor<double>& t) {
        const Eigenvectors v = eigenvectors(t);
        return angle(v.vectors[1], v.vectors[linear ? 2 : 0]);
      };
      const double slope_angle =
          std::log10(thorns(at(far, real_end).tensor) / thorns(at(close, real_end).tensor)) / 2;
      EXPECT_NEAR(slope_angle, 0.5, 0.05);
      const DualEigenvectors leaf_far = dual_eigenvectors(at(far, 1 - real_end).tensor);
      const DualEigenvectors leaf_close = dual_eigenvectors(at(close, 1 - real_end).tensor);
      EXPECT_NEAR(std::log10(leaf_far.axis_ratio / leaf_close.axis_ratio) / 2, 0.5, 0.05);
      // The repeating eigenvector, from the real side: the middle of the two thorns.
      const Eigenvectors v = eigenvectors(at(1e-9, real_end).tensor);
      const Direction a = v.vectors[1], b = v.vectors[linear ? 2 : 0];
      const double s = dot(a, b) < 0 ? -1 : 1;
      Direction repeating{};
      for (int c = 0; c < 3; ++c) repeating[c] = a[c] + s * b[c];
      EXPECT_NEAR(std::log10(angle(leaf_far.long_axis, repeating) /
                             angle(leaf_close.long_axis, repeating)) /
                      2,
                  1, 0.05);
      EXPECT_LT(angle(leaf_close.long_axis, repeating), 1e-3);
      EXPECT_LT(thorns(at(1e-9, real_end).tensor), 1e-2);
      ++measured;
    }
  }
  EXPECT_GE(measured, 3);
}

}  // namespace
}  // namespace triplex

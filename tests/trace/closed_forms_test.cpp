// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "linear_fields.hpp"

namespace triplex {
namespace {

using testing_fields::distance;
using testing_fields::dot;
using testing_fields::grid;
using testing_fields::sampled;

TEST(ClosedForms, ConstantFieldGivesAStraightLineToBothSides) {
  // Eigenvalue 3 with eigenvector (1, 2, 2) / 3, a complex pair across it.
  const std::array<double, 3> v = {1. / 3, 2. / 3, 2. / 3};
  Tensor<double> t{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[3 * i + j] = 3 * v[i] * v[j];
  const Tensor<double> turn = {0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0};
  for (int i = 0; i < 9; ++i) t[i] += turn[i];
  const TensorField field =
      sampled(grid(5, {{0, 0, 0}, {1, 1, 1}}, 0.1), [&](const Point&) { return t; });
  const Point seed = {0.4, 0.45, 0.55};
  const Hyperstreamline stem = Tracer(field).trace(seed);
  EXPECT_EQ(stem.ends[0], StemEnd::Boundary);
  EXPECT_EQ(stem.ends[1], StemEnd::Boundary);
  EXPECT_TRUE(stem.events.empty());
  ASSERT_GT(stem.points.size(), 5u);
  EXPECT_EQ(stem.points[stem.seed].position, seed);
  EXPECT_EQ(stem.points[stem.seed].arc_length, 0);
  for (const StemPoint& p : stem.points) {
    Point expected = seed;
    for (int c = 0; c < 3; ++c) expected[c] += p.arc_length * v[c];
    EXPECT_LT(distance(p.position, expected), 1e-13);
    EXPECT_GT(dot(p.forward, v), 1 - 1e-14);
  }
  // The line leaves the unit cube through y = 0 behind and through z = 1 ahead.
  EXPECT_NEAR(stem.points.front().position[1], 0, 1e-13);
  EXPECT_NEAR(stem.points.back().position[2], 1, 1e-13);
  for (std::size_t i = 1; i < stem.points.size(); ++i)
    EXPECT_GT(stem.points[i].arc_length, stem.points[i - 1].arc_length);
}

TEST(ClosedForms, LinesAlongEdgesAndFacesAndThroughVertices) {
  const Tensor<double> t = {0, -1, 0, 1, 0, 0, 0, 0, 2};  // dominant along z
  const TensorField field =
      sampled(grid(4, {{0, 0, 0}, {1, 1, 1}}), [&](const Point&) { return t; });
  const Tracer tracer(field);
  for (const double x : {0.0, 0.25, 0.3, 0.5, 1.0})
    for (const double y : {0.0, 0.25, 0.5, 0.8, 1.0})
      for (const double z : {0.0, 0.25, 0.6, 1.0}) {
        const Hyperstreamline stem = tracer.trace({x, y, z});
        EXPECT_EQ(stem.points.front().position, (Point{x, y, 0})) << x << " " << y << " " << z;
        EXPECT_EQ(stem.points.back().position, (Point{x, y, 1})) << x << " " << y << " " << z;
        EXPECT_EQ(stem.ends[0], StemEnd::Boundary);
        EXPECT_EQ(stem.ends[1], StemEnd::Boundary);
      }
}

/// Dominant eigenvector (-y, x, 1): T is block triangular, with the complex pair +-i in the (x, y)
/// block M and the real eigenvalue 2; (M - 2) (-y, x) + (T13, T23) = 0.
Tensor<double> helical(const Point& p) {
  return {0, -1, -2 * p[1] + p[0], 1, 0, p[1] + 2 * p[0], 0, 0, 2};
}

TEST(ClosedForms, Helix) {
  for (const int n : {3, 7}) {
    const TensorField field = sampled(grid(n, {{-2, -2, 0}, {2, 2, 8}}, 0.1), helical);
    const double radius = 1.25;
    const Hyperstreamline stem = Tracer(field).trace({radius, 0, 4});
    EXPECT_EQ(stem.ends[1], StemEnd::Boundary);
    EXPECT_NEAR(stem.points.back().position[2], 8, 1e-12);
    for (const StemPoint& p : stem.points) {
      const double height = p.position[2] - 4;
      const Point expected = {radius * std::cos(height), radius * std::sin(height), p.position[2]};
      EXPECT_LT(distance(p.position, expected), 1e-6);
      EXPECT_NEAR(p.arc_length, height * std::hypot(1, radius), 1e-6);
    }
  }
}

TEST(ClosedForms, ErrorsFollowTheTolerance) {
  const TensorField field = sampled(grid(2, {{-2, -2, 0}, {2, 2, 8}}), helical);
  const Tracer tracer(field);
  double last = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    TraceOptions options;
    options.tolerance = tolerance;
    const Point end = tracer.trace({1.25, 0, 4}, options).points.back().position;
    const double error = distance(end, {1.25 * std::cos(4), 1.25 * std::sin(4), 8});
    EXPECT_LT(error, 1e3 * tolerance);
    EXPECT_LT(error, last);
    last = error;
  }
}

/// Major eigenvector at half the polar angle: the curves are the confocal parabolas on which the
/// imaginary part of sqrt(x + i y) is constant.
Tensor<double> parabolic(const Point& p) { return {p[0], p[1], 0, p[1], -p[0], 0, 0, 0, -0.25}; }

TEST(ClosedForms, ParabolasAroundALineOfDegeneratePoints) {
  const TensorField field = sampled(grid(4, {{-1, -1, 0}, {1, 1, 1}}, 0.1), parabolic);
  const Tracer tracer(field);
  for (const double y : {0.5, 0.1, 0.01}) {
    TraceOptions options;
    options.field = EigenvectorField::Major;
    const Hyperstreamline stem = tracer.trace({0.0, y, 0.5}, options);
    EXPECT_EQ(stem.ends[0], StemEnd::Boundary);
    EXPECT_EQ(stem.ends[1], StemEnd::Boundary);
    const double level = std::sqrt(std::complex<double>(0, y)).imag();
    for (const StemPoint& p : stem.points) {
      EXPECT_NEAR(std::sqrt(std::complex<double>(p.position[0], p.position[1])).imag(), level,
                  1e-6);
      EXPECT_NEAR(p.position[2], 0.5, 1e-12);
    }
  }
}

TEST(ClosedForms, PeriodicLineComesBackToItsStart) {
  const Tensor<double> t = {2, 0, 0, 0, 0, -1, 0, 1, 0};  // dominant along x
  TensorField field = sampled(grid(5, {{0, 0, 0}, {1, 1, 1}}), [&](const Point&) { return t; });
  TraceOptions options;
  options.max_length = 3;
  const Point seed = {0.3, 0.41, 0.57};
  const Hyperstreamline stem = Tracer(field, {true, false, false}).trace(seed, options);
  EXPECT_EQ(stem.ends[0], StemEnd::Length);
  EXPECT_EQ(stem.ends[1], StemEnd::Length);
  EXPECT_EQ(stem.leaps.size(), 6u);
  EXPECT_LT(distance(stem.points.back().position, seed), 1e-13);
  EXPECT_LT(distance(stem.points.front().position, seed), 1e-13);
  EXPECT_NEAR(stem.points.back().arc_length, 3, 1e-13);
  for (const std::size_t leap : stem.leaps) {
    EXPECT_EQ(stem.points[leap].tensor, stem.points[leap + 1].tensor);
    EXPECT_EQ(stem.points[leap].arc_length, stem.points[leap + 1].arc_length);
    EXPECT_NEAR(std::fabs(stem.points[leap].position[0] - stem.points[leap + 1].position[0]), 1,
                1e-13);
    EXPECT_EQ(stem.points[leap].position[1], stem.points[leap + 1].position[1]);
  }
  EXPECT_EQ(Tracer(field).trace(seed, options).leaps.size(), 0u);
}

TEST(ClosedForms, PeriodicLineThroughEdgesAndCorners) {
  // Along the diagonal of the cube: it leaves by a corner, across all three axes at once.
  const double s = std::sqrt(3.0);
  const Tensor<double> t = {1, 1 - s, 1 + s, 1 + s, 1, 1 - s, 1 - s, 1 + s, 1};
  TensorField field = sampled(grid(4, {{0, 0, 0}, {1, 1, 1}}), [&](const Point&) { return t; });
  TraceOptions options;
  options.max_length = 4 * s;
  const Point seed = {0.5, 0.5, 0.5};
  const Hyperstreamline stem = Tracer(field, {true, true, true}).trace(seed, options);
  EXPECT_EQ(stem.ends[1], StemEnd::Length);
  EXPECT_LT(distance(stem.points.back().position, seed), 1e-11);
  EXPECT_EQ(stem.leaps.size(), 8u);
}

}  // namespace
}  // namespace triplex

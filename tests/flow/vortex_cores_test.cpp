// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/flow/vortex_cores.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "linear_flow.hpp"

namespace triplex {
namespace {

constexpr Point kAxis = {0.13, 0.21, 0};

/// A vortex around the line through kAxis along z, stretched along it: S = diag(-1, -1, 2), W turns
/// with speed w, p = w^2 - 3. The spectral norms of S and W are 2 and w.
VectorField vortex(double w, double factor = 1) {
  VectorField field = test::linear_flow({-1, -w, 0, w, -1, 0, 0, 0, 2}, kAxis, {0, 0, 3});
  for (Point& v : field.vectors)
    for (double& x : v) x *= factor;
  return field;
}

double length_of_axis(const LineSet& lines) {
  double length = 0;
  for (const auto& line : lines.lines) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Point& x = lines.points[line[k]];
      EXPECT_NEAR(x[0], kAxis[0], 1e-7);  // single precision
      EXPECT_NEAR(x[1], kAxis[1], 1e-7);
      if (k > 0) length += std::fabs(x[2] - lines.points[line[k - 1]][2]);
    }
  }
  return length;
}

const PointValues& values(const LineSet& lines, const std::string& name) {
  return *std::ranges::find(lines.point_values, name, &PointValues::name);
}

TEST(VortexCores, BothFindTheAxisOfAFastVortex) {
  for (const CoreFilter filter : {CoreFilter::Vtk, CoreFilter::Complex})
    EXPECT_NEAR(length_of_axis(vortex_cores(vortex(5), filter)), 2, 1e-6);
}

TEST(VortexCores, VtkDiscardsThoseWithNegativeP) {
  EXPECT_TRUE(vortex_cores(vortex(1)).lines.empty());
  const LineSet lines = vortex_cores(vortex(1), CoreFilter::Complex);
  EXPECT_NEAR(length_of_axis(lines), 2, 1e-6);
  ASSERT_EQ(values(lines, "p").values.size(), lines.points.size());
  for (const double p : values(lines, "p").values) EXPECT_NEAR(p, -2, 1e-9);
  for (const double q : values(lines, "q").values) EXPECT_NEAR(q, 4, 1e-9);
  for (const double domain : values(lines, "domain").values) EXPECT_EQ(domain, 1);
  ASSERT_EQ(values(lines, "gradient").values.size(), 9 * lines.points.size());
  EXPECT_NEAR(values(lines, "gradient").values[1], -1, 1e-9);
}

TEST(VortexCores, VtkDiscardsEvenSomeWithPositiveP) {
  EXPECT_TRUE(vortex_cores(vortex(1.9)).lines.empty());  // p = 0.61
  EXPECT_NEAR(length_of_axis(vortex_cores(vortex(2.1))), 2, 1e-6);
}

TEST(VortexCores, RealEigenvaluesAreNoVortex) {
  const VectorField strain =
      test::linear_flow({-1, 0.5, 0, 0.5, -1.5, 0, 0, 0, 2.5}, kAxis, {0, 0, 3});
  EXPECT_TRUE(vortex_cores(strain, CoreFilter::Complex).lines.empty());
}

TEST(VortexCores, DoNotDependOnTheUnitOfVelocity) {
  const LineSet one = vortex_cores(vortex(1), CoreFilter::Complex);
  const LineSet tiny = vortex_cores(vortex(1, 0x1p-60), CoreFilter::Complex);
  EXPECT_EQ(one.points, tiny.points);
  EXPECT_EQ(one.lines, tiny.lines);
}

}  // namespace
}  // namespace triplex

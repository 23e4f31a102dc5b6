// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "baseline/split_triangle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "baseline/mesh_builder.hpp"

namespace triplex::baseline {
namespace {

/// Twice the signed area of a triangle in the plane z = 0.
double doubled_area(const FieldTriangle& t) {
  return (t[1].x[0] - t[0].x[0]) * (t[2].x[1] - t[0].x[1]) -
         (t[1].x[1] - t[0].x[1]) * (t[2].x[0] - t[0].x[0]);
}

double doubled_area(const std::vector<FieldTriangle>& triangles) {
  double sum = 0;
  for (const FieldTriangle& t : triangles) {
    EXPECT_GE(doubled_area(t), 0);  // parts keep the orientation
    sum += doubled_area(t);
  }
  return sum;
}

const FieldTriangle kUnit{FieldPoint{{0, 0, 0}, {}}, FieldPoint{{1, 0, 0}, {}},
                          FieldPoint{{0, 1, 0}, {}}};

TEST(DivideTriangle, ByTraceAsALineDoes) {
  FieldTriangle t = kUnit;  // tr T = 4 x - 1
  t[0].t[0] = t[2].t[4] = -1;
  t[1].t[8] = 3;
  DividedTriangles result;
  divide_triangle(t, Divider::Trace, PatchTest::Layers, 6, result);
  EXPECT_EQ(result.counts.three_sided, 1u);
  EXPECT_NEAR(doubled_area(result.parts[1]), 0.75 * 0.75, 1e-15);
  EXPECT_NEAR(doubled_area(result.parts[0]), 1 - 0.75 * 0.75, 1e-15);
  ASSERT_EQ(result.curve.size(), 1u);
  for (const FieldPoint& x : {result.curve[0].first, result.curve[0].second})
    EXPECT_NEAR(x.x[0], 0.25, 1e-15);
}

double det_of(const FieldPoint& x) { return forms_of<double, 1>({triple_deviator(x.t)}).q[0]; }
double minor_of(const FieldPoint& x) { return forms_of<double, 1>({triple_deviator(x.t)}).p[0]; }

/// Random triangles: the parts cover the triangle, the curve lies on the zero set, and the corners
/// of parts have their sign.
TEST(DivideTriangle, ByInvariants) {
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> number(-1, 1);
  std::size_t cut = 0, halved = 0, segments = 0;
  for (int n = 0; n < 400; ++n) {
    FieldTriangle t = kUnit;
    for (FieldPoint& x : t)
      for (double& entry : x.t) entry = number(engine);
    const bool by_det = n % 2 == 0;
    DividedTriangles result;
    divide_triangle(t, by_det ? Divider::Det : Divider::Minor, PatchTest::LayersOrGrowth, 12,
                    result);
    EXPECT_NEAR(doubled_area(result.parts[0]) + doubled_area(result.parts[1]), 1, 1e-13);
    const auto value = by_det ? det_of : minor_of;
    for (const auto& [a, b] : result.curve) {
      EXPECT_NEAR(value(a), 0, 1e-10);
      EXPECT_NEAR(value(b), 0, 1e-10);
    }
    if (!result.given_up)
      for (std::size_t part = 0; part < 2; ++part)
        for (const FieldTriangle& piece : result.parts[part])
          for (const FieldPoint& x : piece) {
            if (part == 1)
              EXPECT_GE(value(x), -1e-10);
            else
              EXPECT_LE(value(x), 1e-10);
          }
    cut += result.counts.three_sided > 0;
    halved += result.counts.subdivided > 0;
    segments += result.curve.size();
    const std::size_t pieces = result.parts[0].size() + result.parts[1].size();
    if (result.counts.subdivided == 0) {
      EXPECT_EQ(pieces, result.curve.empty() ? 1u : 3u);
    }
  }
  EXPECT_GT(cut, 50u);
  EXPECT_GT(halved, 50u);
  EXPECT_GT(segments, 200u);
}

TEST(DivideTriangle, GivesUpAtTheDepthLimit) {
  FieldTriangle t = kUnit;
  std::mt19937 engine(12);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int n = 0; n < 200; ++n) {
    for (FieldPoint& x : t)
      for (double& entry : x.t) entry = number(engine);
    DividedTriangles result;
    divide_triangle(t, Divider::Det, PatchTest::Layers, 0, result);
    EXPECT_EQ(result.counts.subdivided, 0u);
    EXPECT_EQ(result.given_up, result.counts.given_up == 1);
    if (!result.given_up) continue;
    DividedTriangles deeper;
    divide_triangle(t, Divider::Det, PatchTest::Layers, 4, deeper);
    EXPECT_GT(deeper.counts.subdivided, 0u);
    result.clear();
    EXPECT_FALSE(result.given_up);
    EXPECT_TRUE(result.parts[0].empty() && result.parts[1].empty() && result.curve.empty());
    return;
  }
  FAIL() << "no triangle was given up";
}

TEST(MeshBuilder, WeldsWhatIsNear) {
  TetMesh mesh;
  mesh.points = {{1, 1, 1}, {2, 1, 1}, {1, 3, 1}};
  const WeldGrid grid(mesh);
  MeshBuilder builder(grid);
  std::vector<std::uint32_t> number;
  const auto add = [&](const Point& x) {
    const auto [n, is_new] = builder.add_point(x);
    if (is_new) builder.set_invariants(-3, 2);
    number.push_back(n);
    return is_new;
  };
  EXPECT_TRUE(add({1, 1, 1}));
  EXPECT_TRUE(add({1.5, 1, 1}));
  EXPECT_FALSE(add({1.5 + 1e-15, 1, 1 - 1e-15}));
  EXPECT_TRUE(add({1.5, 1 + 1e-10, 1}));
  for (int n = 0; n < 1000; ++n) EXPECT_TRUE(add({1.5, 2 + n * 1e-9, 1}));
  for (int n = 0; n < 1000; ++n) EXPECT_FALSE(add({1.5, 2 + n * 1e-9, 1}));
  EXPECT_EQ(number[1], number[2]);
  builder.add_triangle({number[0], number[1], number[2]}, 7);  // twice the same point
  builder.add_triangle({number[0], number[1], number[3]}, 8);
  MeshBuilder whole(grid);
  whole.append(builder.mesh());
  whole.append(builder.mesh());
  const FeatureMesh joined = whole.finish();
  EXPECT_EQ(joined.points, builder.mesh().points);
  EXPECT_EQ(joined.triangles.size(), 2u);
  EXPECT_EQ(joined.source_cell, (std::vector<std::int64_t>{8, 8}));
  EXPECT_EQ(joined.certified, (std::vector<std::uint8_t>{0, 0}));
  EXPECT_EQ(joined.mode.front(), 1);
}

}  // namespace
}  // namespace triplex::baseline

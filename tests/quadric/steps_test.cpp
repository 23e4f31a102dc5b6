// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One tet with the tensor diag(x, y, z) - 1/4: magnitude surfaces are spheres around its middle.
#include "triplex/quadric/quadric_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "triplex/feature/feature_table.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

TensorField one_tet() {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  field.mesh.tets = {{VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}}};
  for (const Point& x : field.mesh.points)
    field.tensors.push_back({x[0] - 0.25, 0, 0, 0, x[1] - 0.25, 0, 0, 0, x[2] - 0.25});
  return field;
}

QuadricSteps steps(double radius) {
  FeatureTable table;
  const Feature f = table.add_magnitude(radius);
  return quadric_steps(one_tet(), TetId{0}, table.row(f), 10);
}

double distance(const Point& x) { return std::hypot(x[0] - 0.25, x[1] - 0.25, x[2] - 0.25); }

/// 0.27 is more than the distances 0.25 and 0.144 of the faces, and less than that of the edges.
TEST(QuadricSteps, ASphereThroughAllFacesHasFourCircles) {
  const QuadricSteps found = steps(0.27);
  EXPECT_EQ(found.type, QuadricType::Ellipsoid);
  ASSERT_EQ(found.patches.size(), 1u);
  const QuadricPatchSteps& patch = found.patches[0];
  ASSERT_EQ(patch.curves.size(), 4u);
  for (const auto& curve : patch.curves)
    for (const Point& x : curve) {
      EXPECT_NEAR(distance(x), 0.27, 1e-12);
      EXPECT_NEAR(std::fmin(std::fmin(x[0], x[1]), std::fmin(x[2], 1 - x[0] - x[1] - x[2])), 0,
                  1e-12);
    }
  const SurfaceTopology t = surface_topology(patch.triangles, patch.points.size());
  EXPECT_EQ(t.euler, 2 - 4);
  EXPECT_EQ(t.boundary_loops, 4u);
  // In the plane no triangle is turned over: it is one region with three holes.
  ASSERT_EQ(patch.domain.size(), patch.points.size());
  int turned = 0;
  for (const auto& [a, b, c] : patch.triangles) {
    const auto &x = patch.domain[a], &y = patch.domain[b], &z = patch.domain[c];
    turned += (y[0] - x[0]) * (z[1] - x[1]) - (z[0] - x[0]) * (y[1] - x[1]) < 0;
  }
  EXPECT_TRUE(turned == 0 || turned == static_cast<int>(patch.triangles.size()));
  for (const Point& x : patch.points) EXPECT_NEAR(distance(x), 0.27, 1e-9);
}

TEST(QuadricSteps, AClosedSphereAndNothingHaveNoPatches) {
  EXPECT_TRUE(steps(0.1).patches.empty());
  EXPECT_EQ(steps(0.1).type, QuadricType::Ellipsoid);
  EXPECT_TRUE(steps(2).patches.empty());
}

TEST(QuadricSteps, OtherSurfacesAreRefused) {
  const FeatureTable table;
  EXPECT_THROW(quadric_steps(one_tet(), TetId{0}, table.row(Feature::NeutralReal), 4),
               std::invalid_argument);
}

}  // namespace
}  // namespace triplex

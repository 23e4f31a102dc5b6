// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A free-slip wall, on which a degenerate surface has a node at an irrational point.
#include <gtest/gtest.h>

#include <cmath>

#include "fields.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

/// Keeps vertices off the curve of touching.
constexpr double kShift = 1.0 / 97;

/// Along z = 0 nothing couples z to the plane but one row. The pair of y and z is degenerate near
/// t^2 = z (x - 1/8 + y + z), t = y + s - (x + 3)^2 / 16, for z > 0 the graph of one positive root
/// over the plane, which touches it along t = 0 up to the node, where x - 1/8 + y = 0, and is a
/// nappe of a cone there; s is the shift.
TensorField wall(int n, CellSplit split, bool transposed, double lowest = 0, double offset = 3) {
  GridOptions grid;
  grid.n = n;
  grid.split = split;
  grid.box = Box{{-1, -1, lowest}, {1, 1, 1}};
  TensorField field = generate_constant(grid);
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    const auto [x, y, z] = field.mesh.points[v];
    const double below = -(x - 0.125 + y + z) / 4;
    field.tensors[v] =
        transposed ? Tensor<double>{16, x + offset, 0, x + offset, y + kShift, below, 0, z, 0}
                   : Tensor<double>{16, x + offset, 0, x + offset, y + kShift, z, 0, below, 0};
  }
  return field;
}

class BoundaryNode : public testing::TestWithParam<bool> {};

TEST_P(BoundaryNode, EndsTheCurveOfTouchingOnEveryMesh) {
  // (x + 3)^2 / 16 = 1/8 - x + s
  const double x = std::sqrt(114 + 16 * kShift) - 11, y = 0.125 - x;
  for (const CellSplit split : {CellSplit::Five, CellSplit::Six})
    for (const int n : {1, 2, 3, 5, 8}) {
      const Extraction result = extract(wall(n, split, GetParam()));
      EXPECT_TRUE(result.certified())
          << n << (result.unresolved.empty() ? "" : result.unresolved.front().reason);
      const FeatureMesh& page = result.mesh(Feature::DegenerateLinear);
      const SurfaceTopology topology = surface_topology(page.triangles, page.points.size());
      EXPECT_EQ(topology.components, 1u) << n;
      EXPECT_EQ(topology.euler, 1) << n;
      EXPECT_EQ(topology.boundary_loops, 1u) << n;
      EXPECT_TRUE(result.mesh(Feature::DegeneratePlanar).triangles.empty());
      ASSERT_EQ(result.nodes.size(), 1u) << n;
      const Node& node = result.nodes.front();
      EXPECT_EQ(node.status, NodeStatus::Face);
      EXPECT_EQ(node.feature, Feature::DegenerateLinear);
      EXPECT_NEAR(node.position[0], x, 1e-12);
      EXPECT_NEAR(node.position[1], y, 1e-12);
      EXPECT_NEAR(node.position[2], 0, 1e-12);
      EXPECT_NEAR(node.eigenvalue, -(16 + y + kShift) / 3, 1e-12);
    }
}

/// There the surface passes through, and touching no longer describes it.
TEST_P(BoundaryNode, IsNotPassedOverInsideTheDomain) {
  ExtractionOptions options;
  options.max_bisections = 128;
  for (const int n : {2, 4})
    EXPECT_FALSE(extract(wall(n, CellSplit::Six, GetParam(), -1), options).certified());
}

/// With x in place of x + 3 nothing couples x in the plane x = 0 either. Edges of even grids lie in
/// both planes, and the curve of touching of the one crosses the other.
TEST_P(BoundaryNode, MayLieBesideAnotherPlane) {
  for (const int n : {2, 4, 6}) {
    const Extraction result = extract(wall(n, CellSplit::Six, GetParam(), 0, 0));
    EXPECT_TRUE(result.certified()) << n;
    const FeatureMesh& page = result.mesh(Feature::DegenerateLinear);
    EXPECT_EQ(surface_topology(page.triangles, page.points.size()).euler, 1) << n;
    EXPECT_EQ(result.nodes.size(), 1u) << n;
  }
}

/// With the upper side identified with the wall the surface passes through.
TEST_P(BoundaryNode, IsNotPassedOverInAPeriodicDomain) {
  constexpr int n = 3;
  TensorField field = wall(n, CellSplit::Six, GetParam());
  make_periodic(field, n, {false, false, true});
  ExtractionOptions options;
  options.max_bisections = 128;
  EXPECT_TRUE(extract(field, options).certified());
  options.periodic = {false, false, true};
  EXPECT_FALSE(extract(field, options).certified());
}

INSTANTIATE_TEST_SUITE_P(ByRowAndByColumn, BoundaryNode, testing::Bool());

TEST(BoundaryFaces, AreThoseOfTheWallsThatAreNotIdentified) {
  const TensorField field = wall(2, CellSplit::Six, false);
  RefinableField refinable(field);
  const auto& faces = refinable.boundary_block_faces();
  EXPECT_EQ(faces.size(), 8u);
  for (const auto& face : faces)
    for (const VertexId v : face.vertices) EXPECT_EQ(refinable.position(v)[2], 0);
  EXPECT_TRUE(refinable.is_inside_boundary_block_face(faces.front().vertices));
  EXPECT_FALSE(refinable.is_inside_boundary_block_face(std::span(faces.front().vertices).first(2)));
  const auto first = faces.front().vertices;
  refinable.identify_boundary_faces([&](const auto& face) { return face == first; });
  EXPECT_EQ(faces.size(), 7u);
  EXPECT_FALSE(refinable.is_inside_boundary_block_face(first));
}

}  // namespace
}  // namespace triplex

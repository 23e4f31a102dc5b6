// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The gradient of the Lorenz system is linear in space and has one node, on the axis x = y = 0 at
// z = 263/9: inside a tet, in a face, on an edge, as the mesh has it. The planar degenerate surface
// is a double cone there, two discs with one common point, whatever the mesh is.
#include <gtest/gtest.h>

#include "../extract/fields.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

struct LorenzMesh {
  int n;
  double jitter;
  CellSplit split;
};
std::ostream& operator<<(std::ostream& out, const LorenzMesh& m) {
  return out << m.n << (m.jitter > 0 ? " jittered" : "")
             << (m.split == CellSplit::Five ? " 5" : " 6");
}

Extraction extract_lorenz(const LorenzMesh& mesh) {
  GridOptions grid;
  grid.n = mesh.n;
  grid.jitter = mesh.jitter;
  grid.split = mesh.split;
  grid.seed = 5;
  return extract(generate_lorenz(grid));
}

TEST(LorenzNode, IsOneAndJoinsTheTwoHalvesOfTheConeWhereverItLies) {
  int certified = 0;
  for (int n = 4; n <= 20; ++n)
    for (const LorenzMesh& mesh :
         {LorenzMesh{n, 0, CellSplit::Six}, LorenzMesh{n, 0, CellSplit::Five},
          LorenzMesh{n, 0.2, CellSplit::Six}}) {
      const Extraction result = extract_lorenz(mesh);
      EXPECT_EQ(result.nodes.size(), 1u) << mesh;
      if (result.nodes.size() != 1) continue;
      const Node& node = result.nodes.front();
      EXPECT_EQ(node.feature, Feature::DegeneratePlanar);
      EXPECT_NE(node.status, NodeStatus::Shared) << mesh;
      EXPECT_NEAR(node.position[0], 0, 1e-12);
      EXPECT_NEAR(node.position[1], 0, 1e-12);
      EXPECT_NEAR(node.position[2], 263.0 / 9, 1e-12);
      EXPECT_NEAR(node.eigenvalue, 17.0 / 9, 1e-12);
      if (!result.certified()) continue;
      ++certified;
      const FeatureMesh& surface = result.mesh(Feature::DegeneratePlanar);
      const SurfaceTopology t = surface_topology(surface.triangles, surface.points.size());
      EXPECT_EQ(t.components, 1u) << mesh;
      EXPECT_EQ(t.euler, 1) << mesh;
    }
  std::cout << certified << " of 51 meshes are certified\n";
  EXPECT_GE(certified, 40);
}

}  // namespace
}  // namespace triplex

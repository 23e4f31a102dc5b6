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

std::string name_of(const GridOptions& grid) {
  return std::to_string(grid.n) + (grid.jitter > 0 ? " jittered" : "") +
         (grid.split == CellSplit::Five ? " 5" : " 6");
}

TEST(LorenzNode, IsOneAndJoinsTheTwoHalvesOfTheConeWhereverItLies) {
  int certified = 0;
  for (int n = 4; n <= 20; ++n)
    for (const bool jittered : {false, true})
      for (const CellSplit split : {CellSplit::Six, CellSplit::Five}) {
        if (jittered && split == CellSplit::Five) continue;
        GridOptions grid;
        grid.n = n;
        grid.jitter = jittered ? 0.2 : 0;
        grid.seed = 5;
        grid.split = split;
        SCOPED_TRACE(name_of(grid));
        const Extraction result = extract(generate_lorenz(grid));
        EXPECT_EQ(result.nodes.size(), 1u);
        if (result.nodes.size() != 1) continue;
        const Node& node = result.nodes.front();
        EXPECT_EQ(node.feature, Feature::DegeneratePlanar);
        EXPECT_NE(node.status, NodeStatus::Shared);
        EXPECT_NEAR(node.position[0], 0, 1e-12);
        EXPECT_NEAR(node.position[1], 0, 1e-12);
        EXPECT_NEAR(node.position[2], 263.0 / 9, 1e-12);
        EXPECT_NEAR(node.eigenvalue, 17.0 / 9, 1e-12);
        if (!result.certified()) continue;
        ++certified;
        const FeatureMesh& surface = result.mesh(Feature::DegeneratePlanar);
        const SurfaceTopology t = surface_topology(surface.triangles, surface.points.size());
        EXPECT_EQ(t.components, 1u);
        EXPECT_EQ(t.euler, 1);
      }
  std::cout << certified << " of 51 meshes are certified\n";
  EXPECT_GE(certified, 40);
}

}  // namespace
}  // namespace triplex

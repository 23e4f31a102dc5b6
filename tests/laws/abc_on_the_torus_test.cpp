// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The Arnold-Beltrami-Childress flow at the default options, with opposite sides identified: its
// curve and nodes are known, and its surfaces are the same on every fine mesh.
#include <gtest/gtest.h>

#include <iostream>
#include <optional>

#include "../extract/fields.hpp"
#include "../extract/periodic_fields.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

Extraction extract_on_torus(const GridOptions& grid) {
  ExtractionOptions options;
  options.periodic = {true, true, true};
  return extract(generate_abc(grid), options);
}

using test::glued;

void expect_six_curves(const Extraction& result) {
  const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
  const CurveTopology t = curve_topology(glued(curve.segments, curve), curve.points.size());
  EXPECT_EQ(t.components, 6u);
  EXPECT_EQ(t.closed, 6u);
  EXPECT_EQ(t.ends, 0u);
  EXPECT_EQ(t.branches, 0u);
}

void expect_eight_nodes(const Extraction& result) {
  EXPECT_TRUE(result.nodes_undecided.empty());
  EXPECT_EQ(result.nodes.size(), 8u);
  EXPECT_EQ(std::ranges::count(result.nodes, Feature::DegenerateLinear, &Node::feature), 4);
  EXPECT_EQ(std::ranges::count(result.nodes, Feature::DegeneratePlanar, &Node::feature), 4);
  for (const Node& node : result.nodes) {
    EXPECT_NE(node.status, NodeStatus::Shared);
    EXPECT_FALSE(node.eigenvalue_enclosure.contains(0));
  }
}

TEST(AbcOnTheTorus, HasSixCurvesEightNodesAndTheSameSurfacesOnEveryMesh) {
  std::array<std::optional<SurfaceTopology>, kStandardPages> known;
  int compared = 0;
  for (const GridOptions& grid :
       {GridOptions{.n = 33, .seed = 9}, GridOptions{.n = 33, .jitter = 0.2, .seed = 9},
        GridOptions{.n = 32, .jitter = 0.2, .seed = 9},
        GridOptions{.n = 34, .jitter = 0.1, .seed = 9, .split = CellSplit::Five},
        GridOptions{.n = 32, .seed = 9}}) {
    SCOPED_TRACE(grid.n);
    const Extraction result = extract_on_torus(grid);
    EXPECT_TRUE(result.unresolved.empty());
    expect_six_curves(result);
    expect_eight_nodes(result);
    for (std::size_t f = 0; f < kStandardPages; ++f) {
      const FeatureMesh& surface = result.features[f];
      const SurfaceTopology t =
          surface_topology(glued(surface.triangles, surface), surface.points.size());
      EXPECT_EQ(t.nonmanifold_edges, 0u);
      EXPECT_EQ(t.nonmanifold_vertices, surface.nodes.size());
      EXPECT_EQ(t.orientation_conflicts, 0u);
      std::cout << "n = " << grid.n << ", " << standard_features().rows()[f].name << ": "
                << t.components << " components, euler " << t.euler << ", " << t.boundary_loops
                << " loops\n";
      if (known[f]) {
        EXPECT_EQ(t.components, known[f]->components);
        EXPECT_EQ(t.euler, known[f]->euler);
        EXPECT_EQ(t.boundary_loops, known[f]->boundary_loops);
        ++compared;
      }
      known[f] = t;
    }
  }
  EXPECT_EQ(compared, 4 * kStandardPages);
}

}  // namespace
}  // namespace triplex

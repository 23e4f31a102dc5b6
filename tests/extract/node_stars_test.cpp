// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nodes as vertices of the surfaces: double cones, whatever the mesh.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>

#include "../oracle/block_fields.hpp"
#include "fields.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

constexpr std::array<Feature, 2> kDegenerate = {Feature::DegenerateLinear,
                                                Feature::DegeneratePlanar};

ExtractionOptions degenerate_only(std::uint32_t max_bisections = 400) {
  ExtractionOptions options;
  options.features = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);
  options.max_bisections = max_bisections;
  return options;
}

/// The closed curves that the triangles around a vertex leave around it; -1 if they leave anything
/// else.
int circles_around(const FeatureMesh& mesh, std::uint32_t vertex) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> link;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] != vertex) continue;
      const std::uint32_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      link[a].push_back(b);
      link[b].push_back(a);
    }
  int circles = 0;
  std::map<std::uint32_t, bool> seen;
  for (const auto& [start, neighbours] : link) {
    if (neighbours.size() != 2) return -1;
    if (seen[start]) continue;
    ++circles;
    for (std::uint32_t at = start, last = start;;) {
      seen[at] = true;
      const auto& next = link[at];
      const std::uint32_t to = next[0] != last ? next[0] : next[1];
      last = at;
      at = to;
      if (at == start) break;
    }
  }
  return circles;
}

/// What the nodes of a feature make of its mesh, where it is certified.
void expect_double_cones(const Extraction& result, Feature f) {
  const FeatureMesh& mesh = test::mesh_of(result, f);
  const SurfaceTopology topology = surface_topology(mesh.triangles, mesh.points.size());
  EXPECT_EQ(topology.nonmanifold_edges, 0u);
  EXPECT_EQ(topology.orientation_conflicts, 0u);
  EXPECT_TRUE(std::ranges::is_sorted(mesh.nodes));
  std::size_t inside = 0;
  for (const Node& node : result.nodes) {
    if (node.feature != f) continue;
    ++inside;
    EXPECT_EQ(std::ranges::count_if(mesh.nodes,
                                    [&](std::uint32_t v) {
                                      const Point& x = mesh.points[v];
                                      return std::hypot(x[0] - node.position[0],
                                                        x[1] - node.position[1],
                                                        x[2] - node.position[2]) < 1e-9;
                                    }),
              1);
  }
  EXPECT_EQ(mesh.nodes.size(), inside);
  EXPECT_EQ(topology.nonmanifold_vertices, inside);
  for (const std::uint32_t v : mesh.nodes) EXPECT_EQ(circles_around(mesh, v), 2);
}

TEST(NodeStars, OneTetWithANodeIsCertifiedAndPinchedThere) {
  test::Random random(11);
  int certified = 0, with_nodes = 0;
  constexpr int kFields = 40;
  // Dyadic relations between these would put the node on a face that bisection makes.
  const test::Weights node = {0.3127, 0.1931, 0.1179, 0.3763};
  for (int n = 0; n < kFields; ++n) {
    const test::OneTet tet(test::planted_node(random, node, std::exp2(-n % 4)));
    const Extraction result = extract(tet.tensors(), degenerate_only());
    EXPECT_GE(result.nodes.size(), 1u);
    if (!result.unresolved.empty()) continue;
    ++certified;
    std::size_t nodes = 0;
    for (const Feature f : kDegenerate) {
      expect_double_cones(result, f);
      nodes += test::mesh_of(result, f).nodes.size();
    }
    EXPECT_EQ(nodes, result.nodes.size());
    EXPECT_GE(result.certificates.radial, 4 * nodes);
    with_nodes += nodes > 0;
  }
  EXPECT_GT(certified, kFields / 2);
  EXPECT_EQ(with_nodes, certified);
}

/// A linear field has one topology, whatever the mesh.
TEST(NodeStars, LinearFieldsHaveTheSameConesOnEveryMesh) {
  int compared = 0, with_nodes = 0;
  for (const std::uint64_t seed : {1u, 4u, 6u, 8u, 9u, 10u, 12u, 14u}) {
    std::array<std::optional<SurfaceTopology>, 2> first;
    std::array<std::size_t, 2> nodes{};
    for (const auto& [n, jitter] : {std::pair{1, 0.0}, {2, 0.2}, {3, 0.3}}) {
      GridOptions grid;
      grid.n = n;
      grid.jitter = jitter;
      grid.seed = seed;
      const Extraction result = extract(generate_random_linear(grid), degenerate_only());
      for (std::size_t i = 0; i < 2; ++i) {
        const Feature f = kDegenerate[i];
        if (!test::certified(result, f)) continue;
        expect_double_cones(result, f);
        const FeatureMesh& mesh = test::mesh_of(result, f);
        const SurfaceTopology topology = surface_topology(mesh.triangles, mesh.points.size());
        if (!first[i]) {
          first[i] = topology;
          nodes[i] = mesh.nodes.size();
          continue;
        }
        ++compared;
        with_nodes += !mesh.nodes.empty();
        EXPECT_EQ(topology.components, first[i]->components) << seed;
        EXPECT_EQ(topology.euler, first[i]->euler) << seed;
        EXPECT_EQ(topology.boundary_loops, first[i]->boundary_loops) << seed;
        EXPECT_EQ(mesh.nodes.size(), nodes[i]) << seed;
      }
    }
  }
  EXPECT_GT(compared, 20);
  EXPECT_GT(with_nodes, 5);
}

/// Lorenz has one node, on the planar surface; the surface is a cone over two circles there.
TEST(NodeStars, LorenzIsPinchedOnce) {
  GridOptions grid;
  grid.n = 5;
  grid.jitter = 0.2;
  const Extraction result = extract(generate_lorenz(grid), degenerate_only());
  ASSERT_TRUE(test::certified(result, Feature::DegeneratePlanar));
  const FeatureMesh& mesh = test::mesh_of(result, Feature::DegeneratePlanar);
  ASSERT_EQ(mesh.nodes.size(), 1u);
  const Point& x = mesh.points[mesh.nodes[0]];
  EXPECT_NEAR(x[0], 0, 1e-11);
  EXPECT_NEAR(x[1], 0, 1e-11);
  EXPECT_NEAR(x[2], 263.0 / 9, 1e-11);
  expect_double_cones(result, Feature::DegeneratePlanar);
  EXPECT_TRUE(test::mesh_of(result, Feature::DegenerateLinear).nodes.empty());
  EXPECT_GE(result.certificates.radial, 4u);
}

/// Nodes are found tet by tet, and their vertices and midpoints numbered as they come: neither
/// threads nor the order of points and tets in the file change the mesh.
TEST(NodeStars, NeitherNumberingNorThreadsMatter) {
  GridOptions grid;
  grid.n = 6;
  grid.jitter = 0.2;
  const TensorField field = generate_abc(grid);
  ExtractionOptions options = degenerate_only(48);
  options.threads = 2;
  const Extraction a = extract(field, options);
  options.threads = 1;
  const Extraction b = extract(field, options);
  const Extraction c = extract(test::relabelled(field, 99), options);
  EXPECT_GT(a.certificates.radial, 20u);
  for (const Extraction* other : {&b, &c}) {
    EXPECT_EQ(other->refinement.bisections, a.refinement.bisections);
    EXPECT_EQ(other->certificates.radial, a.certificates.radial);
    EXPECT_EQ(other->unresolved.size(), a.unresolved.size());
    for (const Feature f : kDegenerate) {
      EXPECT_TRUE(test::geometry(test::mesh_of(*other, f)) == test::geometry(test::mesh_of(a, f)));
      EXPECT_EQ(test::mesh_of(*other, f).nodes.size(), test::mesh_of(a, f).nodes.size());
    }
  }
  for (const Feature f : kDegenerate) {
    EXPECT_EQ(test::mesh_of(b, f).points, test::mesh_of(a, f).points);
    EXPECT_EQ(test::mesh_of(b, f).triangles, test::mesh_of(a, f).triangles);
    EXPECT_EQ(test::mesh_of(b, f).nodes, test::mesh_of(a, f).nodes);
  }
}

/// The surface at a node is the same with further pages around; and these are not drawn to the
/// node, also where they are open yet.
TEST(NodeStars, ModeSurfacesKeepClearOfNodes) {
  GridOptions grid;
  grid.n = 5;
  grid.jitter = 0.2;
  const TensorField field = generate_lorenz(grid);
  for (const std::uint32_t bisections : {10u, 20u, 400u}) {
    ExtractionOptions options = degenerate_only(bisections);
    options.features |= bit(options.table.add_mode({99, 100}, Sign::Negative, Sign::Negative));
    options.features |= bit(options.table.add_mode({101, 100}, Sign::Negative, Sign::Negative));
    const Extraction result = extract(field, options);
    ASSERT_EQ(result.features.size(), static_cast<std::size_t>(options.table.size()));
    for (std::size_t f = kStandardFeatures; f < result.features.size(); ++f) {
      EXPECT_FALSE(result.features[f].triangles.empty());
      EXPECT_TRUE(result.features[f].nodes.empty());
      for (const Point& x : result.features[f].points)
        EXPECT_GT(std::hypot(x[0], x[1], x[2] - 263.0 / 9), 1e-6);
    }
    if (bisections < 400) continue;
    ASSERT_TRUE(test::certified(result, Feature::DegeneratePlanar));
    expect_double_cones(result, Feature::DegeneratePlanar);
    for (std::size_t f = kStandardFeatures; f < result.features.size(); ++f)
      EXPECT_TRUE(test::certified(result, static_cast<Feature>(f)));
  }
}

/// A field without trace, and the traceless surface, which the perturbation moves to one side: at a
/// node only the corners of its tet can tell to which. (The tensors stay exact here.)
TEST(NodeStars, TheTracelessSurfaceOfAFieldWithoutTrace) {
  int with_star = 0;
  for (const int n : {3, 4, 5, 6}) {
    GridOptions grid;
    grid.n = n;
    grid.jitter = 0.2;
    TensorField field = generate_lorenz(grid, {.sigma = 8, .rho = 28, .beta = 3});
    for (Tensor<double>& t : field.tensors) {
      for (const std::size_t k : {0u, 4u, 8u}) t[k] += 4;
      ASSERT_EQ(t[0] + t[4] + t[8], 0);
    }
    ExtractionOptions options = degenerate_only(1000);
    const Extraction alone = extract(field, options);
    with_star += alone.certificates.radial > 0;
    options.features |= bit(options.table.add_traceless());
    std::optional<Extraction> result;
    ASSERT_NO_THROW(result = extract(field, options));
    EXPECT_EQ(result->certificates.radial, alone.certificates.radial);
    EXPECT_TRUE(result->features.back().triangles.empty());
    EXPECT_TRUE(test::certified(*result, static_cast<Feature>(result->features.size() - 1)));
  }
  EXPECT_GT(with_star, 1);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// No leaf that holds a proven node is certified for its surface: that is a double cone there, and
// no disc.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "linear_meshes.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

double determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
/// The least barycentric coordinate, rounded: positive inside.
double depth(const std::array<Point, 4>& tet, const Point& x) {
  std::array<Point, 4> from_x;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) from_x[i][k] = tet[i][k] - x[k];
  std::array<double, 4> volume;
  for (std::size_t i = 0; i < 4; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    volume[i] = sign * determinant(from_x[(i + 1) % 4], from_x[(i + 2) % 4], from_x[(i + 3) % 4]);
  }
  const double whole = volume[0] + volume[1] + volume[2] + volume[3];
  double least = volume[0] / whole;
  for (const double v : volume) least = std::min(least, v / whole);
  return least;
}

struct Count {
  std::size_t nodes = 0;    ///< proven, and clearly inside one leaf
  std::size_t claimed = 0;  ///< of these, in a leaf that is certified for the surface
  std::size_t planted = 0;  ///< that are vertices of the refined mesh
};

/// The nodes come from the unrefined mesh, where all that may hold one is searched.
void count_nodes_in_leaves(const TensorField& field, Count& count) {
  ExtractionOptions unrefined;
  unrefined.max_bisections = 0;
  const std::vector<Node> nodes = extract(field, unrefined).nodes;
  RefineOptions options;
  options.max_bisections = 256;
  const RefinedComplex complex = refine(field, options);
  for (const NodeVertex& node : complex.nodes) count.planted += node.planted;
  for (const Node& node : nodes) {
    if (node.status != NodeStatus::Proven) continue;
    for (const Leaf& leaf : complex.leaves) {
      if (leaf.input != node.tet) continue;
      std::array<Point, 4> corners;
      for (std::size_t i = 0; i < 4; ++i) corners[i] = complex.field.position(leaf.vertices[i]);
      if (!(depth(corners, node.position) > 1e-4)) continue;
      ++count.nodes;
      count.claimed += !contains(leaf.open, node.feature);
    }
  }
}

TEST(NodesInLeaves, AreNeverCertifiedAway) {
  Count count;
  std::mt19937_64 random(21);
  for (int n = 0; n < 300; ++n)
    count_nodes_in_leaves(test::LinearField(random, -2).on(test::one_tet()), count);
  GridOptions grid;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    grid.seed = seed;
    grid.n = 2;
    grid.jitter = 0.2;
    count_nodes_in_leaves(generate_random_linear(grid), count);
    grid.n = 1;
    grid.jitter = 0;
    count_nodes_in_leaves(generate_noise(grid), count);
  }
  for (const char* name : {"abc", "lorenz", "rayleigh-benard"})
    for (const double jitter : {0.0, 0.2}) {
      grid.n = 9;
      grid.jitter = jitter;
      count_nodes_in_leaves(generator_named(name)->generate(grid), count);
    }
  std::cout << count.nodes << " nodes inside leaves, " << count.planted << " planted\n";
  EXPECT_EQ(count.claimed, 0u);
  EXPECT_GE(count.nodes + count.planted, 350u);
  EXPECT_GE(count.planted, 200u);
}

}  // namespace
}  // namespace triplex

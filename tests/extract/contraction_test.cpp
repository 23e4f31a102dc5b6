// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with and without edges of the size of rounding: what contraction must not change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"
#include "triplex/verify/embedding.hpp"

namespace triplex {
namespace {

/// A flow with planes of symmetry on a regular grid, zero there up to rounding only, as
/// cos(pi / 2) is in doubles: sheets miss vertices by the size of rounding.
const TensorField& field() {
  static const TensorField f = [] {
    GridOptions grid;
    grid.n = 6;
    TensorField abc = generate_abc(grid);
    for (Tensor<double>& t : abc.tensors)
      for (const std::size_t k : {1u, 2u, 3u, 5u, 6u, 7u})
        if (t[k] == 0) t[k] = std::cos(std::numbers::pi / 2);
    return abc;
  }();
  return f;
}

Extraction extracted(bool contract, unsigned threads = 0) {
  ExtractionOptions options;
  options.max_bisections = 64;
  options.keep_tensors = true;
  options.contract = contract;
  options.threads = threads;
  return extract(field(), options);
}
const Extraction& raw() {
  static const Extraction e = extracted(false);
  return e;
}
const Extraction& contracted() {
  static const Extraction e = extracted(true);
  return e;
}

TEST(ContractedMeshes, EachFeatureKeepsItsTopology) {
  std::size_t before = 0, after = 0;
  for (std::size_t f = 0; f < raw().features.size(); ++f) {
    SCOPED_TRACE(f);
    const FeatureMesh &a = raw().features[f], &b = contracted().features[f];
    const SurfaceTopology s = surface_topology(a.triangles, a.points.size());
    const SurfaceTopology t = surface_topology(b.triangles, b.points.size());
    EXPECT_EQ(s.components, t.components);
    EXPECT_EQ(s.euler, t.euler);
    EXPECT_EQ(s.boundary_loops, t.boundary_loops);
    EXPECT_EQ(s.nonmanifold_edges, t.nonmanifold_edges);
    EXPECT_EQ(s.nonmanifold_vertices, t.nonmanifold_vertices);
    EXPECT_EQ(s.orientation_conflicts, t.orientation_conflicts);
    const CurveTopology c = curve_topology(a.segments, a.points.size());
    const CurveTopology d = curve_topology(b.segments, b.points.size());
    EXPECT_EQ(c.components, d.components);
    EXPECT_EQ(c.closed, d.closed);
    EXPECT_EQ(c.ends, d.ends);
    EXPECT_EQ(c.branches, d.branches);
    EXPECT_EQ(a.nodes.size(), b.nodes.size());
    before += a.triangles.size();
    after += b.triangles.size();
  }
  EXPECT_LT(after, before);
}

TEST(ContractedMeshes, VerticesAndCellsAreThoseOfBefore) {
  for (std::size_t f = 0; f < raw().features.size(); ++f) {
    SCOPED_TRACE(f);
    const FeatureMesh &a = raw().features[f], &b = contracted().features[f];
    EXPECT_LE(b.points.size(), a.points.size());
    EXPECT_TRUE(std::ranges::includes(std::set(a.points.begin(), a.points.end()),
                                      std::set(b.points.begin(), b.points.end())));
    EXPECT_EQ(b.source_cell.size(), b.triangles.size() + b.segments.size());
    EXPECT_EQ(b.certified.size(), b.source_cell.size());
    EXPECT_EQ(b.tensors.size(), b.points.size());
    std::vector<bool> used(b.points.size(), false);
    for (const auto& corners : b.triangles)
      for (const std::uint32_t v : corners) used[v] = true;
    for (const auto& ends : b.segments)
      for (const std::uint32_t v : ends) used[v] = true;
    EXPECT_EQ(std::ranges::count(used, false), 0);
    // By cell of the input, no triangles come in.
    std::multiset<std::int64_t> sources(a.source_cell.begin(), a.source_cell.end());
    EXPECT_TRUE(
        std::ranges::includes(sources, std::multiset(b.source_cell.begin(), b.source_cell.end())));
  }
  EXPECT_GT(contracted().contraction.vertices, 0u);
  EXPECT_LE(contracted().contraction.moved, contracted().contraction.reach);
  EXPECT_LT(contracted().contraction.reach, 1e-12);
  EXPECT_EQ(raw().contraction.vertices, 0u);
}

TEST(ContractedMeshes, FewerContacts) {
  const auto check = [](const Extraction& e) {
    EmbeddingOptions options;
    options.policy = CrossingPolicy(e.table);
    options.has_triple_curve = true;
    return check_embedding(join_features(e.features), options);
  };
  const EmbeddingResult before = check(raw()), after = check(contracted());
  EXPECT_GT(before.degenerate.size(), 0u);
  EXPECT_LT(8 * after.degenerate.size(), before.degenerate.size());
  EXPECT_LE(2 * after.contacts_within(), before.contacts_within());
  EXPECT_LE(after.contacts_between(), before.contacts_between());
}

TEST(ContractedMeshes, ThreadsChangeNothing) {
  const Extraction one = extracted(true, 1);
  for (std::size_t f = 0; f < one.features.size(); ++f) {
    EXPECT_EQ(one.features[f].points, contracted().features[f].points);
    EXPECT_EQ(one.features[f].triangles, contracted().features[f].triangles);
    EXPECT_EQ(one.features[f].segments, contracted().features[f].segments);
  }
}

TEST(ContractedMeshes, NothingToDoChangesNothing) {
  GridOptions grid;
  grid.n = 4;
  for (grid.seed = 1; grid.seed <= 3; ++grid.seed) {
    const TensorField random = generate_random_linear(grid);
    ExtractionOptions options;
    const Extraction a = extract(random, options);
    options.contract = false;
    const Extraction b = extract(random, options);
    EXPECT_EQ(a.contraction.vertices, 0u);
    for (std::size_t f = 0; f < a.features.size(); ++f)
      EXPECT_EQ(a.features[f].triangles, b.features[f].triangles);
  }
}

TEST(ContractedMeshes, PeriodicSidesAreLeftAlone) {
  ExtractionOptions options;
  options.max_bisections = 16;
  options.periodic = {true, true, true};
  GridOptions grid;
  grid.n = 4;
  TensorField torus = generate_abc(grid);
  make_periodic(torus, grid.n, options.periodic);
  EXPECT_EQ(extract(torus, options).contraction.vertices, 0u);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/node.hpp"

#include <gtest/gtest.h>

#include "../oracle/random_tensors.hpp"
#include "triplex/tensor/eigenspace.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

using oracle::Kind;

constexpr FeatureSet kBoth = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

bool is_node_tensor(const Tensor<double>& t) {
  Tensor<Exact> exact;
  for (std::size_t k = 0; k < 9; ++k) exact[k] = Exact(t[k]);
  return is_node(triple_deviator(exact));
}

TEST(IsNode, AgreesWithTheDimensionOfTheEigenspace) {
  oracle::Random random(1);
  int nodes = 0;
  for (int n = 0; n < 20000; ++n) {
    const Tensor<double> t = oracle::degenerate_tensor(random);
    const bool expected =
        repeating_eigenspace_dimension(t) == 2 && invariants(t, 1.0).sign_p == Sign::Negative;
    ASSERT_EQ(is_node_tensor(t), expected);
    nodes += expected;
  }
  EXPECT_GT(nodes, 500);
}

/// One tet with integer tensors whose combination with the given weights is a node.
struct Planted {
  TensorField field;
  std::array<std::int64_t, 4> weights;
  Tensor<double> node;
};
Planted plant(oracle::Random& random, std::array<std::int64_t, 3> weights) {
  Planted p;
  p.weights = {weights[0], weights[1], weights[2], 1};
  do p.node = oracle::degenerate_tensor(random, Kind::Derogatory);
  while (!is_node_tensor(p.node));
  p.field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  p.field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  p.field.tensors.resize(4);
  double sum = 1;
  for (const std::int64_t w : weights) sum += static_cast<double>(w);
  for (std::size_t k = 0; k < 9; ++k) p.field.tensors[3][k] = sum * p.node[k];
  for (std::size_t i = 0; i < 3; ++i) {
    p.field.tensors[i] = oracle::integer_tensor(random, 9);
    for (std::size_t k = 0; k < 9; ++k)
      p.field.tensors[3][k] -= static_cast<double>(weights[i]) * p.field.tensors[i][k];
  }
  return p;
}

/// Planted nodes are known as fractions, so what the enclosures hold is too.
TEST(EnclosedWeights, HoldTheNodeNarrowly) {
  oracle::Random random(7);
  int enclosed = 0;
  for (int n = 0; n < 100; ++n) {
    const Planted p = plant(random, {5 + n % 3, 3, 7});
    const RefinableField field(p.field);
    const auto vertex = field.vertices_of_input();
    const std::array<VertexId, 4> tet = {vertex[0], vertex[1], vertex[2], vertex[3]};
    for (const IsolatedNode& node : isolate_nodes(field, tet, kBoth).nodes) {
      if (exact_weights(field, tet, node) != p.weights) continue;
      ++enclosed;
      const auto x = enclosed_weights(field, tet, node);
      std::int64_t sum = 0;
      for (const std::int64_t w : p.weights) sum += w;
      const auto scaled_sum = ExactRange(static_cast<double>(sum));
      for (std::size_t i = 0; i < 4; ++i) {
        const Exact w(static_cast<double>(p.weights[i]));
        const ExactRange scaled = scaled_sum * x[i];
        EXPECT_NE(sign(w - scaled.lo), Sign::Negative);
        EXPECT_NE(sign(scaled.hi - w), Sign::Negative);
        EXPECT_EQ(sign(x[i].hi - x[i].lo - Exact(0x1p-200)), Sign::Negative);
      }
    }
  }
  EXPECT_GT(enclosed, 60);
}

/// Where the search claims to be complete, the planted node is there: within its box, and nowhere
/// else. Its vertices are numbered by coordinates, so the file's order is mapped first.
TEST(IsolateNodes, FindsPlantedNodesInsideOnFacesEdgesAndVertices) {
  oracle::Random random(2);
  const std::array<std::array<std::int64_t, 3>, 7> all_weights = {
      {{1, 1, 1}, {5, 3, 7}, {1, 1, 0}, {0, 2, 1}, {3, 0, 0}, {0, 0, 6}, {0, 0, 0}}};
  int complete = 0, exact = 0;
  constexpr int kFields = 60;
  for (const auto& weights : all_weights)
    for (int n = 0; n < kFields; ++n) {
      const Planted p = plant(random, weights);
      const RefinableField field(p.field);
      const auto vertex = field.vertices_of_input();
      const std::array<VertexId, 4> tet = {vertex[0], vertex[1], vertex[2], vertex[3]};
      const TetNodes found = isolate_nodes(field, tet, kBoth);
      double sum = 0;
      for (const std::int64_t w : p.weights) sum += static_cast<double>(w);
      int hits = 0;
      for (const IsolatedNode& node : found.nodes) {
        bool hit = true;
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = static_cast<double>(p.weights[k + 1]) / sum;
          hit &= node.box[k].lo - 1e-15 <= x && x <= node.box[k].hi + 1e-15;
          EXPECT_TRUE(node.domain[k].contains(node.box[k]));
        }
        hits += hit;
        if (hit) exact += exact_weights(field, tet, node) == p.weights;
      }
      EXPECT_LE(hits, 1);
      EXPECT_LE(found.nodes.size(), 6u);
      if (found.obstacle != NodeObstacle::None) continue;
      ++complete;
      EXPECT_EQ(hits, 1) << "weights " << weights[0] << weights[1] << weights[2] << ", " << n;
    }
  // Few planted nodes are degenerate by chance.
  EXPECT_GT(complete, static_cast<int>(all_weights.size()) * kFields * 9 / 10);
  EXPECT_GE(exact, complete);
}

TEST(IsolateNodes, NeverClaimsACurve) {
  // Symmetric tensors, and a field that does not change along one edge.
  oracle::Random random(3);
  for (int n = 0; n < 50; ++n) {
    Planted p = plant(random, {1, 1, 1});
    p.field.tensors[0] = p.field.tensors[1] = oracle::integer_tensor(random, 9);
    for (std::size_t k = 0; k < 9; ++k)
      p.field.tensors[3][k] = 4 * p.node[k] - 2 * p.field.tensors[0][k] - p.field.tensors[2][k];
    const RefinableField field(p.field);
    const TetNodes found = isolate_nodes(field, field.input_tets()[0], kBoth);
    EXPECT_TRUE(found.nodes.empty());
    EXPECT_NE(found.obstacle, NodeObstacle::None);
  }
}

}  // namespace
}  // namespace triplex

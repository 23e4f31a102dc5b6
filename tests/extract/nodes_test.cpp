// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nodes of fields with known answers, and the laws that the search obeys.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../oracle/rational_oracle.hpp"
#include "fields.hpp"
#include "newton_oracle.hpp"
#include "triplex/arithmetic/fp_environment.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kDegenerate = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

Extraction extract_degenerate(const TensorField& field, unsigned threads = 0) {
  ExtractionOptions options;
  options.features = kDegenerate;
  options.threads = threads;
  options.max_bisections = 4;  // the search does not need small leaves
  return extract(field, options);
}

GridOptions grid(int n, double jitter = 0, CellSplit split = CellSplit::Six,
                 std::uint64_t seed = 7) {
  GridOptions options;
  options.n = n;
  options.jitter = jitter;
  options.split = split;
  options.seed = seed;
  return options;
}

/// |A^2 + l A - 2 l^2 I| / |A|^2 at a point of a tet, in rational arithmetic: zero at a node.
double residual(const TensorField& field, const Node& node) {
  const auto& tet = field.mesh.tets[index(node.tet)];
  std::array<std::array<mpq_class, 3>, 4> x;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) x[i][k] = mpq_class(field.mesh.points[index(tet[i])][k]);
  const std::array<mpq_class, 3> point = {mpq_class(node.position[0]), mpq_class(node.position[1]),
                                          mpq_class(node.position[2])};
  const auto volume = [](const auto& a, const auto& b, const auto& c, const auto& d) {
    std::array<std::array<mpq_class, 3>, 3> e;
    for (std::size_t k = 0; k < 3; ++k) e[k] = {b[k] - a[k], c[k] - a[k], d[k] - a[k]};
    return mpq_class(e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                     e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                     e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]));
  };
  const mpq_class whole = volume(x[0], x[1], x[2], x[3]);
  Tensor<mpq_class> a;
  for (std::size_t i = 0; i < 4; ++i) {
    auto part = x;
    part[i] = point;
    const mpq_class weight = volume(part[0], part[1], part[2], part[3]) / whole;
    for (std::size_t k = 0; k < 9; ++k) a[k] += weight * mpq_class(field.tensors[index(tet[i])][k]);
  }
  const mpq_class mean = (a[0] + a[4] + a[8]) / 3;
  for (const std::size_t k : {0u, 4u, 8u}) a[k] -= mean;
  const mpq_class l(node.eigenvalue);
  mpq_class worst = 0, size = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      mpq_class r = l * a[3 * i + j];
      for (std::size_t k = 0; k < 3; ++k) r += a[3 * i + k] * a[3 * k + j];
      if (i == j) r -= 2 * l * l;
      worst = std::max(worst, mpq_class(abs(r)));
      size = std::max(size, mpq_class(a[3 * i + j] * a[3 * i + j]));
    }
  return mpq_class(worst / size).get_d();
}

void expect_sound(const TensorField& field, const Extraction& result) {
  for (const Node& node : result.nodes) {
    EXPECT_LT(residual(field, node), 1e-10);
    EXPECT_TRUE(node.eigenvalue_enclosure.contains(node.eigenvalue));
    EXPECT_EQ(node.feature == Feature::DegeneratePlanar, node.eigenvalue > 0);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(node.enclosure[k].contains(node.position[k]));
      EXPECT_LT(node.enclosure[k].hi - node.enclosure[k].lo, 1e-8);
    }
  }
}

class LorenzNode : public testing::TestWithParam<GridOptions> {};

TEST_P(LorenzNode, IsFoundOnceWhereTheClosedFormSays) {
  const TensorField field = generate_lorenz(GetParam());
  const Extraction result = extract_degenerate(field);
  ASSERT_EQ(result.nodes.size(), 1u);
  EXPECT_TRUE(result.nodes_undecided.empty());
  expect_sound(field, result);
  const Node& node = result.nodes[0];
  EXPECT_EQ(node.feature, Feature::DegeneratePlanar);
  EXPECT_NEAR(node.eigenvalue, 17.0 / 9, 1e-12);
  // The tensors are rounded, so the node of the data is off by some roundings.
  const Point exact = {0, 0, 263.0 / 9};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GE(exact[k], node.enclosure[k].lo - 1e-11);
    EXPECT_LE(exact[k], node.enclosure[k].hi + 1e-11);
  }
  // The axis x = y = 0 consists of edges if n is even, and of nothing in the jittered meshes.
  if (GetParam().jitter > 0) {
    EXPECT_EQ(node.status, NodeStatus::Proven);
  } else {
    EXPECT_NE(node.status, NodeStatus::Vertex);
  }
}
INSTANTIATE_TEST_SUITE_P(Meshes, LorenzNode,
                         testing::Values(grid(5), grid(5, 0.2), grid(8), grid(8, 0.1),
                                         grid(8, 0.2, CellSplit::Five), grid(8, 0, CellSplit::Five),
                                         grid(13), grid(13, 0.1, CellSplit::Five)));

struct ExactCase {
  Box box;
  NodeStatus status;
};
class ExactLorenzNode : public testing::TestWithParam<ExactCase> {};

/// With sigma 8, rho 28, beta 3 the node is exactly (0, 0, 29.25), with eigenvalue 1.
TEST_P(ExactLorenzNode, IsFoundOnVerticesEdgesFacesAndInside) {
  for (const CellSplit split : {CellSplit::Five, CellSplit::Six}) {
    GridOptions options = grid(2, 0, split);
    options.box = GetParam().box;
    const TensorField field = generate_lorenz(options, {.sigma = 8, .rho = 28, .beta = 3});
    const Extraction result = extract_degenerate(field);
    ASSERT_EQ(result.nodes.size(), 1u);
    EXPECT_TRUE(result.nodes_undecided.empty());
    const Node& node = result.nodes[0];
    EXPECT_EQ(node.status, GetParam().status) << name_of(node.status);
    const Point exact = {0, 0, 29.25};
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(node.enclosure[k].contains(exact[k])) << k;
      EXPECT_NEAR(node.position[k], exact[k], 1e-13);
    }
    EXPECT_TRUE(node.eigenvalue_enclosure.contains(1.0));
    EXPECT_NEAR(node.eigenvalue, 1, 1e-14);
    EXPECT_EQ(node.feature, Feature::DegeneratePlanar);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Boxes, ExactLorenzNode,
    testing::Values(ExactCase{{{-1, -1, 28.25}, {1, 1, 30.25}}, NodeStatus::Vertex},
                    ExactCase{{{-1, -1, 28.75}, {1, 1, 30.75}}, NodeStatus::Face},
                    ExactCase{{{-1, -1, 28.5}, {1, 1, 31.5}}, NodeStatus::Face},
                    ExactCase{{{-1, -1.25, 28.5}, {1, 0.75, 31.5}}, NodeStatus::Face},
                    ExactCase{{{-1.125, -1.25, 28.5}, {0.875, 0.75, 31.5}}, NodeStatus::Proven}));

TEST(AbcNodes, FourOnEachSurface) {
  const TensorField field = generate_abc(grid(32, 0.2));
  const Extraction result = extract_degenerate(field);
  EXPECT_TRUE(result.nodes_undecided.empty());
  expect_sound(field, result);
  const auto linear = std::ranges::count(result.nodes, Feature::DegenerateLinear, &Node::feature);
  EXPECT_EQ(linear, 4);
  EXPECT_EQ(result.nodes.size(), 8u);
  for (const Node& node : result.nodes) EXPECT_EQ(node.status, NodeStatus::Proven);
  // With so few bisections no node becomes a vertex, and its tet says so.
  for (const Node& node : result.nodes) {
    const auto tet =
        std::ranges::find(result.unresolved, node.source_cell, &UnresolvedTet::source_cell);
    ASSERT_NE(tet, result.unresolved.end());
    EXPECT_NE(tet->reason.find("contains a node"), std::string::npos);
  }
}

/// Tets without open leaves hold no node: searching all of them finds the same.
TEST(NoiseNodes, AreThoseOfAllTets) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const TensorField field = generate_noise(grid(4, 0.2, CellSplit::Five, seed));
    ExtractionOptions options;
    options.max_bisections = 24;
    const Extraction result = extract(field, options);
    EXPECT_LE(result.nodes_undecided.size(), 2u);  // very skewed tets may spend the budget
    expect_sound(field, result);
    const std::size_t closed = field.mesh.tets.size() - result.unresolved.size();
    std::size_t inside = 0;
    const RefinableField refinable(field);
    with_fp_environment([&] {
      for (const auto& tet : refinable.input_tets())
        for (const IsolatedNode& node : isolate_nodes(refinable, tet, kDegenerate).nodes)
          inside +=
              node.first.lo > 0 && node.box[0].lo > 0 && node.box[1].lo > 0 && node.box[2].lo > 0;
    });
    EXPECT_EQ(result.nodes.size(), inside);
    EXPECT_GT(inside, 50u);
    EXPECT_GT(closed, 5u);
  }
}

/// The nodes of a linear field do not depend on the mesh, and are those of the oracle.
TEST(RandomLinearFields, HaveTheNodesOfTheOracleOnEveryMesh) {
  std::size_t total = 0, most = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto expected =
        oracle::nodes_of_linear_field(generate_random_linear(grid(1, 0, CellSplit::Six, seed)));
    total += expected.size();
    most = std::max(most, expected.size());
    for (const GridOptions& mesh :
         {grid(1, 0, CellSplit::Six, seed), grid(2, 0, CellSplit::Five, seed),
          grid(4, 0.3, CellSplit::Six, seed)}) {
      const TensorField field = generate_random_linear(mesh);
      const Extraction result = extract_degenerate(field);
      EXPECT_TRUE(result.nodes_undecided.empty());
      expect_sound(field, result);
      ASSERT_EQ(result.nodes.size(), expected.size()) << "seed " << seed << ", n " << mesh.n;
      for (std::size_t n = 0; n < expected.size(); ++n)
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(result.nodes[n].position[k], expected[n][k], 1e-9);
    }
  }
  EXPECT_GT(total, 20u);
  EXPECT_LE(most, 6u);
}

class Laws : public testing::Test {
 protected:
  Laws() : field_(generate_random_linear(grid(2, 0.3, CellSplit::Six, seed_with_nodes()))) {
    nodes_ = extract_degenerate(field_).nodes;
  }
  static std::uint64_t seed_with_nodes() {
    for (std::uint64_t seed = 1;; ++seed)
      if (oracle::nodes_of_linear_field(generate_random_linear(grid(1, 0, CellSplit::Six, seed)))
              .size() >= 2)
        return seed;
  }
  TensorField field_;
  std::vector<Node> nodes_;
};

TEST_F(Laws, ScalingByAPowerOfTwoScalesEigenvaluesOnly) {
  ASSERT_GE(nodes_.size(), 2u);
  for (const int exponent : {-300, 5, 200}) {
    const auto scaled = extract_degenerate(test::mapped(field_, [&](Tensor<double> t) {
                          for (double& x : t) x = std::ldexp(x, exponent);
                          return t;
                        })).nodes;
    ASSERT_EQ(scaled.size(), nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      EXPECT_EQ(scaled[n].enclosure, nodes_[n].enclosure);
      EXPECT_EQ(scaled[n].eigenvalue, std::ldexp(nodes_[n].eigenvalue, exponent));
    }
  }
}

TEST_F(Laws, NegationSwapsLinearAndPlanarAndTranspositionChangesNothing) {
  const auto negated = extract_degenerate(test::mapped(field_, test::negated)).nodes;
  const auto transposed = extract_degenerate(test::mapped(field_, test::transposed)).nodes;
  ASSERT_EQ(negated.size(), nodes_.size());
  ASSERT_EQ(transposed.size(), nodes_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    EXPECT_NE(negated[n].feature, nodes_[n].feature);
    EXPECT_EQ(transposed[n].feature, nodes_[n].feature);
    EXPECT_TRUE(negated[n].eigenvalue_enclosure.meets(
        {-nodes_[n].eigenvalue_enclosure.hi, -nodes_[n].eigenvalue_enclosure.lo}));
    EXPECT_TRUE(transposed[n].eigenvalue_enclosure.meets(nodes_[n].eigenvalue_enclosure));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(negated[n].enclosure[k].meets(nodes_[n].enclosure[k]));
      EXPECT_TRUE(transposed[n].enclosure[k].meets(nodes_[n].enclosure[k]));
    }
  }
}

TEST_F(Laws, NeitherNumberingNorThreadsMatter) {
  const auto compare = [&](const std::vector<Node>& other) {
    ASSERT_EQ(other.size(), nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      EXPECT_EQ(other[n].position, nodes_[n].position);
      EXPECT_EQ(other[n].enclosure, nodes_[n].enclosure);
      EXPECT_EQ(other[n].eigenvalue_enclosure, nodes_[n].eigenvalue_enclosure);
      EXPECT_EQ(other[n].status, nodes_[n].status);
    }
  };
  compare(extract_degenerate(test::relabelled(field_, 3)).nodes);
  compare(extract_degenerate(field_, 1).nodes);
  compare(extract_degenerate(field_, 3).nodes);
}

TEST_F(Laws, OnlyTheSurfacesAskedForAreSearched) {
  ExtractionOptions options;
  options.features = bit(Feature::NeutralReal) | bit(Feature::TripleCurve);
  EXPECT_TRUE(extract(field_, options).nodes.empty());
  for (const Feature f : {Feature::DegenerateLinear, Feature::DegeneratePlanar}) {
    options.features = bit(f);
    const auto some = extract(field_, options).nodes;
    EXPECT_EQ(static_cast<std::ptrdiff_t>(some.size()),
              std::ranges::count(nodes_, f, &Node::feature));
  }
}

TEST(FieldsWithoutIsolatedNodes, ClaimNone) {
  const Extraction constant = extract_degenerate(generate_constant(grid(3)));
  EXPECT_TRUE(constant.nodes.empty());
  EXPECT_TRUE(constant.nodes_undecided.empty());

  const Extraction derogatory =
      extract_degenerate(generate_constant(grid(2), {1, 0, 0, 0, 1, 3, 0, 0, -2}));
  EXPECT_TRUE(derogatory.nodes.empty());
  EXPECT_EQ(derogatory.nodes_undecided.size(), 48u);

  // Where all tensors are symmetric, the degenerate features are curves, and nothing is a node.
  const Extraction symmetric = extract_degenerate(generate_symmetric(grid(2)));
  EXPECT_TRUE(symmetric.nodes.empty());
  EXPECT_TRUE(symmetric.nodes_undecided.empty());
  // Tets of symmetric tensors in a field of others are undecided.
  TensorField mixed = generate_symmetric(grid(2));
  mixed.tensors.back()[1] += 1;
  const Extraction some = extract_degenerate(mixed);
  EXPECT_FALSE(some.nodes_undecided.empty());
  EXPECT_GT(
      std::ranges::count(some.nodes_undecided, NodeObstacle::Symmetric, &NodesUndecided::obstacle),
      0);

  // diag(x, -x + 1, -1) up to a shear that depends on y: nodes along a line of the plane x = 1/2.
  GridOptions options = grid(2, 0.2);
  const TensorField mesh = generate_constant(options);
  TensorField line = mesh;
  for (std::size_t v = 0; v < line.tensors.size(); ++v) {
    const Point& x = line.mesh.points[v];
    line.tensors[v] = {x[0], x[1] - 0.5, 0, 0, 1 - x[0], 0, 0, 0, -1};
  }
  const Extraction curve = extract_degenerate(line);
  EXPECT_TRUE(curve.nodes.empty());
  EXPECT_FALSE(curve.nodes_undecided.empty());
  for (const NodesUndecided& tet : curve.nodes_undecided)
    EXPECT_EQ(tet.obstacle, NodeObstacle::Resolution) << describe(tet.obstacle);
}

}  // namespace
}  // namespace triplex

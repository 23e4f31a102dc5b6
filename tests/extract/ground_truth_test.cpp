// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields whose answer is known by another way: closed forms, and one linear field on many meshes.
#include <gtest/gtest.h>

#include <cmath>

#include "fields.hpp"
#include "topology.hpp"

namespace triplex {
namespace {

using test::mesh_of;
using test::Topology;
using test::topology_of;

/// Closed forms of the Lorenz system's deviator, sigma 10, rho 28, beta 8/3.
double lorenz_p(const Point& x) { return x[0] * x[0] + 10 * x[2] - 8179.0 / 27; }
double lorenz_q(const Point& x) {
  return -49.0 / 9 * x[0] * x[0] - 10 * x[0] * x[1] + 170.0 / 9 * x[2] - 412216.0 / 729;
}
/// Sizes of the terms, for tolerances relative to what cancels.
double lorenz_p_size(const Point& x) { return x[0] * x[0] + 10 * std::fabs(x[2]) + 303; }
double lorenz_q_size(const Point& x) {
  return 6 * x[0] * x[0] + 10 * std::fabs(x[0] * x[1]) + 19 * std::fabs(x[2]) + 566;
}
constexpr double kRounding = 1e-12;

class LorenzTest : public testing::TestWithParam<GridOptions> {
 protected:
  TensorField field_ = generate_lorenz(GetParam());
  Extraction result_ = extract(field_);
};

TEST_P(LorenzTest, VerticesSatisfyTheClosedForms) {
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
    ASSERT_FALSE(mesh_of(result_, f).points.empty());
    for (const Point& x : mesh_of(result_, f).points)
      EXPECT_LE(std::fabs(lorenz_p(x)), kRounding * lorenz_p_size(x));
  }
  for (const Feature f : {Feature::NeutralReal, Feature::NeutralComplex}) {
    ASSERT_FALSE(mesh_of(result_, f).points.empty());
    for (const Point& x : mesh_of(result_, f).points)
      EXPECT_LE(std::fabs(lorenz_q(x)), kRounding * lorenz_q_size(x));
  }
  for (const Feature f : {Feature::DegenerateLinear, Feature::DegeneratePlanar}) {
    ASSERT_FALSE(mesh_of(result_, f).points.empty());
    for (const Point& x : mesh_of(result_, f).points) {
      const double p = lorenz_p(x), q = lorenz_q(x);
      const double P = lorenz_p_size(x), Q = lorenz_q_size(x);
      EXPECT_LE(std::fabs(-4 * p * p * p - 27 * q * q),
                kRounding * (12 * p * p * P + 54 * std::fabs(q) * Q) +
                    kRounding * kRounding * P * P * P + 27 * kRounding * kRounding * Q * Q);
    }
  }
}

TEST_P(LorenzTest, LabelsAreThoseOfTheClosedForms) {
  for (int f = 0; f < kStandardPages; ++f) {
    const FeatureRow& r = standard_features().rows()[f];
    for (const Point& x : result_.features[f].points) {
      const double p = lorenz_p(x) / lorenz_p_size(x), q = lorenz_q(x) / lorenz_q_size(x);
      // Vertices on the spine have both zero to rounding; others have the page's signs.
      EXPECT_GE(p * static_cast<int>(r.sign_p), -kRounding) << r.name;
      EXPECT_GE(q * static_cast<int>(r.sign_q), -kRounding) << r.name;
    }
  }
}

TEST_P(LorenzTest, TripleCurveHasTwoBranchesOnTheClosedForm) {
  const FeatureMesh& curve = mesh_of(result_, Feature::TripleCurve);
  for (const Point& x : curve.points) {
    const double z = (8179.0 / 27 - x[0] * x[0]) / 10;
    const double y = (std::pow(17.0 / 9, 3) - 22.0 / 3 * x[0] * x[0]) / (10 * x[0]);
    EXPECT_NEAR(x[2], z, 1e-9);
    EXPECT_NEAR(x[1], y, 1e-9 * (1 + 100 / std::fabs(x[0])));
  }
  const CurveTopology topology = curve_topology(curve.segments, curve.points.size());
  EXPECT_EQ(topology.components, 2u);
  EXPECT_EQ(topology.closed, 0u);
  EXPECT_EQ(topology.branches, 0u);
}

TEST_P(LorenzTest, OnlyTheNodeIsOpenOnAGenericMesh) {
  // An odd n keeps the plane of symmetry x = 0, where the surface touches the edges of a grid, out.
  ASSERT_EQ(GetParam().n % 2, 1);
  for (const UnresolvedTet& tet : result_.unresolved) {
    Point centre{};
    for (const VertexId v : field_.mesh.tets[static_cast<std::size_t>(tet.source_cell)])
      for (int k = 0; k < 3; ++k) centre[k] += field_.mesh.points[index(v)][k] / 4;
    const double spacing = 60.0 / GetParam().n;
    const double distance = std::hypot(centre[0], centre[1], centre[2] - 263.0 / 9);
    EXPECT_LT(distance, 3 * spacing) << "tet " << tet.source_cell << ": " << tet.reason;
    EXPECT_TRUE(tet.features & bit(Feature::DegeneratePlanar));
  }
}

GridOptions lorenz_grid(int n, double jitter, CellSplit split) {
  GridOptions options;
  options.n = n;
  options.jitter = jitter;
  options.split = split;
  options.seed = 7;
  return options;
}
INSTANTIATE_TEST_SUITE_P(Meshes, LorenzTest,
                         testing::Values(lorenz_grid(9, 0, CellSplit::Six),
                                         lorenz_grid(11, 0.2, CellSplit::Six),
                                         lorenz_grid(13, 0.1, CellSplit::Five),
                                         lorenz_grid(17, 0.15, CellSplit::Six)));

/// A linear field has one answer whatever the mesh: wherever a feature is certified throughout on
/// two meshes, its topology is the same on both.
TEST(SameFieldOnOtherMeshes, HasTheSameTopology) {
  struct MeshKind {
    int n;
    double jitter;
    CellSplit split;
  };
  const std::array<MeshKind, 5> kinds = {{{1, 0, CellSplit::Six},
                                          {2, 0, CellSplit::Five},
                                          {4, 0, CellSplit::Six},
                                          {4, 0.3, CellSplit::Six},
                                          {8, 0.2, CellSplit::Five}}};
  constexpr std::uint64_t kFields = 60;
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= kFields; ++seed) {
    std::array<std::optional<Topology>, kStandardFeatures> known;
    for (const MeshKind& kind : kinds) {
      GridOptions grid;
      grid.n = kind.n;
      grid.jitter = kind.jitter;
      grid.split = kind.split;
      grid.seed = seed;
      ExtractionOptions options;
      options.max_bisections = 48;
      const Extraction result = extract(generate_random_linear(grid), options);
      for (int f = 0; f < kStandardFeatures; ++f) {
        if (!test::certified(result, static_cast<Feature>(f))) continue;
        const Topology t = topology_of(result.features[f]);
        if (known[f]) {
          EXPECT_EQ(*known[f], t) << standard_features().rows()[f].name << ", seed " << seed
                                  << ", n " << kind.n;
          ++compared;
        }
        known[f] = t;
      }
    }
  }
  // Nodes leave the degenerate pages of most fields open; the rest must really be compared.
  EXPECT_GT(compared, static_cast<int>(kFields) * 8);
}

/// What else is asked for does not change the answer: a feature certified on its own, or with
/// another, has the topology that it has among all.
TEST(SubsetsOfFeatures, AgreeWithAll) {
  std::vector<FeatureSet> subsets;
  for (int f = 0; f < kStandardFeatures; ++f) {
    const FeatureSet one = bit(static_cast<Feature>(f));
    subsets.push_back(one);
    subsets.push_back(one | bit(Feature::TripleCurve));
    subsets.push_back(one | bit(static_cast<Feature>((f + 2) % kStandardPages)));
  }
  int compared = 0;
  for (std::uint64_t seed = 101; seed < 121; ++seed) {
    GridOptions grid;
    grid.n = 2;
    grid.seed = seed;
    const TensorField field = generate_random_linear(grid);
    const Extraction all = extract(field);
    for (const FeatureSet subset : subsets) {
      ExtractionOptions options;
      options.features = subset;
      const Extraction some = extract(field, options);
      for (int f = 0; f < kStandardFeatures; ++f) {
        const auto feature = static_cast<Feature>(f);
        if (!contains(subset, feature) || !test::certified(all, feature)) continue;
        if (!test::certified(some, feature)) continue;
        EXPECT_EQ(topology_of(all.features[f]), topology_of(some.features[f]))
            << standard_features().rows()[f].name << ", seed " << seed << ", subset " << subset;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace triplex

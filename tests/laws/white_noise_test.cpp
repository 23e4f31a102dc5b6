// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Independent random tensors at the vertices: every tet holds pieces of everything, and nodes.
// Nothing is left unresolved with enough bisections, and what is certified does not depend on how
// it was refined.
#include <gtest/gtest.h>

#include "../extract/fields.hpp"
#include "../extract/topology.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

using test::mesh_of;
using test::topology_of;

class WhiteNoise : public testing::TestWithParam<std::uint64_t> {
 protected:
  WhiteNoise() {
    GridOptions grid;
    grid.n = 2;
    grid.seed = GetParam();
    field_ = generate_noise(grid);
    options_.max_bisections = 16384;
  }

  TensorField field_;
  ExtractionOptions options_;
};

TEST_P(WhiteNoise, HasTheSameTopologyWhicheverFeaturesRefineTheMesh) {
  const Extraction all = extract(field_, options_);
  ASSERT_TRUE(all.certified());
  EXPECT_GT(all.nodes.size(), 0u);
  for (const FeatureRow& row : standard_features().rows()) {
    options_.features = bit(row.feature);
    const Extraction one = extract(field_, options_);
    EXPECT_TRUE(one.certified()) << row.name;
    EXPECT_LT(one.refinement.tets, all.refinement.tets);
    EXPECT_EQ(topology_of(mesh_of(one, row.feature)), topology_of(mesh_of(all, row.feature)))
        << row.name;
  }
}

/// A transposed tensor has the same eigenvalues; a negative one has those negated, which exchanges
/// linear and planar.
TEST_P(WhiteNoise, TransposedAndNegatedHasTheSameTopology) {
  const Extraction all = extract(field_, options_);
  const Extraction other =
      extract(test::mapped(test::mapped(field_, test::transposed), test::negated), options_);
  ASSERT_TRUE(all.certified());
  ASSERT_TRUE(other.certified());
  EXPECT_EQ(all.nodes.size(), other.nodes.size());
  for (const FeatureRow& row : standard_features().rows())
    EXPECT_EQ(topology_of(mesh_of(all, row.feature)),
              topology_of(mesh_of(other, test::of_negative(row.feature))))
        << row.name;
}

INSTANTIATE_TEST_SUITE_P(Seeds, WhiteNoise, testing::Values(1, 2, 3));

}  // namespace
}  // namespace triplex

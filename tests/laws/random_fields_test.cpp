// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random linear fields are in general position, so refinement ends: nothing is left unresolved
// with the budget that small fields have.
#include <gtest/gtest.h>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

TEST(RandomFields, OnOneTetAreResolved) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    EXPECT_TRUE(extract(generate_noise_on_tet(seed)).certified()) << seed;
}

/// Leaves that become flat along an edge that is never cut; midpoints of edges at nodes too close
/// to the cone for doubles; nodes in leaves too small for doubles; narrow cones.
TEST(RandomFields, ThatWereHardAreResolved) {
  for (const std::uint64_t seed :
       {73, 81, 92, 154, 177, 346, 377, 784, 829, 865, 1856, 2117, 3043, 4028, 4445, 4543})
    EXPECT_TRUE(extract(generate_noise_on_tet(seed)).certified()) << seed;
}

TEST(RandomFields, OnACubeAreResolved) {
  for (std::uint64_t seed = 25; seed <= 36; ++seed) {
    GridOptions grid;
    grid.n = 1;
    grid.seed = seed;
    EXPECT_TRUE(extract(generate_random_linear(grid)).certified()) << seed;
  }
}

TEST(DefaultBudget, IsSharedByFewTets) {
  EXPECT_EQ(default_budget(1), 65536u);
  EXPECT_EQ(default_budget(6), 65536u / 6);
  EXPECT_EQ(default_budget(64), 1024u);
  EXPECT_EQ(default_budget(1'500'000), 1024u);
  GridOptions grid;
  grid.n = 1;
  EXPECT_EQ(extract(generate_random_linear(grid)).refinement.max_bisections, 65536u / 6);
}

}  // namespace
}  // namespace triplex

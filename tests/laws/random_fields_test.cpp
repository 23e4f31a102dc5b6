// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random linear fields are in general position, so refinement ends: nothing is left unresolved.
#include <gtest/gtest.h>

#include "triplex/field/generators.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

std::size_t open_leaves(const TensorField& field) {
  RefineOptions options;
  options.max_bisections = 16384;  // more than any of these asks for
  std::size_t open = 0;
  for (const Leaf& leaf : refine(field, options).leaves) open += leaf.open != 0;
  return open;
}

TEST(RandomFields, OnOneTetAreResolved) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed)
    EXPECT_EQ(open_leaves(generate_noise_on_tet(seed)), 0u) << seed;
}

/// Leaves that become flat along an edge that is never cut; midpoints of edges at nodes too close
/// to the cone for doubles; nodes in leaves too small for doubles; narrow cones.
TEST(RandomFields, ThatWereHardAreResolved) {
  for (const std::uint64_t seed :
       {73, 81, 92, 154, 177, 346, 377, 784, 829, 865, 1856, 2117, 3043, 4028, 4445, 4543})
    EXPECT_EQ(open_leaves(generate_noise_on_tet(seed)), 0u) << seed;
}

TEST(RandomFields, OnACubeAreResolved) {
  for (std::uint64_t seed = 25; seed <= 36; ++seed) {
    GridOptions grid;
    grid.n = 1;
    grid.seed = seed;
    EXPECT_EQ(open_leaves(generate_random_linear(grid)), 0u) << seed;
  }
}

}  // namespace
}  // namespace triplex

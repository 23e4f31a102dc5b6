// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random linear fields are in general position, so refinement ends: nothing is left unresolved
// with the budget that small fields have.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/refine/refine.hpp"

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

/// Of 48 tets a budget of 8 leaves some, which share a reserve as long as it is worth it; the
/// budget is that of every tet.
TEST(Reserve, IsSharedByTheTetsLeftIfTheyAreFew) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_random_linear(grid);
  RefineOptions options;
  options.max_bisections = 8;
  const auto left = [&](std::uint32_t reserve) {
    options.reserve = reserve;
    const RefinedComplex complex = refine(field, options);
    std::set<TetId> tets;
    for (const Leaf& leaf : complex.leaves)
      if (leaf.open != 0) tets.insert(leaf.input);
    EXPECT_TRUE(std::ranges::all_of(tets, [&](TetId t) { return complex.budget.is_spent(t); }));
    return std::pair(tets.size(), complex.budget.largest_limit());
  };
  const auto [count, budget] = left(0);
  ASSERT_GT(count, 1u);
  EXPECT_EQ(budget, 8u);
  const auto n = static_cast<std::uint32_t>(count);
  EXPECT_EQ(left(8 * n - 1), std::pair(count, 8u));
  const auto [after, shared] = left(100 * n + n - 1);
  EXPECT_EQ(shared, 108u);
  EXPECT_LT(after, count);
  EXPECT_EQ(left(1000 * n).second, 8u + 16 * 8);
}

}  // namespace
}  // namespace triplex

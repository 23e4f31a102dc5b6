// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenspace.hpp"

#include <gtest/gtest.h>

#include "../oracle/eigenvector_oracle.hpp"

namespace triplex {
namespace {

using oracle::Random;

TEST(Eigenspace, Examples) {
  EXPECT_EQ(repeating_eigenspace_dimension({1, 0, 0, 0, 2, 0, 0, 0, 3}), 0);
  EXPECT_EQ(repeating_eigenspace_dimension({0, 1, 0, -1, 0, 0, 0, 0, 0}), 0);
  EXPECT_EQ(repeating_eigenspace_dimension({2, 0, 0, 0, -1, 1, 0, 0, -1}), 1);
  EXPECT_EQ(repeating_eigenspace_dimension({2, 0, 0, 0, -1, 0, 0, 0, -1}), 2);
  EXPECT_EQ(repeating_eigenspace_dimension({2, 7, 5, 0, -1, 0, 0, 0, -1}), 2);
  EXPECT_EQ(repeating_eigenspace_dimension({0, 1, 0, 0, 0, 1, 0, 0, 0}), 1);
  EXPECT_EQ(repeating_eigenspace_dimension({0, 0, 1, 0, 0, 0, 0, 0, 0}), 2);
  // Balanced and nilpotent although a, b and c are not zero; of rank one, and of rank two.
  EXPECT_EQ(repeating_eigenspace_dimension({1, -1, 0, 1, -1, 0, 0, 0, 0}), 2);
  EXPECT_EQ(repeating_eigenspace_dimension({1, -1, 2, 1, -1, 3, 0, 0, 0}), 1);
  EXPECT_EQ(repeating_eigenspace_dimension({}), 3);
  EXPECT_EQ(repeating_eigenspace_dimension({7, 0, 0, 0, 7, 0, 0, 0, 7}), 3);
}

TEST(Eigenspace, AgreesWithRationalRank) {
  Random random(1);
  std::array<int, 4> seen{};
  for (int n = 0; n < 10000; ++n) {
    const Tensor<double> t =
        n % 3 == 0 ? oracle::integer_tensor(random, 2) : oracle::degenerate_tensor(random);
    const int dimension = repeating_eigenspace_dimension(t);
    ASSERT_EQ(dimension, oracle::repeating_dimension(t));
    ++seen[dimension];
    ASSERT_EQ(repeating_eigenspace_dimension(oracle::transposed(t)), dimension);
    ASSERT_EQ(repeating_eigenspace_dimension(oracle::negated(t)), dimension);
    for (const int k : {-1060, 1000}) {
      ASSERT_EQ(repeating_eigenspace_dimension(oracle::scaled(t, k)), dimension);
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

// One unit in the last place away from a node it is one no more.
TEST(Eigenspace, NeverByATolerance) {
  EXPECT_EQ(repeating_eigenspace_dimension({2, 0, 0, 0, -1, 0x1p-1074, 0, 0, -1}), 1);
  EXPECT_EQ(repeating_eigenspace_dimension({2, 0, 0, 0, std::nextafter(-1, 0), 0, 0, 0, -1}), 0);
  EXPECT_EQ(repeating_eigenspace_dimension({1e300, 0, 0, 0, 1e300, 0x1p-1074, 0, 0, 1e300}), 2);
}

}  // namespace
}  // namespace triplex

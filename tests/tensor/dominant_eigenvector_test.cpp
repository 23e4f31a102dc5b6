// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/dominant_eigenvector.hpp"

#include <gtest/gtest.h>

#include "../oracle/eigenvector_oracle.hpp"
#include "triplex/tensor/eigenvectors.hpp"

namespace triplex {
namespace {

using oracle::Random;
using oracle::sine;

// From the definition: D > 0 the eigenvalue of largest modulus, in exact comparison.
TEST(DominantEigenvector, BelongsToTheDominantEigenvalue) {
  Random random(1);
  std::array<int, 3> counts{};
  for (int n = 0; n < 5000; ++n) {
    const Tensor<double> t = oracle::tensor_of_any_kind(random, n);
    const oracle::RationalInvariants i = oracle::rational_invariants(t);
    const DominantEigenvector d = dominant_eigenvector(t);
    ++counts[d.count];
    const int dimension = oracle::repeating_dimension(t);
    const bool neutral = i.q == 0 && i.p < 0;
    const bool none = i.p == 0 && i.q == 0 && dimension > 1;
    ASSERT_EQ(d.count, neutral ? 2 : none ? 0 : 1);
    for (int k = 0; k < 2; ++k) ASSERT_EQ(std::isnan(d.vectors[k][0]), k >= d.count);
    if (d.count == 0) continue;
    const std::array<mpq_class, 3> l = oracle::real_eigenvalues(t);
    const Tensor<mpq_class> a = oracle::rational_deviator(t);
    const mpq_class dominant = i.d < 0 ? l[0] : (abs(l[0]) >= abs(l[2]) ? l[0] : l[2]);
    ASSERT_LE(oracle::relative_residual(a, d.vectors[0], dominant), 0x1p-40);
    if (neutral) {
      ASSERT_LE(oracle::relative_residual(a, d.vectors[1], l[2]), 0x1p-40);
    } else if (i.q != 0) {
      ASSERT_EQ(sgn(dominant), sgn(i.q));
    }
  }
  for (const int count : counts) EXPECT_GT(count, 50);
}

// diag(1, e, -1): from the minor to the major eigenvector as the medium eigenvalue changes sign.
TEST(DominantEigenvector, JumpsAtTheRealNeutralSurface) {
  for (const double e : {0x1p-1074, 1e-300, 1e-20, 0.1}) {
    EXPECT_EQ(dominant_eigenvector({1, 0, 0, 0, e, 0, 0, 0, -1}).vectors[0], (Direction{0, 0, 1}));
    EXPECT_EQ(dominant_eigenvector({1, 0, 0, 0, -e, 0, 0, 0, -1}).vectors[0], (Direction{1, 0, 0}));
  }
  const DominantEigenvector both = dominant_eigenvector({1, 0, 0, 0, 0, 0, 0, 0, -1});
  ASSERT_EQ(both.count, 2);
  EXPECT_EQ(both.vectors[0], (Direction{1, 0, 0}));
  EXPECT_EQ(both.vectors[1], (Direction{0, 0, 1}));
}

TEST(DominantEigenvector, DoesNotJumpElsewhere) {
  // Across the linear degenerate surface, e the product of the off-diagonal entries of the block.
  for (const double e : {1e-6, 0.0, -1e-6}) {
    const DominantEigenvector d = dominant_eigenvector({-1, 1, 0.3, e, -1, 0.2, 0, 0, 2});
    ASSERT_EQ(d.count, 1);
    EXPECT_LT(sine(d.vectors[0], {3 * 0.3 + 0.2, 3 * 0.2, 9}), 1e-6);
  }
  // Across the complex neutral surface: the axis of rotation.
  for (const double e : {1e-3, 0.0, -1e-3}) {
    EXPECT_LT(sine(dominant_eigenvector({0, -1, 0, 1, 0, 0, 0, 0, e}).vectors[0], {0, 0, 1}),
              1e-15);
  }
  // On the spine all eigenvectors have one limit.
  EXPECT_EQ(dominant_eigenvector({0, 1, 0, 0, 0, 1, 0, 0, 0}).vectors[0], (Direction{1, 0, 0}));
  EXPECT_LT(sine(dominant_eigenvector({0, 1, 0, 0, 0, 1, 1e-30, 0, 0}).vectors[0], {1, 0, 0}),
            1e-9);
}

}  // namespace
}  // namespace triplex

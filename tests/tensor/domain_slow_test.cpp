// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Classification in bulk: a million random and two hundred thousand degenerate tensors against
// 128-bit integers.

#include <gtest/gtest.h>

#include "../oracle/polynomial_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

using oracle::Random;
__extension__ typedef __int128 Wide;

// Entries up to 2^14: |a| < 2^17 for the tripled deviator, |p| < 2^37, |q| < 2^54, |D| < 2^114.
constexpr int kRange = 1 << 14;

template <class Draw>
void check(int cases, bool degenerate, const Draw& draw) {
  SignStages stages;
  for (int n = 0; n < cases; ++n) {
    const Tensor<double> t = draw();
    std::array<Tensor<Wide>, 1> w;
    for (int k = 0; k < 9; ++k) w[0][k] = static_cast<Wide>(t[k]);
    const oracle::ExpandedInvariants<Wide, 1> exact(w);
    const Invariants i = invariants(t, 1.0);
    stages.count(i.stage);
    const Sign p = oracle::sign_of(exact.p.coefficient({2}));
    const Sign q = oracle::sign_of(exact.q.coefficient({3}));
    const Sign d = oracle::sign_of(exact.d.coefficient({6}));
    ASSERT_EQ(i.sign_p, p);
    ASSERT_EQ(i.sign_q, q);
    ASSERT_EQ(i.sign_discriminant, d);
    if (p == Sign::Zero || q == Sign::Zero || d == Sign::Zero) {
      ASSERT_EQ(i.stage, Stage::Exact);
    }
  }
  if (!degenerate) {
    EXPECT_LT(stages.exact * 1000, stages.filter);
  }
}

TEST(InvariantsSlow, Random) {
  Random random(201);
  check(1000000, false, [&] { return oracle::integer_tensor(random, kRange); });
}

TEST(InvariantsSlow, Degenerate) {
  Random random(202);
  check(200000, true, [&] { return oracle::degenerate_tensor(random); });
}

}  // namespace
}  // namespace triplex

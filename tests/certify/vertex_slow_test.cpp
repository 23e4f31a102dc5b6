// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The sector predicate in bulk: a million random tensors against 128-bit integers, and two hundred
// thousand degenerate ones against integers with a really small eps.

#include <gtest/gtest.h>

#include "../oracle/perturbed_oracle.hpp"
#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/certify/vertex.hpp"

namespace triplex {
namespace {

using oracle::Random;
__extension__ typedef __int128 Wide;
constexpr int kRange = 1 << 14;  // |a| < 2^17, |D| < 2^114

Sector sector_of_signs(Sign p, Sign q, Sign d) {
  if (p == Sign::Positive) {
    return q == Sign::Positive ? static_cast<Sector>(Domain::InnerComplexLinear)
                               : static_cast<Sector>(Domain::InnerComplexPlanar);
  }
  if (d == Sign::Positive)
    return q == Sign::Positive ? static_cast<Sector>(Domain::RealLinear)
                               : static_cast<Sector>(Domain::RealPlanar);
  return q == Sign::Positive ? static_cast<Sector>(Domain::OuterComplexLinear)
                             : static_cast<Sector>(Domain::OuterComplexPlanar);
}

template <class NT>
std::array<Sign, 3> signs(const Tensor<NT>& t) {
  const oracle::ExpandedInvariants<NT, 1> i({t});
  return {oracle::sign_of(i.p.coefficient({2})), oracle::sign_of(i.q.coefficient({3})),
          oracle::sign_of(i.d.coefficient({6}))};
}

std::array<Sign, 3> unperturbed_signs(const Tensor<double>& t) {
  Tensor<Wide> w;
  for (int k = 0; k < 9; ++k) w[k] = static_cast<Wide>(t[k]);
  return signs(w);
}

// How many of the predicate's questions have an exact zero for an answer.
unsigned zeros(const std::array<Sign, 3>& s, bool asks_d) {
  unsigned n = 0;
  for (int i = 0; i < (asks_d ? 3 : 2); ++i) n += s[i] == Sign::Zero ? 1u : 0u;
  return n;
}

template <class Draw>
SignStages check(int batches, int batch, const Draw& draw) {
  SignStages total;
  for (int b = 0; b < batches; ++b) {
    std::vector<Tensor<double>> tensors;
    for (int n = 0; n < batch; ++n) tensors.push_back(draw());
    const TensorField field = oracle::scattered_field(tensors);
    const RefinableField refinable(field);
    for (int n = 0; n < batch; ++n) {
      const Tensor<double>& t = tensors[n];
      SignStages stages;
      const auto actual = sector_at(refinable, VertexId(n), standard_features(), stages);
      if (!actual) {
        ADD_FAILURE() << "left open";
        return total;
      }
      auto s = unperturbed_signs(t);
      const unsigned exact_zeros = zeros(s, standard_features().sign_p(*actual) == Sign::Negative);
      if (s[0] == Sign::Zero || s[1] == Sign::Zero || s[2] == Sign::Zero) {
        s = signs(oracle::perturbed(t, 200));
      }
      if (*actual != sector_of_signs(s[0], s[1], s[2]) || stages.exact < exact_zeros) {
        ADD_FAILURE() << "wrong sector or stage";
        return total;
      }
      total += stages;
    }
  }
  return total;
}

TEST(VertexSectorSlow, Random) {
  Random random(301);
  const SignStages s = check(10, 100000, [&] { return oracle::integer_tensor(random, kRange); });
  EXPECT_LT((s.interval + s.exact) * 1000, s.filter);
}

TEST(VertexSectorSlow, Degenerate) {
  Random random(302);
  const SignStages s = check(2, 100000, [&] { return oracle::degenerate_tensor(random); });
  EXPECT_GT(s.exact, 100000u);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/bernstein/forms.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../oracle/random_tensors.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"

namespace triplex {
namespace {

using oracle::Random;

// As integers: exact for the small integer tensors of these tests.
Tensor<long> as_integers(const Tensor<double>& t) {
  Tensor<long> r;
  for (int i = 0; i < 9; ++i) r[i] = static_cast<long>(t[i]);
  return r;
}

TEST(Forms, IndexTablesAreInverseAndSymmetric) {
  EXPECT_EQ(kPairs<4>, 10);
  EXPECT_EQ(kTriples<4>, 20);
  for (int n = 0; n < kTriples<4>; ++n) {
    std::array<int, 3> v = triples<4>()[n];
    do {
      EXPECT_EQ((triple_index<4>(v[0], v[1], v[2])), n);
    } while (std::next_permutation(v.begin(), v.end()));
  }
  for (int n = 0; n < kPairs<4>; ++n) {
    const auto [i, j] = pairs<4>()[n];
    EXPECT_EQ((pair_index<4>(i, j)), n);
    EXPECT_EQ((pair_index<4>(j, i)), n);
  }
}

TEST(Forms, TripleDeviatorIsTraceless) {
  Random random(1);
  for (int n = 0; n < 100; ++n) {
    const Tensor<long> t = as_integers(oracle::integer_tensor(random, 1000));
    const Tensor<long> a = triple_deviator(t);
    EXPECT_EQ(a[0] + a[4] + a[8], 0);
    const long trace = t[0] + t[4] + t[8];
    for (int i = 0; i < 9; ++i) EXPECT_EQ(a[i], 3 * t[i] - (i % 4 == 0 ? trace : 0));
  }
}

TEST(Forms, VertexFormsAre18pAnd162q) {
  Random random(2);
  for (int n = 0; n < 500; ++n) {
    const Tensor<double> t =
        n % 2 == 0 ? oracle::integer_tensor(random, 50) : oracle::degenerate_tensor(random);
    const auto f = forms_of<long, 1>({triple_deviator(as_integers(t))});
    const oracle::RationalInvariants expected = oracle::rational_invariants(t);
    EXPECT_EQ(mpq_class(f.p[0]), 18 * expected.p);
    EXPECT_EQ(mpq_class(f.q[0]), 162 * expected.q);
    const mpq_class p(f.p[0]), q(f.q[0]);
    EXPECT_EQ(mpq_class(-2 * p * p * p - 3 * q * q), 4 * 729 * expected.d);
  }
}

// Polarity: the form of the sum is the sum over all index tuples.
TEST(Forms, PolarFormsAddUp) {
  Random random(3);
  for (int n = 0; n < 200; ++n) {
    std::array<Tensor<long>, 4> a;
    for (auto& t : a) t = triple_deviator(as_integers(oracle::integer_tensor(random, 20)));
    const auto f = forms_of<long, 4>(a);
    std::array<long, 4> x;
    for (long& w : x) w = static_cast<long>(oracle::integer(random, 5));
    Tensor<long> sum{};
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 9; ++k) sum[k] += x[i] * a[i][k];
    long p = 0, q = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        p += x[i] * x[j] * f.P(i, j);
        for (int k = 0; k < 4; ++k) q += x[i] * x[j] * x[k] * f.Q(i, j, k);
      }
    const auto at_sum = forms_of<long, 1>({sum});
    EXPECT_EQ(p, at_sum.p[0]);
    EXPECT_EQ(q, at_sum.q[0]);
  }
}

TEST(Forms, RestrictionIsTheFormOfTheFace) {
  Random random(4);
  std::array<Tensor<long>, 4> a;
  for (auto& t : a) t = triple_deviator(as_integers(oracle::integer_tensor(random, 20)));
  const auto tet = forms_of<long, 4>(a);
  const auto face = restrict_to<3>(tet, std::array<int, 3>{3, 0, 2});
  const auto direct = forms_of<long, 3>({a[3], a[0], a[2]});
  EXPECT_EQ(face.p, direct.p);
  EXPECT_EQ(face.q, direct.q);
  const auto edge = restrict_to<2>(tet, std::array<int, 2>{2, 1});
  EXPECT_EQ(edge.q, (forms_of<long, 2>({a[2], a[1]}).q));
}

TEST(Forms, TheSameOverEveryRing) {
  Random random(5);
  for (int n = 0; n < 50; ++n) {
    std::array<Tensor<long>, 2> a;
    std::array<Tensor<Exact>, 2> exact;
    std::array<Tensor<Perturbed<4>>, 2> perturbed;
    for (int i = 0; i < 2; ++i) {
      const Tensor<double> t = oracle::degenerate_tensor(random);
      a[i] = triple_deviator(as_integers(t));
      Tensor<Exact> e;
      Tensor<Perturbed<4>> s;
      for (int k = 0; k < 9; ++k) {
        e[k] = Exact(t[k]);
        s[k] = Perturbed<4>(t[k]);
      }
      exact[i] = triple_deviator(e);
      perturbed[i] = triple_deviator(s);
    }
    const auto f = forms_of<long, 2>(a);
    const auto g = forms_of<Exact, 2>(exact);
    const auto h = forms_of<Perturbed<4>, 2>(perturbed);
    for (int k = 0; k < kPairs<2>; ++k) {
      EXPECT_EQ(g.p[k], Exact(f.p[k]));
      EXPECT_EQ(h.p[k].coefficient(0), Exact(f.p[k]));
    }
    for (int k = 0; k < kTriples<2>; ++k) {
      EXPECT_EQ(g.q[k], Exact(f.q[k]));
      EXPECT_EQ(h.q[k].coefficient(0), Exact(f.q[k]));
    }
  }
}

// The filter's bounds hold against exact forms, with entries wrong by as much as they admit.
TEST(FormBounds, HoldAgainstExactForms) {
  Random random(6);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 3000; ++n) {
    const double relative = n % 3 == 0 ? 0 : std::ldexp(1.0, -10 - n % 40);
    EntryBounds entries;
    std::array<Tensor<double>, 4> a;
    std::array<Tensor<Exact>, 4> exact;
    double m = 0;
    for (int i = 0; i < 4; ++i) {
      a[i] = n % 2 == 0 ? oracle::double_tensor(random) : oracle::integer_tensor(random, 3);
      for (const double x : a[i]) m = std::fmax(m, std::fabs(x));
    }
    if (m == 0) continue;
    entries.magnitude = m;
    entries.error = relative * m;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 9; ++k)
        exact[i][k] =
            Exact(a[i][k]) + Exact(entries.error) * Exact(n % 2 == 0 ? unit(random) : 1.0);
    ASSERT_TRUE(entries.usable());
    const FormBounds bounds(entries);
    const auto f = forms_of<double, 4>(a);
    const auto g = forms_of<Exact, 4>(exact);
    const auto within = [](double computed, const Exact& truth, double error) {
      const Exact d = Exact(computed) - truth;
      return d <= Exact(error) && -d <= Exact(error);
    };
    for (int k = 0; k < kPairs<4>; ++k) {
      EXPECT_LE(std::fabs(f.p[k]), bounds.p_magnitude);
      EXPECT_TRUE(within(f.p[k], g.p[k], bounds.p_error));
    }
    for (int k = 0; k < kTriples<4>; ++k) {
      EXPECT_LE(std::fabs(f.q[k]), bounds.q_magnitude);
      EXPECT_TRUE(within(f.q[k], g.q[k], bounds.q_error));
    }
  }
}

TEST(FormBounds, StepAsideNearUnderflowAndForPoorEntries) {
  EXPECT_FALSE((EntryBounds{0x1p-151, 0}).usable());
  EXPECT_TRUE((EntryBounds{0x1p-150, 0}).usable());
  EXPECT_FALSE((EntryBounds{1, 0x1p-9}).usable());
  EXPECT_FALSE((EntryBounds{0, 0}).usable());
}

}  // namespace
}  // namespace triplex

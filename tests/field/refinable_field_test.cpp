// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/refinable_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "triplex/arithmetic/sign.hpp"

namespace triplex {
namespace {

using Random = std::mt19937_64;

constexpr std::array<VertexId, 4> kTet = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};

TensorField one_tet(Random& random, double scale) {
  std::uniform_real_distribution<double> entry(-scale, scale);
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 1}};
  field.mesh.tets = {kTet};
  for (int i = 0; i < 4; ++i) {
    Tensor<double> t;
    for (double& x : t) x = entry(random);
    field.tensors.push_back(t);
  }
  return field;
}

bool within(const Exact& x, double approximate, double error) {
  const Exact off = x - Exact(approximate);
  return sign(off - Exact(error)) != Sign::Positive && sign(off + Exact(error)) != Sign::Negative;
}

/// Barycentric coordinates that sum to one exactly, each within `radius` of the centre's.
std::array<Exact, 4> point_of_enclosure(Random& random, const std::array<double, 4>& centre,
                                        double radius) {
  std::uniform_int_distribution<int> corner(-1, 1);
  for (;;) {
    std::array<Exact, 4> x;
    Exact rest(1);
    for (std::size_t i = 1; i < 4; ++i) {
      x[i] = Exact(centre[i]) + Exact(radius) * Exact(corner(random));  // ends and middles
      rest = rest - x[i];
    }
    x[0] = rest;
    if (within(rest, centre[0], radius)) return x;
  }
}

/// Its error covers every point of the enclosure, for the deviator and for the tensor itself.
TEST(EnclosedVertex, HoldsTheTensorsOfItsWholeEnclosure) {
  Random random(1);
  for (const double scale : {1.0, 1e-200, 1e200})
    for (const double radius : {0x1p-48, 0x1p-30, 0x1p-10, 0.05})
      for (int n = 0; n < 20; ++n) {
        const TensorField input = one_tet(random, scale);
        RefinableField field(input);
        std::uniform_real_distribution<double> part(0.06, 0.3);
        std::array<double, 4> centre = {0, part(random), part(random), part(random)};
        centre[0] = 1 - centre[1] - centre[2] - centre[3];
        if (n % 2 == 0) field.keep_tensors();
        const VertexId v = field.add_node(kTet, centre, radius);
        ASSERT_TRUE(field.is_enclosed(v));
        const ApproximateTensor deviator = field.approximate(v);
        const ApproximateTensor tensor = field.approximate_tensor(v);
        const Exact unit = [&] {
          Exact u(1);
          for (int e = std::abs(field.scale_exponent()); e > 0; e -= 500)
            u = u *
                Exact(std::ldexp(1.0, (field.scale_exponent() < 0 ? -1 : 1) * std::min(e, 500)));
          return u;
        }();
        for (int m = 0; m < 30; ++m) {
          const auto x = point_of_enclosure(random, centre, radius);
          Tensor<Exact> a, t;
          for (std::size_t i = 0; i < 4; ++i) {
            const auto corner = field.exact(kTet[i]), whole = field.exact_tensor(kTet[i]);
            for (std::size_t k = 0; k < 9; ++k) {
              a[k] = a[k] + unit * x[i] * corner[k];
              t[k] = t[k] + unit * x[i] * whole[k];
            }
          }
          for (std::size_t k = 0; k < 9; ++k) {
            ASSERT_TRUE(within(a[k], deviator.a[k], deviator.bounds.error)) << radius;
            ASSERT_TRUE(within(t[k], tensor.a[k], tensor.bounds.error)) << radius;
            ASSERT_LE(std::fabs(deviator.a[k]), deviator.bounds.magnitude);
          }
        }
        // And it is not much wider than it has to be.
        EXPECT_LE(deviator.bounds.error, 64 * (radius + 0x1p-49));
      }
}

/// Edges at a node may be halved again and again; the enclosures of the midpoints hold too.
TEST(EnclosedVertex, MidpointsAreEnclosedAsWell) {
  Random random(3);
  for (int n = 0; n < 50; ++n) {
    const TensorField input = one_tet(random, 1);
    RefinableField field(input);
    const std::array<double, 4> centre = {0.1, 0.2, 0.3, 0.4};
    const double radius = 0x1p-30;
    const VertexId node = field.add_node(kTet, centre, radius);
    const auto x = point_of_enclosure(random, centre, radius);
    VertexId end = kTet[n % 4];
    std::array<Exact, 4> y;
    y[n % 4] = Exact(1);
    const Exact unit(std::ldexp(1.0, field.scale_exponent()));
    int halvings = 0;
    for (; halvings < 60; ++halvings) {
      const auto middle =
          n % 2 == 0 ? field.add_midpoint(node, end) : field.add_midpoint(end, node);
      if (!middle) break;
      ASSERT_TRUE(field.is_enclosed(*middle));
      ASSERT_FALSE(field.is_node(*middle));
      for (std::size_t i = 0; i < 4; ++i) y[i] = Exact(0.5) * (x[i] + y[i]);
      const ApproximateTensor got = field.approximate(*middle);
      for (std::size_t k = 0; k < 9; ++k) {
        Exact a;
        for (std::size_t i = 0; i < 4; ++i) a = a + unit * y[i] * field.exact(kTet[i])[k];
        ASSERT_TRUE(within(a, got.a[k], got.bounds.error)) << halvings;
      }
      end = *middle;  // on towards the node
    }
    EXPECT_GT(halvings, 10);
    EXPECT_LT(halvings, 40);  // until an edge is no longer than its enclosures
  }
}

/// Enclosures with exact ends hold the tensors too, and are as narrow as the weights of the node.
TEST(EnclosedVertex, EnclosuresFollowTheWeightsOfTheNode) {
  Random random(4);
  const Exact narrow(0x1p-200);
  for (int n = 0; n < 20; ++n) {
    const TensorField input = one_tet(random, 1);
    RefinableField field(input);
    const std::array<double, 4> centre = {0.125, 0.1875, 0.3125, 0.375};
    std::array<ExactRange, 4> weights;
    for (std::size_t i = 0; i < 4; ++i)
      weights[i] = {Exact(centre[i]) - narrow, Exact(centre[i]) + narrow};
    const VertexId node = field.add_node(kTet, centre, 0x1p-50, weights);
    std::array<Exact, 4> y;
    for (std::size_t i = 0; i < 4; ++i) y[i] = Exact(centre[i]);
    const VertexId inner = *field.add_midpoint(kTet[0], kTet[1]);
    const std::array<VertexId, 3> ends = {inner, kTet[2], kTet[n % 4]};
    VertexId v = node;
    for (int halvings = 0; halvings < 3; ++halvings) {
      v = n % 2 == 0 ? *field.add_midpoint(v, ends[halvings])
                     : *field.add_midpoint(ends[halvings], v);
      for (std::size_t i = 0; i < 4; ++i)
        y[i] = Exact(0.5) * (y[i] + Exact(field.weight(ends[halvings], kTet[i])));
      const Tensor<ExactRange> range = field.enclosure(v);
      for (std::size_t k = 0; k < 9; ++k) {
        Exact a;
        for (std::size_t i = 0; i < 4; ++i) a = a + y[i] * field.exact(kTet[i])[k];
        EXPECT_EQ(sign(a - range[k].lo), Sign::Positive);
        EXPECT_EQ(sign(range[k].hi - a), Sign::Positive);
        EXPECT_EQ(sign(range[k].hi - range[k].lo - Exact(0x1p-190)), Sign::Negative);
      }
    }
    // Two ends at the node.
    const VertexId other = *field.add_midpoint(node, kTet[3]);
    const Tensor<ExactRange> a = field.enclosure(v), b = field.enclosure(other);
    const Tensor<ExactRange> middle = field.enclosure(*field.add_midpoint(v, other));
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_EQ(sign(middle[k].lo + middle[k].lo - a[k].lo - b[k].lo), Sign::Zero);
      EXPECT_EQ(sign(middle[k].hi + middle[k].hi - a[k].hi - b[k].hi), Sign::Zero);
    }
  }
}

TEST(EnclosedVertex, EnclosuresOfOtherVerticesArePoints) {
  Random random(5);
  const TensorField input = one_tet(random, 1);
  RefinableField field(input);
  for (const VertexId v : {kTet[1], *field.add_midpoint(kTet[0], kTet[2])})
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_EQ(sign(field.enclosure(v)[k].lo - field.exact(v)[k]), Sign::Zero);
      EXPECT_EQ(sign(field.enclosure(v)[k].hi - field.exact(v)[k]), Sign::Zero);
    }
}

TEST(EnclosedVertex, IsNotKnownExactly) {
  Random random(2);
  const TensorField input = one_tet(random, 1);
  RefinableField field(input);
  const VertexId middle = *field.add_midpoint(kTet[0], kTet[1]);
  const VertexId v = field.add_node(kTet, {0.1, 0.2, 0.3, 0.4}, 0x1p-40);
  const VertexId later = *field.add_midpoint(middle, kTet[2]);
  EXPECT_THROW(field.exact(v), std::logic_error);
  EXPECT_THROW(field.exact_tensor(v), std::logic_error);
  for (const VertexId other : {kTet[0], kTet[1], middle, later}) {
    EXPECT_FALSE(field.is_enclosed(other));
    EXPECT_FALSE(field.is_node(other));
    EXPECT_NO_THROW(field.exact(other));
  }
  EXPECT_TRUE(field.is_node(v));
  const VertexId enclosed = *field.add_midpoint(middle, v);
  EXPECT_THROW(field.exact(enclosed), std::logic_error);
  EXPECT_NEAR(field.position(enclosed)[2], 0.2, 1e-12);
  EXPECT_EQ(field.corners(v), std::vector<VertexId>(kTet.begin(), kTet.end()));
  const Point x = field.position(v);
  EXPECT_NEAR(x[0], 0.2 + 0.6 + 1.2, 1e-12);
  EXPECT_NEAR(x[1], 0.3, 1e-12);
  EXPECT_NEAR(x[2], 0.4, 1e-12);
  EXPECT_EQ(field.weight(later, kTet[2]), 0.5);
  EXPECT_EQ(field.weight(later, kTet[0]), 0.25);
  EXPECT_EQ(field.weight(later, kTet[3]), 0);
}

}  // namespace
}  // namespace triplex

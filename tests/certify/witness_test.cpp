// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/witness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "../oracle/one_tet.hpp"
#include "triplex/certify/variation.hpp"

namespace triplex {
namespace {

using Vector = std::array<double, 3>;
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Sets on one side of a random plane, some of them only just.
TEST(SeparatingDirection, FindsADirectionWhereThereIsOne) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int needed_search = 0;
  for (int n = 0; n < 20000; ++n) {
    const int dimension = 1 + n % 3;
    const double size = std::exp2(static_cast<double>(n % 400) - 200);
    Vector axis{};
    for (int k = 0; k < dimension; ++k) axis[k] = normal(random);
    std::vector<Vector> g(2 + random() % 19);
    Vector mean{};
    for (Vector& v : g) {
      v = {};
      for (int k = 0; k < dimension; ++k) v[k] = normal(random) * (1 + double(random() % 8));
      const double along = dot(v, axis) / dot(axis, axis);
      // Reflect to the positive side, at least 1/8 of the axis away from the plane.
      const double shift = std::fabs(along) + 0.125 - along;
      for (int k = 0; k < 3; ++k) v[k] = (v[k] + shift * axis[k]) * size;
      for (int k = 0; k < 3; ++k) mean[k] += v[k];
    }
    const Vector d = separating_direction(g);
    bool mean_serves = true;
    for (const Vector& v : g) {
      EXPECT_GT(dot(d, v), 0) << "set " << n;
      mean_serves &= dot(mean, v) > 0;
    }
    needed_search += !mean_serves;
    for (int k = 0; k < 3; ++k) EXPECT_EQ(d[k], few_bits(d[k]));
  }
  EXPECT_GT(needed_search, 500);
}

TEST(SeparatingDirection, FindsNoneAroundTheOrigin) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 2000; ++n) {
    std::vector<Vector> g;
    for (int i = 0; i < 6; ++i) {
      g.push_back({normal(random), normal(random), normal(random)});
      g.push_back({-g.back()[0], -g.back()[1], -g.back()[2]});
    }
    const Vector d = separating_direction(g);
    bool separates = dot(d, d) > 0;
    for (const Vector& v : g) separates &= dot(d, v) > 0;
    EXPECT_FALSE(separates);
  }
  EXPECT_EQ(separating_direction({}), Vector{});
}

/// A field that changes only from vertex 3 to the others varies along no edge among these.
TEST(Variation, ChoosesAnEdgeAlongWhichTheFieldChanges) {
  const Tensor<double> base = {1, 2, 0, -1, 3, 1, 0.5, 0, -2};
  const TensorField field = oracle::on_one_tet({base, base, base, {0, 5, 1, 2, -3, 1, 4, 0, 7}});
  const RefinableField refinable(field);
  const Simplex<4> tet(refinable, {VertexId(0), VertexId(1), VertexId(2), VertexId(3)});
  const std::array<ModeMap, 2> maps = {ModeMap{}, ModeMap{4, 2}};
  for (const Measures& m : {Measures{.p = true}, Measures{.q = true},
                            Measures{.discriminants = std::span(maps).first(1)},
                            Measures{.p = true, .q = true, .discriminants = maps}}) {
    const EdgeChoice choice = edge_of_largest_variation(tet, m);
    EXPECT_EQ(choice.edge, (std::array{0, 3}));
    EXPECT_EQ(choice.variation, double(m.p) + double(m.q) + double(m.discriminants.size()));
  }
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Every number of the suite that can be checked exactly is, in rational arithmetic.
#include "triplex/field/ground_truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "../oracle/rational_expression.hpp"
#include "../oracle/rational_oracle.hpp"
#include "triplex/field/bad_input.hpp"
#include "triplex/field/input_check.hpp"

namespace triplex {

void PrintTo(const GroundTruth& truth, std::ostream* out) { *out << truth.name; }

namespace {

using oracle::RationalExpression;
using RationalPoint = std::array<mpq_class, 3>;

/// In lowest terms.
mpq_class ratio(int numerator, int denominator) { return mpq_class(numerator) / denominator; }

Tensor<mpq_class> exact_tensor(const GroundTruth& truth, const RationalPoint& x) {
  Tensor<mpq_class> t;
  for (std::size_t i = 0; i < 9; ++i) {
    t[i] = mpq_class(truth.tensors[0][i]);
    for (std::size_t k = 0; k < 3; ++k) t[i] += x[k] * mpq_class(truth.tensors[k + 1][i]);
  }
  return t;
}

RationalPoint exact_point(const Point& x) {
  return {mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])};
}

const GroundTruth& truth_named(std::string_view name) {
  const auto& suite = ground_truth_suite();
  const auto found = std::ranges::find(suite, name, &GroundTruth::name);
  if (found == suite.end()) throw std::invalid_argument(std::string(name));
  return *found;
}

std::string name_of_case(const testing::TestParamInfo<GroundTruth>& info) {
  std::string name = info.param.name;
  std::ranges::replace(name, '-', '_');
  return name;
}

class GroundTruthTest : public testing::TestWithParam<GroundTruth> {};

TEST_P(GroundTruthTest, ClosedFormsArePAndQ) {
  const GroundTruth& truth = GetParam();
  // A cubic polynomial in three variables vanishes if it does on the grid {0, 1, 2, 3}^3.
  for (int i = 0; i < 64; ++i) {
    const RationalPoint x = {ratio(i % 4, 3), ratio(i / 4 % 4, 5), ratio(i / 16, 7)};
    const auto invariants = oracle::rational_invariants(exact_tensor(truth, x));
    EXPECT_EQ(RationalExpression::evaluate(truth.p, x), invariants.p) << truth.p;
    EXPECT_EQ(RationalExpression::evaluate(truth.q, x), invariants.q) << truth.q;
  }
}

TEST_P(GroundTruthTest, NodesHaveRankOneAndLieInTheBox) {
  const GroundTruth& truth = GetParam();
  if (!truth.nodes) return;
  std::set<std::array<std::string, 3>> positions;
  for (const NodeTruth& node : *truth.nodes) {
    RationalPoint x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = mpq_class(node.position[k]);
    EXPECT_TRUE(positions.insert(node.position).second) << "listed twice";
    for (const int n : {8, 64}) {
      const Box box = ground_truth_box(truth, n);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_GT(x[k], mpq_class(box.lo[k]));
        EXPECT_LT(x[k], mpq_class(box.hi[k]));
      }
    }
    Tensor<mpq_class> r = exact_tensor(truth, x);
    const mpq_class mean = (r[0] + r[4] + r[8]) / 3, l(node.eigenvalue);
    for (const int i : {0, 4, 8}) r[i] -= mean + l;
    EXPECT_TRUE(std::ranges::any_of(r, [](const mpq_class& e) { return e != 0; }));
    for (int i = 0; i < 3; ++i) {
      for (int j = i + 1; j < 3; ++j) {
        for (int m = 0; m < 3; ++m) {
          for (int o = m + 1; o < 3; ++o)
            EXPECT_EQ(r[3 * i + m] * r[3 * j + o], r[3 * i + o] * r[3 * j + m]);
        }
      }
    }
    EXPECT_NE(l, 0);
    EXPECT_EQ(node.feature, l < 0 ? "degenerate-linear" : "degenerate-planar");
  }
}

TEST_P(GroundTruthTest, SamplesAreTheLinearFieldExactly) {
  const GroundTruth& truth = GetParam();
  for (const int n : {8, 16, 64}) {
    const TensorField field = sample_ground_truth(truth, n);
    const Box box = ground_truth_box(truth, n);
    ASSERT_EQ(field.mesh.tets.size(), 6u * n * n * n);
    const auto m = static_cast<std::size_t>(n) + 1;
    std::mt19937 random(static_cast<unsigned>(n));
    for (int i = 0; i < 200; ++i) {
      const std::size_t v = i == 0 ? field.tensors.size() - 1 : random() % field.tensors.size();
      const RationalPoint x = exact_point(field.mesh.points[v]);
      const std::array<std::size_t, 3> ijk = {v % m, v / m % m, v / m / m};
      for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class lo(box.lo[k]), hi(box.hi[k]);
        ASSERT_EQ(x[k], lo + (hi - lo) * ratio(static_cast<int>(ijk[k]), n));
      }
      ASSERT_EQ(oracle::rational(field.tensors[v]), exact_tensor(truth, x)) << "vertex " << v;
    }
  }
}

TEST_P(GroundTruthTest, PlacementIsWhereTheCellSays) {
  const GroundTruth& truth = GetParam();
  for (const int n : {8, 32}) {
    const Box box = ground_truth_box(truth, n);
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class cell = (mpq_class(box.hi[k]) - mpq_class(box.lo[k])) / n;
      const mpq_class cells = (mpq_class(truth.centre[k]) - mpq_class(box.lo[k])) / cell;
      EXPECT_EQ(cells, mpq_class(n / 2) + mpq_class(truth.fraction[k]));
    }
  }
}

TEST_P(GroundTruthTest, IsCompleteAndSaysWhy) {
  const GroundTruth& truth = GetParam();
  EXPECT_FALSE(truth.title.empty());
  EXPECT_GT(truth.source.size(), 100u);
  EXPECT_TRUE(truth.nodes.has_value());
  std::set<std::string> names;
  for (const SurfaceTruth& s : truth.surfaces) {
    EXPECT_TRUE(names.insert(s.feature).second) << s.feature;
    EXPECT_GE(s.components, 0);
    if (s.components == 0) {
      EXPECT_EQ(s.euler, 0) << s.feature;
      EXPECT_EQ(s.boundary_loops, 0) << s.feature;
    }
  }
}

/// Signs of p, q and D all over the box agree with which surfaces are said to be there: a surface
/// that is said not to exist is nowhere between two neighbouring vertices of a fine grid.
TEST_P(GroundTruthTest, AbsentSurfacesSeparateNoVertices) {
  const GroundTruth& truth = GetParam();
  if (truth.surfaces.empty()) return;
  std::map<std::string, int> seen;
  const TensorField field = sample_ground_truth(truth, 16);
  for (const Tensor<double>& t : field.tensors) {
    const auto i = oracle::rational_invariants(t);
    ++seen[i.p > 0 ? "p > 0" : "p < 0"];
    ++seen[i.q > 0 ? "q > 0" : "q < 0"];
    ++seen[i.d > 0 ? "D > 0" : "D < 0"];
  }
  const auto absent = [&](std::string_view kind) {
    return std::ranges::none_of(truth.surfaces, [&](const SurfaceTruth& s) {
      return s.feature.starts_with(kind) && s.components > 0;
    });
  };
  EXPECT_EQ(absent("balanced") && seen.contains("p > 0") && seen.contains("p < 0"), false);
  EXPECT_EQ(absent("neutral") && seen.contains("q > 0") && seen.contains("q < 0"), false);
  EXPECT_EQ(absent("degenerate") && seen.contains("D > 0") && seen.contains("D < 0"), false);
}

INSTANTIATE_TEST_SUITE_P(Suite, GroundTruthTest, testing::ValuesIn(ground_truth_suite()),
                         name_of_case);

TEST(GroundTruthSuite, NamesAreUnique) {
  std::set<std::string> names;
  for (const GroundTruth& truth : ground_truth_suite())
    EXPECT_TRUE(names.insert(truth.name).second) << truth.name;
}

TEST(GroundTruthSuite, RefusesOtherGrids) {
  for (const int n : {-8, 0, 4, 7, 12, 128})
    EXPECT_THROW(sample_ground_truth(ground_truth_suite().front(), n), BadInput) << n;
}

TEST(GroundTruthSuite, FieldsPassTheInputCheck) {
  for (const GroundTruth& truth : ground_truth_suite()) {
    TensorField field = sample_ground_truth(truth, 8);
    EXPECT_NO_THROW(check_input(field)) << truth.name;
  }
}

/// The node of the fields with placements is where the name says: so many of the cell's
/// coordinates are fractions, and they differ or not.
TEST(GroundTruthSuite, NodesAreInTetFaceEdgeVertex) {
  for (const std::string family : {"lorenz-node-", "cone-"}) {
    const auto distinct = [&](const std::string& place) {
      const Point f = truth_named(family + place).fraction;
      const std::set<double> values = {0, 1, f[0], f[1], f[2]};  // Kuhn's cut: x, y, z in order
      return values.size() - 2;
    };
    EXPECT_EQ(distinct("in-tet"), 3u);
    EXPECT_EQ(distinct("on-face"), 2u);
    EXPECT_EQ(distinct("on-edge"), 1u);
    EXPECT_EQ(distinct("at-vertex"), 0u);
  }
}

/// The spheres that are said to lie inside one tet: every point of the surface within the radius of
/// the centre has positive barycentric coordinates in the tet of the centre, on the finest grid.
TEST(GroundTruthSuite, BallsLieInsideOneTet) {
  for (const char* name : {"balanced-ball-linear", "balanced-ball-planar", "magnitude-ball"}) {
    const GroundTruth& truth = truth_named(name);
    for (const int n : {8, 64}) {
      const Box box = ground_truth_box(truth, n);
      const double cell = (box.hi[0] - box.lo[0]) / n;
      Point f = truth.fraction;
      std::ranges::sort(f);
      const double slack = std::min(
          {f[0], (f[1] - f[0]) / std::sqrt(2.0), (f[2] - f[1]) / std::sqrt(2.0), 1 - f[2]});
      EXPECT_GT(slack * cell, 1.01 / 512) << name;
    }
  }
}

TEST(GroundTruthSuite, MagnitudesAreAsStated) {
  const GroundTruth& truth = truth_named("magnitude-ball");
  const auto squared = [&](const RationalPoint& x) {
    mpq_class sum = 0;
    for (const mpq_class& e : exact_tensor(truth, x)) sum += e * e;
    return sum;
  };
  const mpq_class small(1, 512), large(55, 256);
  EXPECT_EQ(squared({small, 0, 0}), mpq_class(6049) * 6049);
  EXPECT_EQ(squared({0, 0, -large}), mpq_class(6050) * 6050);
  EXPECT_EQ(squared({large * mpq_class(3, 5), large * mpq_class(-4, 5), 0}),
            mpq_class(6050) * 6050);
}

/// p and q vanish on the stated circle.
TEST(GroundTruthSuite, SpineLoopIsTheCircle) {
  const GroundTruth& truth = truth_named("spine-loop-in-tet");
  for (const auto& [c, s] : {std::pair{3, 4}, {-4, 3}, {5, 0}, {0, -5}}) {
    const auto i =
        oracle::rational_invariants(exact_tensor(truth, {ratio(c, 10), ratio(s, 10), 0}));
    EXPECT_EQ(i.p, 0);
    EXPECT_EQ(i.q, 0);
  }
}

/// The stated parametrisations of the triple curve satisfy p = q = 0.
TEST(GroundTruthSuite, LorenzTripleCurvesAreAsStated) {
  for (const int i : {-7, -2, 1, 3, 11}) {
    const mpq_class x = ratio(i, 6);
    const mpq_class y8 = (1 - 5 * x * x) / (8 * x), z8 = (237 - x * x) / 8;
    const auto on8 =
        oracle::rational_invariants(exact_tensor(truth_named("lorenz-node-in-tet"), {x, y8, z8}));
    EXPECT_EQ(on8.p, 0);
    EXPECT_EQ(on8.q, 0);
    const mpq_class l = ratio(17, 9);
    const mpq_class y = (l * l * l - ratio(22, 3) * x * x) / (10 * x),
                    z = (ratio(8179, 27) - x * x) / 10;
    const auto on =
        oracle::rational_invariants(exact_tensor(truth_named("lorenz-classic"), {x, y, z}));
    EXPECT_EQ(on.p, 0);
    EXPECT_EQ(on.q, 0);
  }
}

TEST(GroundTruthSuite, BoxesHoldSoManyOfTheSixNodes) {
  const auto& all = *truth_named("nodes-6").nodes;
  ASSERT_EQ(all.size(), 6u);
  for (const std::string name : {"nodes-0", "nodes-2", "nodes-4", "nodes-6"}) {
    const GroundTruth& truth = truth_named(name);
    const Box box = ground_truth_box(truth, 8);
    const auto inside = std::ranges::count_if(all, [&](const NodeTruth& node) {
      for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class x(node.position[k]);
        if (x < mpq_class(box.lo[k]) || x > mpq_class(box.hi[k])) return false;
      }
      return true;
    });
    EXPECT_EQ(std::to_string(inside), name.substr(6)) << name;
    EXPECT_EQ(truth.nodes->size(), static_cast<std::size_t>(inside));
  }
}

}  // namespace
}  // namespace triplex

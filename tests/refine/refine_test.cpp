// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/refine/refine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "../../src/refine/bisection.hpp"
#include "../../src/refine/needle.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

TensorField rolls() {
  GridOptions grid;
  grid.n = 6;
  grid.jitter = 0.2;
  return generate_rayleigh_benard(grid);
}
RefinedComplex refined(const TensorField& field, std::uint32_t budget = 12) {
  RefineOptions options;
  options.max_bisections = budget;
  return refine(field, options);
}

double six_volumes(const RefinedComplex& c, const Leaf& leaf) {
  std::array<Point, 4> x;
  for (int i = 0; i < 4; ++i) x[i] = c.field.position(leaf.vertices[i]);
  std::array<Point, 3> e;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) e[i][k] = x[i + 1][k] - x[0][k];
  const double v = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                   e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                   e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
  return leaf.flipped ? -v : v;
}

/// Of the box between the first and the last point of the field.
void expect_conforming_and_oriented(const TensorField& field, const RefinedComplex& c) {
  std::map<std::array<VertexId, 3>, int> faces;
  double volume = 0;
  for (const Leaf& leaf : c.leaves) {
    EXPECT_TRUE(std::is_sorted(leaf.vertices.begin(), leaf.vertices.end()));
    EXPECT_GT(six_volumes(c, leaf), 0);
    volume += six_volumes(c, leaf) / 6;
    for (int omit = 0; omit < 4; ++omit) {
      std::array<VertexId, 3> face;
      for (int i = 0, k = 0; i < 4; ++i)
        if (i != omit) face[k++] = leaf.vertices[i];
      ++faces[face];
    }
  }
  const Point low = field.mesh.points.front(), high = field.mesh.points.back();
  double box = 1;
  for (std::size_t k = 0; k < 3; ++k) box *= high[k] - low[k];
  EXPECT_NEAR(volume, box, 5e-10 * box);
  for (const auto& [face, count] : faces) {
    ASSERT_LE(count, 2);
    // A face with one tet lies in a side of the box; a hanging node would leave one inside.
    bool on_side = count == 2;
    for (std::size_t k = 0; k < 3; ++k)
      for (const double limit : {low[k], high[k]})
        on_side |=
            std::ranges::all_of(face, [&](VertexId v) { return c.field.position(v)[k] == limit; });
    EXPECT_TRUE(on_side);
  }
}

TEST(Refine, MeshIsConformingAndOriented) {
  const TensorField field = rolls();
  const RefinedComplex c = refined(field);
  ASSERT_GT(c.leaves.size(), 2 * field.mesh.tets.size());
  expect_conforming_and_oriented(field, c);
}

/// The node of this field lies in a face, at a place that no halving reaches.
TEST(Refine, IsConformingAroundExactPoints) {
  GridOptions grid;
  grid.n = 9;
  const TensorField field = generate_lorenz(grid);
  const RefinedComplex c = refined(field, 24);
  ASSERT_TRUE(c.field.has_rational_vertices());
  expect_conforming_and_oriented(field, c);
}

TEST(Refine, RationalPointsAreExactUpToTheirDenominator) {
  const TensorField field = rolls();
  RefinableField f(field);
  const auto tet = f.input_tets().front();
  VertexId a = f.add_rational(tet, {Exact(1.0), Exact(5.0), Exact(0.0), Exact(7.0)});
  const VertexId other = f.add_rational(tet, {Exact(0.0), Exact(1.0), Exact(2.0), Exact(0.0)});
  EXPECT_EQ(f.corners(a).size(), 3u);
  EXPECT_NEAR(f.weight(a, tet[1]), 5.0 / 13, 1e-15);
  for (const VertexId end : {tet[2], other, tet[0]}) {
    const auto m = f.add_point_between(a, end, 0.375);
    ASSERT_TRUE(m);
    ASSERT_TRUE(f.is_rational(*m));
    const Exact na = f.denominator(a), ne = f.denominator(end), nm = f.denominator(*m);
    EXPECT_NE(sign(nm - Exact(1)), Sign::Negative);
    EXPECT_EQ(sign(nm - Exact(2)), Sign::Negative);
    const auto ta = f.exact(a), te = f.exact(end), tm = f.exact(*m);
    const ApproximateTensor& approximate = f.approximate(*m);
    const Exact scale(std::ldexp(1.0, f.scale_exponent())), bound(approximate.bounds.error);
    for (std::size_t k = 0; k < 9; ++k) {
      const Exact mean = Exact(0.625) * ta[k] * ne + Exact(0.375) * te[k] * na;  // times na ne
      EXPECT_TRUE((tm[k] * na * ne - mean * nm).is_zero());
      const Exact difference = tm[k] * scale - Exact(approximate.a[k]) * nm;
      EXPECT_NE(sign(difference - bound * nm), Sign::Positive);
      EXPECT_NE(sign(difference + bound * nm), Sign::Negative);
    }
    a = *m;
  }
}

TEST(Refine, MidpointsCarryTheExactMeanAndBoundedDoubles) {
  const TensorField field = rolls();
  RefinableField f(field);
  const auto tet = f.input_tets().front();
  VertexId a = tet[0], b = tet[1];
  for (int depth = 0; depth < 100; ++depth) {
    const auto m = f.add_midpoint(a, b);
    ASSERT_TRUE(m);
    if (f.is_rational(*m)) {
      EXPECT_GE(depth, RefinableField::kWordDepth);
      EXPECT_TRUE((f.denominator(*m) - Exact(1)).is_zero());
    }
    const auto ta = f.exact(a), tb = f.exact(b), tm = f.exact(*m);
    const ApproximateTensor& approximate = f.approximate(*m);
    const Exact scale(std::ldexp(1.0, f.scale_exponent()));
    for (int k = 0; k < 9; ++k) {
      EXPECT_TRUE(sign(tm[k] + tm[k] - ta[k] - tb[k]) == Sign::Zero);
      const Exact difference = tm[k] * scale - Exact(approximate.a[k]);
      const Exact bound(approximate.bounds.error);
      EXPECT_NE(sign(difference - bound), Sign::Positive);
      EXPECT_NE(sign(difference + bound), Sign::Negative);
    }
    (depth % 3 == 0 ? a : b) = *m;
    if (depth % 7 == 6) b = tet[2 + depth % 2];
  }
  EXPECT_TRUE(f.has_rational_vertices());
}

TEST(Refine, DepthIsLimited) {
  const TensorField field = rolls();
  RefinableField f(field);
  const auto tet = f.input_tets().front();
  VertexId b = tet[1];
  for (int depth = 0; depth < RefinableField::kMaxDepth; ++depth) {
    const auto m = f.add_midpoint(tet[0], b);
    ASSERT_TRUE(m);
    b = *m;
  }
  EXPECT_FALSE(f.add_midpoint(tet[0], b));
}

TEST(Refine, BudgetBoundsTheBisections) {
  const TensorField field = rolls();
  const RefinedComplex none = refined(field, 0);
  EXPECT_EQ(none.leaves.size(), field.mesh.tets.size());
  EXPECT_EQ(none.bisections, 0u);
  std::uint64_t last = 0;
  for (const std::uint32_t budget : {1u, 4u, 16u}) {
    const RefinedComplex c = refined(field, budget);
    EXPECT_GT(c.bisections, last);
    last = c.bisections;
  }
}

TEST(Refine, OpenLeavesSayWhy) {
  const TensorField field = rolls();
  for (const Leaf& leaf : refined(field, 2).leaves) {
    EXPECT_EQ(leaf.open != 0, leaf.obstacle != Obstacle::None);
    EXPECT_EQ(leaf.open & leaf.graph, 0);
    EXPECT_FALSE(describe(leaf.obstacle).empty());
  }
}

/// Two leaves of one size: the longest edge is named only where the volume is far too small for it.
TEST(Refine, NeedlesAreCutAcrossTheirLongestEdge) {
  const TensorField field = rolls();
  const RefinableField refinable(field);
  Leaf leaf{.vertices = refinable.input_tets()[0], .input = TetId(0)};
  sort_vertices(leaf);
  EXPECT_FALSE(edge_of_needle(refinable, leaf));
  leaf.depth = 12;  // sixteen times as long as usual
  EXPECT_FALSE(edge_of_needle(refinable, leaf));
  leaf.depth = 15;
  const auto edge = edge_of_needle(refinable, leaf);
  ASSERT_TRUE(edge);
  const auto length = [&](VertexId a, VertexId b) {
    double squared = 0;
    for (std::size_t k = 0; k < 9; ++k) {
      const double x = refinable.approximate(a).a[k] - refinable.approximate(b).a[k];
      squared += x * x;
    }
    return squared;
  };
  for (const VertexId a : leaf.vertices)
    for (const VertexId b : leaf.vertices) EXPECT_LE(length(a, b), length((*edge)[0], (*edge)[1]));
  EXPECT_LT((*edge)[0], (*edge)[1]);
}

TEST(Refine, SizeLimitEndsTheRun) {
  const TensorField field = rolls();
  RefineOptions options;
  options.max_bisections = 1000;
  options.max_tets = 4 * field.mesh.tets.size();
  const RefinedComplex c = refine(field, options);
  EXPECT_TRUE(c.hit_size_limit);
  EXPECT_LT(c.leaves.size(), 40 * field.mesh.tets.size());
}

}  // namespace
}  // namespace triplex

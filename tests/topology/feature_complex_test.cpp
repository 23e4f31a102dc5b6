// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/topology/feature_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>

namespace triplex {
namespace {

constexpr auto kReal = Feature::NeutralReal, kLinear = Feature::BalancedLinear;

struct SoupBuilder {
  FeatureSoup soup;

  /// Every triangle has its own points: only coordinates join them.
  void triangle(Feature f, const Point& a, const Point& b, const Point& c, bool certified = true) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), {a, b, c});
    soup.triangles.push_back({n, n + 1, n + 2});
    triangles.push_back({f, certified});
  }
  void segment(const Point& a, const Point& b, Feature f = Feature::TripleCurve) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    soup.points.insert(soup.points.end(), {a, b});
    soup.segments.push_back({n, n + 1});
    segments.push_back(f);
  }
  FeatureComplex build(const FeatureTable& table = standard_features()) {
    soup.features.clear();
    soup.source_cell.clear();
    soup.certified.clear();
    for (const auto& [f, certified] : triangles) {
      soup.source_cell.push_back(static_cast<std::int64_t>(10 + soup.features.size()));
      soup.features.push_back(f);
      soup.certified.push_back(certified);
    }
    for (const Feature f : segments) {
      soup.source_cell.push_back(static_cast<std::int64_t>(10 + soup.features.size()));
      soup.features.push_back(f);
      soup.certified.push_back(1);
    }
    return feature_complex(soup, table);
  }

  std::vector<std::pair<Feature, bool>> triangles;
  std::vector<Feature> segments;
};

/// The square of corners a, b, c, d, normals by that order.
void square(SoupBuilder& soup, Feature f, const Point& a, const Point& b, const Point& c,
            const Point& d) {
  soup.triangle(f, a, b, c);
  soup.triangle(f, a, c, d);
}

/// A wing of `f` from the z axis at some angle, two squares high, its normal towards growing angle.
void wing(SoupBuilder& soup, Feature f, double x, double y) {
  for (const double z : {0.0, 1.0})
    square(soup, f, {0, 0, z}, {0, 0, z + 1}, {x, y, z + 1}, {x, y, z});
}

TEST(FeatureComplex, Square) {
  SoupBuilder soup;
  square(soup, kReal, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  const FeatureComplex complex = soup.build();
  EXPECT_EQ(complex.points.size(), 4u);
  EXPECT_EQ(complex.edges, 5u);
  EXPECT_EQ(complex.euler(), 1);
  EXPECT_EQ(complex.components, 1u);
  ASSERT_EQ(complex.patches.size(), 1u);
  const ComplexPatch& patch = complex.patches[0];
  EXPECT_EQ(patch.feature, kReal);
  EXPECT_EQ(patch.triangles, 2u);
  EXPECT_EQ(patch.certified, 2u);
  EXPECT_EQ(patch.euler, 1);
  EXPECT_DOUBLE_EQ(patch.area, 1);
  EXPECT_EQ(name_of(patch.front), "real-planar");
  EXPECT_EQ(name_of(patch.back), "real-linear");
  ASSERT_EQ(complex.curves.size(), 1u) << "its boundary, without a corner";
  EXPECT_EQ(complex.curves[0].kind, CurveKind::Boundary);
  EXPECT_TRUE(complex.curves[0].closed);
  EXPECT_EQ(complex.curves[0].edges, 4u);
  EXPECT_DOUBLE_EQ(complex.curves[0].length, 4);
  EXPECT_TRUE(complex.corners.empty());
}

TEST(FeatureComplex, SidesOfAllPages) {
  FeatureTable table;
  const Feature mode = table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  const Feature magnitude = table.add_magnitude(1);
  const std::vector<std::tuple<Feature, std::string_view, std::string_view>> expected = {
      {Feature::NeutralComplex, "inner-complex-linear", "inner-complex-planar"},
      {Feature::BalancedLinear, "outer-complex-linear", "inner-complex-linear"},
      {Feature::DegenerateLinear, "real-linear", "outer-complex-linear"},
      {mode, "real-linear", "real-linear"},
      {Feature::NeutralReal, "real-planar", "real-linear"},
      {Feature::DegeneratePlanar, "outer-complex-planar", "real-planar"},
      {Feature::BalancedPlanar, "inner-complex-planar", "outer-complex-planar"},
      {magnitude, "outside", "inside"}};
  for (const auto& [feature, front, back] : expected) {
    SoupBuilder soup;
    soup.triangle(feature, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const ComplexPatch patch = soup.build(table).patches.at(0);
    EXPECT_EQ(name_of(patch.front), front);
    EXPECT_EQ(name_of(patch.back), back);
  }
}

TEST(FeatureComplex, BookOfThreePages) {
  SoupBuilder soup;
  wing(soup, kReal, 1, 0);
  wing(soup, Feature::DegeneratePlanar, 0, 1);
  wing(soup, Feature::BalancedPlanar, -1, 0);
  soup.segment({0, 0, 0}, {0, 0, 1});
  soup.segment({0, 0, 2}, {0, 0, 1});
  const FeatureComplex complex = soup.build();
  EXPECT_EQ(complex.points.size(), 12u);
  EXPECT_EQ(complex.euler(), 1);
  EXPECT_EQ(complex.patches.size(), 3u);
  ASSERT_EQ(complex.curves.size(), 4u);
  const auto spine = std::ranges::find(complex.curves, CurveKind::Segments, &ComplexCurve::kind);
  ASSERT_NE(spine, complex.curves.end());
  EXPECT_EQ(spine->triangles, 3u);
  EXPECT_EQ(spine->edges, 2u);
  EXPECT_EQ(spine->length, 2);
  EXPECT_FALSE(spine->closed);
  EXPECT_EQ(spine->features, bit(kReal) | bit(Feature::DegeneratePlanar) |
                                 bit(Feature::BalancedPlanar) | bit(Feature::TripleCurve));
  ASSERT_EQ(complex.corners.size(), 2u) << "the ends of the spine";
  for (const std::uint32_t v : complex.corners) {
    EXPECT_EQ(complex.points[v][0], 0);
    EXPECT_NE(complex.points[v][2], 1);
  }
  EXPECT_EQ(complex.line_source_cell.size(), complex.lines.size());
  EXPECT_EQ(std::ranges::count(complex.line_source_cell, -1),
            static_cast<std::ptrdiff_t>(complex.lines.size()) - 2);
}

TEST(FeatureComplex, WithoutItsSegmentsTheSpineIsABranch) {
  SoupBuilder soup;
  wing(soup, kReal, 1, 0);
  wing(soup, kLinear, 0, 1);
  const FeatureComplex complex = soup.build();
  EXPECT_EQ(std::ranges::count(complex.curves, CurveKind::Branch, &ComplexCurve::kind), 1);
  EXPECT_EQ(complex.patches.size(), 2u);
}

TEST(FeatureComplex, FacingTrianglesDoNotContinueEachOther) {
  SoupBuilder soup;
  soup.triangle(kReal, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  soup.triangle(kReal, {0, 0, 0}, {1, 0, 0}, {0, -1, 0});  // its normal points the other way
  const FeatureComplex complex = soup.build();
  EXPECT_EQ(complex.patches.size(), 2u);
  EXPECT_EQ(std::ranges::count(complex.curves, CurveKind::Branch, &ComplexCurve::kind), 1);
}

/// A cone of four triangles over a square around the z axis.
void cone(SoupBuilder& soup, const Point& tip, double z) {
  const std::array<Point, 4> rim = {{{1, 0, z}, {0, 1, z}, {-1, 0, z}, {0, -1, z}}};
  for (std::size_t i = 0; i < 4; ++i)
    soup.triangle(Feature::DegenerateLinear, tip, rim[i], rim[(i + 1) % 4]);
}

TEST(FeatureComplex, DoubleConeHasACornerAndTwoDiscs) {
  SoupBuilder soup;
  cone(soup, {0, 0, 0}, 1);
  cone(soup, {0, 0, 0}, -1);
  FeatureComplex complex = soup.build();
  EXPECT_EQ(complex.euler(), 1);
  EXPECT_EQ(complex.components, 1u);
  ASSERT_EQ(complex.patches.size(), 2u);
  for (const ComplexPatch& patch : complex.patches) EXPECT_EQ(patch.euler, 1);
  ASSERT_EQ(complex.corners.size(), 1u);
  EXPECT_EQ(complex.points[complex.corners[0]], (Point{0, 0, 0}));
  EXPECT_EQ(complex.corner_is_node[0], 0) << "nobody said so";
  // A single cone has a corner only if its tip is a node.
  SoupBuilder single;
  cone(single, {0, 0, 0}, 1);
  EXPECT_TRUE(single.build().corners.empty());
  single.soup.nodes = {3};  // the tip, of the second triangle
  complex = single.build();
  ASSERT_EQ(complex.corners.size(), 1u);
  EXPECT_EQ(complex.corner_is_node[0], 1);
}

TEST(FeatureComplex, AConeThatTouchesACurveMakesACorner) {
  SoupBuilder soup;
  square(soup, kReal, {0, 0, 0}, {0, -1, 0}, {1, -1, 0}, {1, 0, 0});
  cone(soup, {0, 0, 0}, 1);
  const FeatureComplex complex = soup.build();
  ASSERT_EQ(complex.corners.size(), 1u);
  EXPECT_EQ(complex.points[complex.corners[0]], (Point{0, 0, 0}));
  EXPECT_EQ(complex.components, 1u);
}

TEST(FeatureComplex, CollapsedCellsAreCounted) {
  SoupBuilder soup;
  square(soup, kReal, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  soup.triangle(kReal, {1, 1, 0}, {1, 1, 0}, {0, 1, 0});
  soup.segment({1, 1, 0}, {1, 1, 0});
  const FeatureComplex complex = soup.build();
  EXPECT_EQ(complex.collapsed, 2u);
  EXPECT_EQ(complex.euler(), 1);
  EXPECT_EQ(complex.triangles.size(), 2u);
}

/// A closed surface of one feature: the boundary of the unit cube.
SoupBuilder cube() {
  SoupBuilder soup;
  square(soup, kReal, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0});
  square(soup, kReal, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1});
  square(soup, kReal, {0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1});
  square(soup, kReal, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}, {1, 1, 0});
  square(soup, kReal, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0});
  square(soup, kReal, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1});
  return soup;
}

TEST(FeatureComplex, ClosedSurfaceCutByACurve) {
  SoupBuilder soup = cube();
  FeatureComplex complex = soup.build();
  EXPECT_EQ(complex.euler(), 2);
  ASSERT_EQ(complex.patches.size(), 1u);
  EXPECT_EQ(complex.patches[0].euler, 2);
  EXPECT_EQ(complex.patches[0].area, 6);
  EXPECT_TRUE(complex.curves.empty());
  // A wall of another page around the bottom edge loop cuts it in two.
  const std::array<Point, 4> loop = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  for (std::size_t i = 0; i < 4; ++i) soup.segment(loop[i], loop[(i + 1) % 4]);
  complex = soup.build();
  ASSERT_EQ(complex.patches.size(), 2u);
  EXPECT_EQ(complex.patches[0].euler, 1);
  EXPECT_EQ(complex.patches[1].euler, 1);
  ASSERT_EQ(complex.curves.size(), 1u);
  EXPECT_TRUE(complex.curves[0].closed);
  // An arc does not: the patch comes to it from both sides, and is a disc.
  SoupBuilder other = cube();
  other.segment(loop[0], loop[1]);
  complex = other.build();
  ASSERT_EQ(complex.patches.size(), 1u);
  EXPECT_EQ(complex.corners.size(), 2u);
}

TEST(FeatureComplex, NumberingDoesNotMatter) {
  SoupBuilder soup;
  wing(soup, kReal, 1, 0);
  wing(soup, kLinear, 0, 1);
  cone(soup, {0, 0, 2}, 5);
  const FeatureComplex one = soup.build();
  std::mt19937_64 random(3);
  std::vector<std::size_t> order(soup.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::shuffle(order, random);
  SoupBuilder turned;
  for (const std::size_t n : order) {
    const auto& [a, b, c] = soup.soup.triangles[n];
    const auto& p = soup.soup.points;
    turned.triangle(soup.triangles[n].first, p[b], p[c], p[a]);
  }
  const FeatureComplex two = turned.build();
  EXPECT_EQ(two.points.size(), one.points.size());
  EXPECT_EQ(two.edges, one.edges);
  EXPECT_EQ(two.patches.size(), one.patches.size());
  EXPECT_EQ(two.curves.size(), one.curves.size());
  EXPECT_EQ(two.corners.size(), one.corners.size());
}

TEST(FeatureComplex, BadInput) {
  SoupBuilder soup = cube();
  soup.build();
  soup.soup.certified.pop_back();
  EXPECT_THROW(feature_complex(soup.soup, standard_features()), std::invalid_argument);
  EXPECT_EQ(feature_complex({}, standard_features()).euler(), 0);
}

}  // namespace
}  // namespace triplex

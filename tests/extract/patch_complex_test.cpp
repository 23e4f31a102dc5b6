// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/extract/patch_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

Extraction extraction_of(const TensorField& field) {
  ExtractionOptions options;
  options.keep_patches = true;
  return extract(field, options);
}

class PatchComplexLaws : public testing::TestWithParam<const char*> {
 protected:
  static TensorField field() {
    GridOptions grid;
    grid.n = 3;
    grid.jitter = 0.2;
    return generator_named(GetParam())->generate(grid);
  }
};

TEST_P(PatchComplexLaws, BoundariesAreClosedLoops) {
  const TensorField input = field();
  const Extraction extraction = extraction_of(input);
  const PatchComplex& complex = *extraction.patches;
  ASSERT_GT(complex.patches.size(), 50u);
  for (const Patch& patch : complex.patches) {
    const auto boundary = complex.boundary(patch);
    ASSERT_GE(boundary.size(), 3u);
    std::set<std::uint32_t> starts;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const ArcUse& use = boundary[i];
      const ArcUse& next = boundary[(i + 1) % boundary.size()];
      const auto end = complex.arcs[use.arc].ends[use.reversed ? 0 : 1];
      EXPECT_EQ(end, complex.arcs[next.arc].ends[next.reversed ? 1 : 0]);
      EXPECT_TRUE(starts.insert(end).second) << "a corner twice";
    }
  }
}

TEST_P(PatchComplexLaws, ArcsOnFacesJoinAtMostTwoPatchesTheOppositeWay) {
  const TensorField input = field();
  const Extraction extraction = extraction_of(input);
  const PatchComplex& complex = *extraction.patches;
  std::map<std::uint32_t, std::vector<std::pair<const Patch*, bool>>> uses;
  for (const Patch& patch : complex.patches)
    for (const ArcUse& use : complex.boundary(patch)) {
      const PatchArc& arc = complex.arcs[use.arc];
      uses[use.arc].emplace_back(&patch, use.reversed);
      for (std::size_t i = 0; i < arc.vertices; ++i)
        EXPECT_NE(std::ranges::find(patch.cell, arc.carrier[i]), patch.cell.end());
      if (arc.vertices == 3) {
        EXPECT_EQ(arc.feature, patch.feature);
      }
      EXPECT_TRUE(arc.certified || !patch.certified);
    }
  EXPECT_EQ(uses.size(), complex.arcs.size());
  std::size_t inner = 0;
  for (const auto& [n, patches] : uses) {
    if (complex.arcs[n].vertices == 4) continue;
    ASSERT_LE(patches.size(), 2u);
    if (patches.size() < 2) continue;
    ++inner;
    EXPECT_NE(patches[0].first->cell, patches[1].first->cell);
    EXPECT_NE(patches[0].second, patches[1].second);
  }
  EXPECT_GT(2 * inner, uses.size());
}

// Six pages end on every arc of the triple degenerate curve.
TEST_P(PatchComplexLaws, AllPagesShareTheArcsOfTheCurve) {
  const TensorField input = field();
  const Extraction extraction = extraction_of(input);
  const PatchComplex& complex = *extraction.patches;
  std::map<std::uint32_t, std::set<Feature>> pages;
  for (const Patch& patch : complex.patches)
    for (const ArcUse& use : complex.boundary(patch))
      if (complex.arcs[use.arc].vertices == 4) pages[use.arc].insert(patch.feature);
  EXPECT_EQ(pages.size(), complex.curve.size());
  EXPECT_EQ(complex.curve.size(), extraction.mesh(Feature::TripleCurve).segments.size());
  for (const CurvePiece& piece : complex.curve)
    if (piece.certified) {
      EXPECT_EQ(pages[piece.use.arc].size(), 6u);
    }
}

TEST_P(PatchComplexLaws, CornersLieWhereTheirWeightsSay) {
  const TensorField input = field();
  const Extraction extraction = extraction_of(input);
  const PatchComplex& complex = *extraction.patches;
  for (const PatchCorner& corner : complex.corners) {
    Point x{};
    double sum = 0;
    for (std::size_t i = 0; i < corner.vertices; ++i) {
      const Point v = complex.field->position(corner.carrier[i]);
      for (std::size_t k = 0; k < 3; ++k) x[k] += corner.weights[i] * v[k];
      sum += corner.weights[i];
      EXPECT_GE(corner.weights[i], 0);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(x[k], corner.position[k], 1e-12 * (1 + std::fabs(x[k])));
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, PatchComplexLaws,
                         testing::Values("lorenz", "random-linear", "abc"), [](const auto& p) {
                           std::string name = p.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(PatchComplex, IsThereOnlyWhenAskedFor) {
  GridOptions grid;
  grid.n = 2;
  EXPECT_EQ(extract(generate_lorenz(grid)).patches, nullptr);
}

}  // namespace
}  // namespace triplex

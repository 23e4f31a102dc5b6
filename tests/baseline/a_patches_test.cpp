// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/baseline/a_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

TensorField abc(int n) {
  GridOptions grid;
  grid.n = n;
  grid.jitter = 0.1;
  return generate_abc(grid);
}

/// The seven features, a mode page, and all kinds of level sets.
APatchOptions all_features() {
  APatchOptions options;
  options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  options.table.add_magnitude(1.2);
  options.table.add_isotropicity(0.3);
  options.table.add_traceless();
  options.features = options.table.all();
  return options;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return x == y || (std::isnan(x) && std::isnan(y));
         });
}

void expect_same(const FeatureMesh& a, const FeatureMesh& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.segments, b.segments);
  EXPECT_EQ(a.source_cell, b.source_cell);
  EXPECT_EQ(a.certified, b.certified);
  EXPECT_TRUE(same_bits(a.p, b.p) && same_bits(a.q, b.q) && same_bits(a.mode, b.mode));
}

TEST(APatches, SameBytesForAnyNumberOfThreads) {
  const TensorField field = abc(14);  // several runs of tets
  APatchOptions options = all_features();
  options.threads = 1;
  APatchStatistics one_counts, four_counts;
  const Approximation one = extract_a_patches(field, options, &one_counts);
  options.threads = 4;
  const Approximation four = extract_a_patches(field, options, &four_counts);
  for (std::size_t f = 0; f < one.features.size(); ++f)
    expect_same(one.features[f], four.features[f]);
  EXPECT_EQ(one.given_up, four.given_up);
  EXPECT_EQ(one_counts.features, four_counts.features);
}

TEST(APatches, ScalingByAPowerOfTwoChangesUnitsOnly) {
  TensorField field = abc(6);
  const APatchOptions options;
  const Approximation plain = extract_a_patches(field, options);
  for (const int exponent : {-300, 40, 500}) {
    TensorField scaled = field;
    for (auto& t : scaled.tensors)
      for (double& entry : t) entry = std::ldexp(entry, exponent);
    Approximation result = extract_a_patches(scaled, options);
    for (std::size_t f = 0; f < result.features.size(); ++f) {
      FeatureMesh& mesh = result.features[f];
      EXPECT_EQ(mesh.points, plain.features[f].points);
      EXPECT_EQ(mesh.triangles, plain.features[f].triangles);
      EXPECT_EQ(mesh.segments, plain.features[f].segments);
      if (exponent != 40) continue;
      for (double& p : mesh.p) p = std::ldexp(p, -2 * exponent);
      for (double& q : mesh.q) q = std::ldexp(q, -3 * exponent);
      EXPECT_TRUE(same_bits(mesh.p, plain.features[f].p) && same_bits(mesh.q, plain.features[f].q));
    }
    EXPECT_EQ(result.given_up, plain.given_up);
  }
}

TEST(APatches, NothingWhereNothingIs) {
  GridOptions grid;
  grid.n = 4;
  const TensorField field = generate_constant(grid);
  APatchOptions options = all_features();
  APatchStatistics statistics;
  const Approximation result = extract_a_patches(field, options, &statistics);
  EXPECT_TRUE(result.given_up.empty());
  for (const FeatureRow& row : result.table.rows()) {
    const FeatureMesh& mesh = result.mesh(row.feature);
    EXPECT_TRUE(mesh.points.empty() && mesh.triangles.empty() && mesh.segments.empty());
    APatchCounts expected;
    if (row.kind != FeatureKind::Curve) expected.excluded = field.mesh.tets.size();
    EXPECT_EQ(statistics.features[index(row.feature)], expected) << row.name;
  }
}

/// Every tet is excluded or the root of a binary tree of halves.
TEST(APatches, CountsAddUp) {
  const TensorField field = abc(8);
  const std::uint64_t tets = field.mesh.tets.size();
  for (const PatchTest patch_test : {PatchTest::Layers, PatchTest::LayersOrGrowth}) {
    APatchOptions options = all_features();
    options.patch_test = patch_test;
    APatchStatistics statistics;
    const Approximation result = extract_a_patches(field, options, &statistics);
    for (const FeatureRow& row : result.table.rows()) {
      const APatchCounts& n = statistics.features[index(row.feature)];
      if (row.kind == FeatureKind::Curve) {
        EXPECT_EQ(n.three_sided + n.given_up > 0, !result.mesh(row.feature).segments.empty());
        continue;
      }
      EXPECT_EQ(n.three_sided + n.four_sided + n.excluded_parts + n.given_up,
                n.subdivided + tets - n.excluded)
          << row.name;
      EXPECT_GT(n.excluded, 0u);
    }
    EXPECT_GT(statistics.features[index(Feature::DegenerateLinear)].subdivided, 0u);
  }
}

TEST(APatches, GrowthHalvesLess) {
  const TensorField field = abc(8);
  APatchOptions options;
  APatchStatistics layers, growth;
  options.patch_test = PatchTest::Layers;
  extract_a_patches(field, options, &layers);
  options.patch_test = PatchTest::LayersOrGrowth;
  extract_a_patches(field, options, &growth);
  for (const Feature f : {Feature::NeutralReal, Feature::DegenerateLinear})
    EXPECT_LT(1.25 * static_cast<double>(growth.features[index(f)].subdivided),
              static_cast<double>(layers.features[index(f)].subdivided));
}

TEST(APatches, OnlyWhatIsAskedFor) {
  const TensorField field = abc(6);
  const Approximation all = extract_a_patches(field);
  for (const FeatureRow& row : standard_features().rows()) {
    APatchOptions options;
    options.features = bit(row.feature);
    const Approximation one = extract_a_patches(field, options);
    EXPECT_EQ(one.requested, options.features);
    for (std::size_t f = 0; f < one.features.size(); ++f) {
      if (f == index(row.feature))
        expect_same(one.features[f], all.features[f]);
      else
        EXPECT_TRUE(one.features[f].points.empty());
    }
    std::vector<GivenUp> expected = all.given_up;
    std::erase_if(expected, [&](const GivenUp& g) { return g.feature != row.feature; });
    EXPECT_EQ(one.given_up, expected) << row.name;
  }
}

TEST(APatches, SourceCellsAreThoseOfTheFile) {
  TensorField field = abc(5);
  const Approximation plain = extract_a_patches(field);
  for (std::size_t n = 0; n < field.mesh.tets.size(); ++n)
    field.source_cells.push_back(static_cast<std::int64_t>(3 * n + 5));
  const Approximation renamed = extract_a_patches(field);
  for (std::size_t f = 0; f < plain.features.size(); ++f) {
    auto cells = plain.features[f].source_cell;
    for (auto& cell : cells) cell = 3 * cell + 5;
    EXPECT_EQ(cells, renamed.features[f].source_cell);
  }
  ASSERT_EQ(plain.given_up.size(), renamed.given_up.size());
  for (std::size_t n = 0; n < plain.given_up.size(); ++n)
    EXPECT_EQ(3 * plain.given_up[n].source_cell + 5, renamed.given_up[n].source_cell);
}

TEST(APatches, EmptyMesh) {
  const Approximation result = extract_a_patches(TensorField{});
  EXPECT_TRUE(result.given_up.empty());
  EXPECT_EQ(result.features.size(), 7u);
}

TEST(APatches, RefusesOptionsOutOfRange) {
  const TensorField field = abc(2);
  APatchOptions options;
  options.samples = 0;
  EXPECT_THROW(extract_a_patches(field, options), std::invalid_argument);
  options.samples = 65;
  EXPECT_THROW(extract_a_patches(field, options), std::invalid_argument);
  options.samples = 1;
  options.max_depth = -1;
  EXPECT_THROW(extract_a_patches(field, options), std::invalid_argument);
  options.max_depth = 61;
  EXPECT_THROW(extract_a_patches(field, options), std::invalid_argument);
}

TEST(APatches, StopsWhenInterrupted) {
  const TensorField field = abc(4);
  std::atomic<bool> interrupted = false;
  APatchOptions options;
  options.interrupted = &interrupted;
  std::vector<std::string> steps;
  options.progress = [&](std::string_view step, double) {
    steps.emplace_back(step);
    interrupted = true;  // during the first step
  };
  EXPECT_THROW(extract_a_patches(field, options), Interrupted);
  EXPECT_EQ(steps, std::vector<std::string>{"patches"});
}

}  // namespace
}  // namespace triplex

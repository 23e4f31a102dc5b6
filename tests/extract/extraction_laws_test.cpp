// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What must not change, and what must change how, when the input is told in another way.
#include <gtest/gtest.h>

#include <immintrin.h>

#include <cfenv>
#include <cmath>
#include <cstring>

#include "fields.hpp"

namespace triplex {
namespace {

using test::geometry;
using test::mesh_of;

ExtractionOptions quick(unsigned threads = 0) {
  ExtractionOptions options;
  options.max_bisections = 8;  // hard cells stay open early: they must obey the laws too
  options.threads = threads;
  return options;
}

TensorField sample_field() {
  GridOptions grid;
  grid.n = 7;
  grid.jitter = 0.2;
  return generate_rayleigh_benard(grid);
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST(ExtractionLaws, ThreadsDoNotChangeABit) {
  const TensorField field = sample_field();
  const Extraction one = extract(field, quick(1)), two = extract(field, quick(2));
  ASSERT_FALSE(mesh_of(one, Feature::DegenerateLinear).triangles.empty());
  ASSERT_FALSE(mesh_of(one, Feature::TripleCurve).segments.empty());
  for (int f = 0; f < kStandardFeatures; ++f) {
    const FeatureMesh &a = one.features[f], &b = two.features[f];
    EXPECT_TRUE(same_bytes(a.points, b.points));
    EXPECT_TRUE(same_bytes(a.triangles, b.triangles));
    EXPECT_TRUE(same_bytes(a.segments, b.segments));
    EXPECT_TRUE(same_bytes(a.p, b.p));
    EXPECT_TRUE(same_bytes(a.q, b.q));
    EXPECT_TRUE(same_bytes(a.source_cell, b.source_cell));
    EXPECT_TRUE(same_bytes(a.certified, b.certified));
  }
  EXPECT_EQ(one.sign_stages, two.sign_stages);
}

TEST(ExtractionLaws, NumberingDoesNotMatter) {
  const TensorField field = sample_field();
  const Extraction a = extract(field, quick());
  const Extraction b = extract(test::relabelled(field, 20240229), quick());
  for (int f = 0; f < kStandardFeatures; ++f) {
    EXPECT_TRUE(geometry(a.features[f]) == geometry(b.features[f]))
        << standard_features().rows()[f].name;
  }
  EXPECT_EQ(a.unresolved.size(), b.unresolved.size());
  EXPECT_EQ(a.refinement.bisections, b.refinement.bisections);
}

TEST(ExtractionLaws, ScalingByPowersOfTwoChangesNothing) {
  const TensorField field = sample_field();
  const Extraction a = extract(field, quick());
  for (const int exponent : {-900, -60, 1, 70, 990}) {
    const auto scaled = [exponent](Tensor<double> t) {
      for (double& x : t) x = std::ldexp(x, exponent);
      return t;
    };
    const Extraction b = extract(test::mapped(field, scaled), quick());
    for (int f = 0; f < kStandardFeatures; ++f) {
      EXPECT_TRUE(a.features[f].triangles == b.features[f].triangles) << "2^" << exponent;
      EXPECT_TRUE(a.features[f].certified == b.features[f].certified) << "2^" << exponent;
      EXPECT_TRUE(geometry(a.features[f]) == geometry(b.features[f])) << "2^" << exponent;
    }
  }
}

/// Features of -A are those of A with linear and planar exchanged. On a generic field, as -(A + eps
/// B) is not -A + eps B.
TEST(ExtractionLaws, NegationExchangesLinearAndPlanar) {
  GridOptions grid;
  grid.n = 5;
  const TensorField field = generate_noise(grid);
  const Extraction a = extract(field, quick());
  const Extraction b = extract(test::mapped(field, test::negated), quick());
  const std::array<std::array<Feature, 2>, 4> pairs = {
      {{Feature::DegenerateLinear, Feature::DegeneratePlanar},
       {Feature::BalancedLinear, Feature::BalancedPlanar},
       {Feature::NeutralReal, Feature::NeutralReal},
       {Feature::NeutralComplex, Feature::NeutralComplex}}};
  for (const auto& [f, g] : pairs) {
    EXPECT_TRUE(geometry(mesh_of(a, f)) == geometry(mesh_of(b, g)))
        << standard_features().row(f).name;
    EXPECT_TRUE(geometry(mesh_of(a, g)) == geometry(mesh_of(b, f)))
        << standard_features().row(g).name;
  }
  EXPECT_EQ(a.unresolved.size(), b.unresolved.size());
}

/// Transposition permutes the terms of the sums, so roundings differ; what is certified does not.
/// On a generic field, as (A + eps B)^T is not A^T + eps B, and symmetric ones have ties between
/// edges to bisect.
TEST(ExtractionLaws, TranspositionKeepsTheFeatures) {
  GridOptions grid;
  grid.n = 5;
  const TensorField field = generate_noise(grid);
  const Extraction a = extract(field, quick());
  const Extraction b = extract(test::mapped(field, test::transposed), quick());
  for (int f = 0; f < kStandardFeatures; ++f) {
    EXPECT_EQ(a.features[f].triangles.size(), b.features[f].triangles.size());
    EXPECT_EQ(a.features[f].points.size(), b.features[f].points.size());
  }
  EXPECT_EQ(a.refinement.tets, b.refinement.tets);
}

TEST(ExtractionLaws, OneFeatureAloneIsTheSameSurfaceAsAmongAll) {
  GridOptions grid;
  grid.n = 8;
  grid.jitter = 0.1;
  const TensorField field = generate_lorenz(grid);
  const Extraction all = extract(field, {});
  for (int f = 0; f < kStandardFeatures; ++f) {
    ExtractionOptions options;
    options.features = bit(static_cast<Feature>(f));
    const Extraction alone = extract(field, options);
    for (int g = 0; g < kStandardFeatures; ++g) EXPECT_EQ(alone.features[g].points.empty(), g != f);
    const auto triangles = alone.features[f].triangles.size() + alone.features[f].segments.size();
    EXPECT_GT(triangles, 0u);
    // Fewer certificates need less refinement.
    EXPECT_LE(alone.refinement.tets, all.refinement.tets);
  }
}

/// A host program may have changed rounding or flush denormals, in its own thread and TBB's.
TEST(ExtractionLaws, TheHostsFloatingPointSettingsDoNotMatter) {
  const TensorField field = sample_field();
  const Extraction a = extract(field, quick(2));
  std::fesetround(FE_UPWARD);
  const unsigned control = _mm_getcsr();
  _mm_setcsr(control | 0x8040);  // flush to zero, denormals are zero
  const Extraction b = extract(field, quick(2));
  EXPECT_EQ(_mm_getcsr() & 0xffc0u, (control | 0x8040u) & 0xffc0u);  // as the host left it
  _mm_setcsr(control);
  std::fesetround(FE_TONEAREST);
  for (int f = 0; f < kStandardFeatures; ++f) {
    EXPECT_TRUE(same_bytes(a.features[f].points, b.features[f].points));
    EXPECT_TRUE(same_bytes(a.features[f].triangles, b.features[f].triangles));
  }
  EXPECT_EQ(a.sign_stages, b.sign_stages);
}

TEST(ExtractionLaws, InterruptionStops) {
  std::atomic<bool> interrupted = true;
  ExtractionOptions options;
  options.interrupted = &interrupted;
  EXPECT_THROW(extract(sample_field(), options), Interrupted);
}

}  // namespace
}  // namespace triplex

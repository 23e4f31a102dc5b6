// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What must not change, and what must change how, when the input is told in another way.
#include <gtest/gtest.h>

#include <immintrin.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <map>

#include "fields.hpp"
#include "triplex/topology/surface_topology.hpp"

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

constexpr FeatureSet kDegenerateSurfaces =
    bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);

ExtractionOptions only(FeatureSet features, std::uint32_t max_bisections) {
  ExtractionOptions options;
  options.features = features;
  options.max_bisections = max_bisections;
  return options;
}

/// The surface in each tet of the input that is certified for it.
std::map<std::int64_t, SurfaceTopology> surface_by_tet(const TensorField& field,
                                                       const Extraction& e, Feature f) {
  const FeatureMesh& mesh = mesh_of(e, f);
  std::map<std::int64_t, std::vector<std::array<std::uint32_t, 3>>> triangles;
  for (std::size_t t = 0; t < field.mesh.tets.size(); ++t) triangles[static_cast<std::int64_t>(t)];
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n)
    triangles[mesh.source_cell[n]].push_back(mesh.triangles[n]);
  for (const UnresolvedTet& open : e.unresolved)
    if (open.features & bit(f)) triangles.erase(open.source_cell);
  std::map<std::int64_t, SurfaceTopology> topology;
  for (const auto& [tet, t] : triangles) topology[tet] = surface_topology(t, mesh.points.size());
  return topology;
}

/// Smooth enough that most tets are certified, with four nodes on each degenerate surface.
TensorField field_with_nodes() {
  GridOptions grid;
  grid.n = 8;
  grid.jitter = 0.2;
  // Off the planes of symmetry: the perturbation that decides ties is not mapped with the field.
  grid.box = Box{{0.1, 0.2, 0.3}, {6.383, 6.483, 6.583}};
  return generate_abc(grid);
}

/// Witnesses of nappe certificates come from an eigenvalue solver, whose roundings obey no
/// symmetry, so one of two such fields may be refined more. What holds is the topology: in every
/// tet that is certified both times it is the same; and nearly all tets are certified both times or
/// neither.
void expect_same_topology_where_certified(const TensorField& field, const Extraction& a, Feature f,
                                          const Extraction& b, Feature g) {
  const auto first = surface_by_tet(field, a, f), second = surface_by_tet(field, b, g);
  std::size_t common = 0, surfaces = 0, several = 0, cones = 0;
  for (const auto& [tet, x] : first) {
    const auto found = second.find(tet);
    if (found == second.end()) continue;
    const SurfaceTopology& y = found->second;
    ++common;
    surfaces += x.triangles > 0;
    several += x.components > 1 || x.euler != 1;
    cones += x.nonmanifold_vertices > 0;
    EXPECT_EQ(x.components, y.components) << "tet " << tet;
    EXPECT_EQ(x.euler, y.euler) << "tet " << tet;
    EXPECT_EQ(x.boundary_loops, y.boundary_loops) << "tet " << tet;
    EXPECT_EQ(x.nonmanifold_vertices, y.nonmanifold_vertices) << "tet " << tet;
  }
  EXPECT_GT(common, field.mesh.tets.size() * 9 / 10);
  EXPECT_LE(first.size() + second.size() - 2 * common, field.mesh.tets.size() / 500);
  EXPECT_GT(surfaces, field.mesh.tets.size() / 20);
  EXPECT_GT(several, 5u);  // not all are single discs
  EXPECT_GT(cones, 0u);
}

/// Features of -A are those of A with linear and planar exchanged. On a generic field, as -(A + eps
/// B) is not -A + eps B.
TEST(ExtractionLaws, NegationExchangesLinearAndPlanar) {
  GridOptions grid;
  grid.n = 5;
  const TensorField field = generate_noise(grid);
  const TensorField negative = test::mapped(field, test::negated);
  // Signs of p and q, of their derivatives, and the edges to bisect: to the bit.
  const ExtractionOptions others = only(kStandardSet & ~kDegenerateSurfaces, 8);
  const Extraction a = extract(field, others), b = extract(negative, others);
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar, Feature::NeutralReal,
                          Feature::NeutralComplex}) {
    EXPECT_FALSE(mesh_of(a, f).triangles.empty());
    EXPECT_TRUE(geometry(mesh_of(a, f)) == geometry(mesh_of(b, test::of_negative(f))))
        << standard_features().row(f).name;
  }
  EXPECT_EQ(a.unresolved.size(), b.unresolved.size());
  EXPECT_EQ(a.refinement.bisections, b.refinement.bisections);

  const TensorField smooth = field_with_nodes();
  const ExtractionOptions degenerate = only(kDegenerateSurfaces, 64);
  const Extraction c = extract(smooth, degenerate);
  const Extraction d = extract(test::mapped(smooth, test::negated), degenerate);
  expect_same_topology_where_certified(smooth, c, Feature::DegenerateLinear, d,
                                       Feature::DegeneratePlanar);
  expect_same_topology_where_certified(smooth, c, Feature::DegeneratePlanar, d,
                                       Feature::DegenerateLinear);
}

/// Transposition permutes the terms of the sums, so roundings differ; what is certified does not.
/// On a generic field, as (A + eps B)^T is not A^T + eps B, and symmetric ones have ties between
/// edges to bisect.
TEST(ExtractionLaws, TranspositionKeepsTheFeatures) {
  GridOptions grid;
  grid.n = 5;
  const TensorField field = generate_noise(grid);
  const TensorField transposed = test::mapped(field, test::transposed);
  const ExtractionOptions others = only(kStandardSet & ~kDegenerateSurfaces, 8);
  const Extraction a = extract(field, others), b = extract(transposed, others);
  for (int f = 0; f < kStandardFeatures; ++f) {
    EXPECT_EQ(a.features[f].triangles.size(), b.features[f].triangles.size());
    EXPECT_EQ(a.features[f].points.size(), b.features[f].points.size());
  }
  EXPECT_EQ(a.refinement.tets, b.refinement.tets);

  const TensorField smooth = field_with_nodes();
  const ExtractionOptions degenerate = only(kDegenerateSurfaces, 64);
  const Extraction c = extract(smooth, degenerate);
  const Extraction d = extract(test::mapped(smooth, test::transposed), degenerate);
  for (const Feature f : {Feature::DegenerateLinear, Feature::DegeneratePlanar})
    expect_same_topology_where_certified(smooth, c, f, d, f);
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

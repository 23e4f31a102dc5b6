// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes within a tolerance on domains whose opposite sides are one.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "../extract/periodic_fields.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/meshing/mesh_patches.hpp"
#include "triplex/meshing/wish_for_charts.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

using test::glued;
using test::periodic_noise;

constexpr PeriodicAxes kAll = {true, true, true};

struct Meshed {
  Extraction extraction;
  MeshedPatches patches;
};
Meshed meshed(const TensorField& field, const PeriodicAxes& axes, const Tolerance& tolerance) {
  ExtractionOptions options;
  options.periodic = axes;
  options.keep_patches = true;
  options.max_bisections = 6;
  const Feature mode = options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  const Feature level = options.table.add_magnitude(1.6);
  options.features |= bit(mode) | bit(level);
  options.wish = wish_for_charts(field, options.table, tolerance);
  Meshed result;
  result.extraction = extract(field, options);
  MeshingOptions meshing;
  meshing.tolerance = tolerance;
  result.patches = mesh_patches(field, *result.extraction.patches, meshing);
  return result;
}

/// On a torus the pages have no boundary but the curve, however finely their arcs are sampled.
TEST(PeriodicPatches, PagesEndOnlyOnTheCurve) {
  const auto [extraction, patches] = meshed(periodic_noise(3, kAll), kAll, {0.01, true});
  const FeatureMesh& curve = patches.features[index(Feature::TripleCurve)];
  ASSERT_GT(curve.segments.size(), extraction.mesh(Feature::TripleCurve).segments.size());
  const CurveTopology along = curve_topology(glued(curve.segments, curve), curve.points.size());
  EXPECT_EQ(along.ends, 0u);
  for (const FeatureRow& row : extraction.table.rows()) {
    if (row.kind == FeatureKind::Curve) continue;
    SCOPED_TRACE(row.name);
    const FeatureMesh& mesh = patches.features[index(row.feature)];
    const FeatureMesh& coarse = extraction.mesh(row.feature);
    ASSERT_GT(mesh.triangles.size(), coarse.triangles.size());
    const SurfaceTopology t = surface_topology(glued(mesh.triangles, mesh), mesh.points.size());
    const SurfaceTopology c =
        surface_topology(glued(coarse.triangles, coarse), coarse.points.size());
    EXPECT_EQ(t.boundary_edges, row.kind == FeatureKind::Page ? curve.segments.size() : 0);
    EXPECT_EQ(t.nonmanifold_edges, 0u);
    EXPECT_EQ(t.orientation_conflicts, 0u);
    EXPECT_EQ(t.components, c.components);
    EXPECT_EQ(t.euler, c.euler);
  }
}

/// One of two sides of a patch's tet may ask for more: its copy must get it too.
TEST(PeriodicPatches, CopiesMatchBitForBit) {
  const PeriodicAxes axes = {true, false, true};
  const TensorField field = periodic_noise(3, axes);
  auto [extraction, patches] = meshed(field, axes, {0.01, true});
  std::size_t copies = 0, coarse = 0;
  for (const FeatureRow& row : extraction.table.rows()) {
    SCOPED_TRACE(row.name);
    copies += test::expect_copies_match(patches.features[index(row.feature)], axes);
    coarse += test::expect_copies_match(extraction.mesh(row.feature), axes);
  }
  EXPECT_GT(copies, coarse);
}

TEST(PeriodicPatches, RefinementOfOnePatchReachesTheOtherSide) {
  const TensorField field = periodic_noise(3, kAll);
  ExtractionOptions options;
  options.periodic = kAll;
  options.keep_patches = true;
  options.max_bisections = 6;
  const Extraction extraction = extract(field, options);
  const PatchComplex& complex = *extraction.patches;
  MeshingOptions meshing_options;
  meshing_options.tolerance = Tolerance{0.1, true};
  PatchMeshing meshing(field, complex, meshing_options);
  const MeshedPatches before = meshing.mesh();
  // The first patches with an arc that is a copy, of one feature. (A single one may be too small.)
  std::vector<std::uint32_t> chosen;
  const auto has_copy = [&](const Patch& patch) {
    return std::ranges::any_of(complex.boundary(patch), [&](const ArcUse& use) {
      return complex.arc_originals[use.arc].arc != use.arc;
    });
  };
  for (std::uint32_t n = 0; n < complex.patches.size() && chosen.size() < 4; ++n)
    if (has_copy(complex.patches[n]) &&
        (chosen.empty() || complex.patches[n].feature == complex.patches[chosen[0]].feature))
      chosen.push_back(n);
  ASSERT_EQ(chosen.size(), 4u);
  meshing.refine(chosen);
  const MeshedPatches after = meshing.mesh();
  const std::size_t f = index(complex.patches[chosen[0]].feature);
  EXPECT_GT(after.features[f].triangles.size(), before.features[f].triangles.size());
  const FeatureMesh& mesh = after.features[f];
  test::expect_copies_match(mesh, kAll);
  const SurfaceTopology t = surface_topology(glued(mesh.triangles, mesh), mesh.points.size());
  EXPECT_EQ(t.boundary_edges, after.features[index(Feature::TripleCurve)].segments.size());
  EXPECT_EQ(t.nonmanifold_edges, 0u);
}

/// At a vertex whose deviator is zero the surfaces are cones; copies of it are one point of each,
/// also of those that do not meet the lowest copy.
TEST(PeriodicPatches, IsotropicVerticesAreOnePointOfEachPage) {
  TensorField field = periodic_noise(3, kAll);
  test::set_isotropic_corner(field, 3);
  const auto [extraction, patches] = meshed(field, kAll, {0.02, true});
  const FeatureMesh& curve = patches.features[index(Feature::TripleCurve)];
  const auto is_copy = [](const Point& x) {
    return std::ranges::all_of(x, [](double c) { return c == 0 || c == 1; });
  };
  std::size_t most = 0;
  for (const FeatureRow& row : extraction.table.rows()) {
    if (row.kind != FeatureKind::Page) continue;
    SCOPED_TRACE(row.name);
    const FeatureMesh& mesh = patches.features[index(row.feature)];
    std::set<std::uint32_t> originals;
    std::size_t copies = 0;
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
      if (is_copy(mesh.points[v])) {
        ++copies;
        originals.insert(mesh.identified[v]);
        EXPECT_NE(mesh.points[v], (Point{0, 0, 0}));
      }
    most = std::max(most, copies);
    EXPECT_EQ(originals.size(), 1u);
    const SurfaceTopology t = surface_topology(glued(mesh.triangles, mesh), mesh.points.size());
    EXPECT_EQ(t.boundary_edges, curve.segments.size());
    EXPECT_EQ(t.nonmanifold_edges, 0u);
    EXPECT_EQ(t.orientation_conflicts, 0u);
  }
  EXPECT_GT(most, 2u);
}

}  // namespace
}  // namespace triplex

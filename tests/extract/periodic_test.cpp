// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Domains whose opposite sides are one.
#include <gtest/gtest.h>

#include <set>

#include <cmath>
#include <map>

#include "isotropic_fields.hpp"
#include "periodic_fields.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

constexpr PeriodicAxes kAll = {true, true, true};

using test::glued;
using test::periodic_noise;

/// The curve of the Arnold-Beltrami-Childress flow has six closed components on the 3-torus.
TEST(Periodic, TheCurveOfAbcClosesOnTheTorus) {
  GridOptions grid;
  grid.n = 10;
  grid.jitter = 0.1;
  ExtractionOptions options;
  options.periodic = kAll;
  const Extraction result = extract(generate_abc(grid), options);
  const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
  const CurveTopology t = curve_topology(glued(curve.segments, curve), curve.points.size());
  EXPECT_EQ(t.components, 6u);
  EXPECT_EQ(t.closed, 6u);
  EXPECT_EQ(t.ends, 0u);
  options.periodic = {};
  const Extraction cut = extract(generate_abc(grid), options);
  EXPECT_TRUE(cut.mesh(Feature::TripleCurve).identified.empty());
  EXPECT_GT(curve_topology(cut.mesh(Feature::TripleCurve).segments,
                           cut.mesh(Feature::TripleCurve).points.size())
                .ends,
            0u);
}

/// On a torus the pages have no boundary but the curve, to which each is attached once all along,
/// certified or not.
TEST(Periodic, PagesEndOnlyOnTheCurve) {
  ExtractionOptions options;
  options.periodic = kAll;
  options.max_bisections = 6;
  const Feature mode = options.table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  const Feature level = options.table.add_magnitude(1.6);
  options.features |= bit(mode) | bit(level);
  const Extraction result = extract(periodic_noise(4, kAll), options);
  EXPECT_GT(result.refinement.bisections, 100u);
  const std::size_t spine = result.mesh(Feature::TripleCurve).segments.size();
  ASSERT_GT(spine, 100u);
  for (const FeatureRow& row : result.table.rows()) {
    if (row.kind == FeatureKind::Curve) continue;
    const FeatureMesh& mesh = result.mesh(row.feature);
    ASSERT_GT(mesh.triangles.size(), 100u) << row.name;
    const SurfaceTopology t = surface_topology(glued(mesh.triangles, mesh), mesh.points.size());
    EXPECT_EQ(t.boundary_edges, row.kind == FeatureKind::Page ? spine : 0) << row.name;
    EXPECT_EQ(t.nonmanifold_edges, 0u) << row.name;
    EXPECT_EQ(t.orientation_conflicts, 0u) << row.name;
  }
}

TEST(Periodic, CopiesMatchBitForBit) {
  ExtractionOptions options;
  options.periodic = {true, false, true};
  options.max_bisections = 6;
  const Extraction result = extract(periodic_noise(4, options.periodic), options);
  std::size_t copies = 0;
  for (const FeatureRow& row : result.table.rows()) {
    SCOPED_TRACE(row.name);
    const FeatureMesh& mesh = result.mesh(row.feature);
    copies += test::expect_copies_match(mesh, options.periodic);
    EXPECT_EQ(test::count_lonely(mesh, options.periodic), 0u);
    for (std::uint32_t v = 0; v < mesh.identified.size(); ++v) {
      EXPECT_EQ(mesh.p[v], mesh.p[mesh.identified[v]]);
      EXPECT_EQ(mesh.q[v], mesh.q[mesh.identified[v]]);
    }
  }
  EXPECT_GT(copies, 100u);
}

std::string refusal(const TensorField& field, const PeriodicAxes& axes) {
  try {
    find_periodic_pairs(field, axes);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}
bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Periodic, SidesThatDoNotCorrespondAreRefused) {
  const PeriodicAxes along_y = {false, true, false};
  EXPECT_EQ(refusal(periodic_noise(3, kAll), kAll), "");
  EXPECT_EQ(refusal(periodic_noise(3, along_y), along_y), "");
  EXPECT_TRUE(mentions(refusal(periodic_noise(3, along_y), kAll), "their tensors differ"));
  EXPECT_TRUE(mentions(refusal(periodic_noise(2, kAll), kAll), "three layers"));

  TensorField moved = periodic_noise(3, along_y);
  for (Point& x : moved.mesh.points)
    if (x[1] == 1 && x[0] > 0.1 && x[0] < 0.9) x[0] += 0.01;
  EXPECT_TRUE(mentions(refusal(moved, along_y), "no partner"));

  GridOptions grid;
  grid.n = 3;
  grid.split = CellSplit::Five;  // mirrored from cell to cell: the sides of odd grids differ
  TensorField field = generate_constant(grid);
  EXPECT_TRUE(mentions(refusal(field, along_y), "triangles"));
  grid.n = 4;
  EXPECT_EQ(refusal(generate_constant(grid), along_y), "");
}

TEST(Periodic, PairsAreAllPointsOfTheSides) {
  const auto pairs = find_periodic_pairs(periodic_noise(3, kAll), {true, false, true});
  EXPECT_EQ(pairs[0].size(), 16u);
  EXPECT_TRUE(pairs[1].empty());
  EXPECT_EQ(pairs[2].size(), 16u);
  for (const auto& [low, high] : pairs[0]) EXPECT_EQ(high, low + 3);
  for (const auto& [low, high] : pairs[2]) EXPECT_EQ(high, low + 3 * 16);
}

/// On sides that are one: copies of the vertex, and one point of each page for them all.
TEST(Periodic, CopiesOfAnIsotropicVertexAreOne) {
  for (const auto& [axes, vertex] : {std::pair{kAll, 0u}, {PeriodicAxes{true, false, true}, 20u}}) {
    TensorField field = test::periodic_noise(3, axes);
    if (vertex == 0) {
      test::set_isotropic_corner(field, 3);
    } else {
      field.tensors[vertex] = test::kIsotropic;
      make_periodic(field, 3, axes);
    }
    ExtractionOptions options;
    options.periodic = axes;
    options.keep_patches = true;
    options.max_bisections = 100;
    const Extraction result = extract(field, options);
    const auto is_copy = [&](const Point& x) {
      for (std::size_t k = 0; k < 3; ++k)
        if ((axes[k] && x[k] == 1 ? 0 : x[k]) != field.mesh.points[vertex][k]) return false;
      return true;
    };
    std::size_t vertices = 0;
    for (const Point& x : field.mesh.points) vertices += is_copy(x);
    EXPECT_GT(vertices, 1u);
    for (const auto& tet : result.open_cells.tets)
      for (const std::uint32_t v : tet) EXPECT_FALSE(is_copy(result.open_cells.points[v]));
    std::size_t found = 0;
    for (const FeatureRow& row : result.table.rows()) {
      SCOPED_TRACE(row.name);
      const FeatureMesh& mesh = result.mesh(row.feature);
      ASSERT_EQ(mesh.identified.size(), mesh.points.size());
      std::set<std::uint32_t> originals;
      for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
        if (!is_copy(mesh.points[v])) {
          const Point &x = mesh.points[v], &y = mesh.points[mesh.identified[v]];
          for (const std::size_t k : {0u, 1u, 2u}) EXPECT_EQ(y[k], axes[k] && x[k] == 1 ? 0 : x[k]);
        } else {
          ++found;
          originals.insert(mesh.identified[v]);
          if (vertex == 0) {
            EXPECT_NE(mesh.points[v], (Point{0, 0, 0}));
          }
          EXPECT_EQ(std::ranges::count(mesh.nodes, v), 1);
        }
      EXPECT_LE(originals.size(), 1u);
      if (row.kind != FeatureKind::Page) continue;
      const SurfaceTopology t = surface_topology(glued(mesh.triangles, mesh), mesh.points.size());
      if (axes == kAll) {
        EXPECT_EQ(t.boundary_edges, result.mesh(Feature::TripleCurve).segments.size());
      }
      EXPECT_EQ(t.nonmanifold_edges, 0u);
      EXPECT_EQ(t.orientation_conflicts, 0u);
    }
    EXPECT_GT(found, 0u);
    const PatchComplex& complex = *result.patches;
    ASSERT_EQ(complex.corner_originals.size(), complex.corners.size());
    std::set<std::uint32_t> originals;
    for (std::uint32_t n = 0; n < complex.corners.size(); ++n)
      if (is_copy(complex.corners[n].position)) originals.insert(complex.corner_originals[n]);
    EXPECT_EQ(originals.size(), 1u);
  }
}

}  // namespace
}  // namespace triplex

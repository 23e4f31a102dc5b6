// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/quadric_comparison.hpp"

#include <gtest/gtest.h>

#include "triplex/field/generators.hpp"

namespace triplex {
namespace {

struct Case {
  TensorField field;
  QuadricExtraction quadrics;

  Case() {
    GridOptions grid;
    grid.n = 3;
    field = generate_noise(grid);
    quadrics = extract_quadric(field, standard_features().row(Feature::BalancedLinear));
  }
};

/// The mesh without the triangles of one cell.
FeatureMesh without(const FeatureMesh& mesh, std::int64_t cell) {
  FeatureMesh r;
  r.points = mesh.points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.source_cell[t] == cell) continue;
    r.triangles.push_back(mesh.triangles[t]);
    r.source_cell.push_back(mesh.source_cell[t]);
  }
  return r;
}

TEST(QuadricComparison, AgreesWithItself) {
  const Case c;
  ASSERT_TRUE(c.quadrics.contacts.empty());
  const QuadricComparison r = compare_quadrics(c.field, c.quadrics, c.quadrics.mesh, {});
  EXPECT_TRUE(r.agree());
  EXPECT_TRUE(r.complete());
  EXPECT_EQ(r.compared, c.quadrics.pieces.size());
  EXPECT_EQ(r.quadrics, r.mesh);
}

TEST(QuadricComparison, AMissingPieceIsFound) {
  const Case c;
  const std::int64_t cell = c.quadrics.mesh.source_cell[c.quadrics.mesh.source_cell.size() / 2];
  const FeatureMesh mesh = without(c.quadrics.mesh, cell);
  const QuadricComparison r = compare_quadrics(c.field, c.quadrics, mesh, {});
  EXPECT_EQ(r.differing, std::vector<std::int64_t>{cell});
  EXPECT_FALSE(r.agree());
  const std::int64_t open[] = {cell};
  const QuadricComparison left_out = compare_quadrics(c.field, c.quadrics, mesh, open);
  EXPECT_TRUE(left_out.differing.empty());
  EXPECT_EQ(left_out.left_out, 1u);
  EXPECT_FALSE(left_out.complete());
  EXPECT_TRUE(left_out.agree());
}

TEST(QuadricComparison, AHoleInOnePieceIsFound) {
  const Case c;
  FeatureMesh mesh = c.quadrics.mesh;
  const std::int64_t cell = mesh.source_cell.front();
  mesh.triangles.erase(mesh.triangles.begin());
  mesh.source_cell.erase(mesh.source_cell.begin());
  const QuadricComparison r = compare_quadrics(c.field, c.quadrics, mesh, {});
  // one triangle less is a hole, or moves the border: the whole tells the second
  EXPECT_FALSE(r.agree());
  if (!r.differing.empty()) {
    EXPECT_EQ(r.differing, std::vector<std::int64_t>{cell});
  }
}

// Cells that agree one by one, but are not joined to each other.
TEST(QuadricComparison, ACrackIsFoundInTheWhole) {
  const Case c;
  FeatureMesh mesh = c.quadrics.mesh;
  const std::int64_t cell = mesh.source_cell.front();
  const auto offset = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), c.quadrics.mesh.points.begin(),
                     c.quadrics.mesh.points.end());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.source_cell[t] == cell)
      for (std::uint32_t& v : mesh.triangles[t]) v += offset;
  const QuadricComparison r = compare_quadrics(c.field, c.quadrics, mesh, {});
  EXPECT_TRUE(r.differing.empty());
  EXPECT_FALSE(r.agree());
}

TEST(Merged, PointsOfBothAreOneWhereThatIsClear) {
  const Point p = {0, 0, 0}, q = {1, 0, 0}, r = {0, 1, 0}, s = {1, 1, 0};
  FeatureMesh a, b;
  a.points = {p, q, r};
  a.triangles = {{0, 1, 2}};
  a.source_cell = {7};
  b.points = {s, r, q};
  b.triangles = {{0, 1, 2}};
  b.source_cell = {8};
  const MergedMesh clear = merged(a, b);
  EXPECT_TRUE(clear.ambiguous.empty());
  const SurfaceTopology t = surface_topology(clear.mesh.triangles, clear.mesh.points.size());
  EXPECT_EQ(t.vertices, 4u);
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(clear.mesh.source_cell, (std::vector<std::int64_t>{7, 8}));
  // two points of b at one place of a: neither is joined, and both cells are named
  b.points.push_back(q);
  const MergedMesh unclear = merged(a, b);
  EXPECT_EQ(unclear.ambiguous, (std::vector<std::int64_t>{7, 8}));
  // twins in one mesh alone are none of its business
  b.points.back() = s;
  EXPECT_TRUE(merged(a, b).ambiguous.empty());
}

}  // namespace
}  // namespace triplex

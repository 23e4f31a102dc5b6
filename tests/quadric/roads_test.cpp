// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole fields: watertight, the same for any number of threads, numbering and scale, and the same
// topology as the certified complex, which takes another road.
#include <gtest/gtest.h>

#include <cmath>

#include "../extract/fields.hpp"
#include "../oracle/random_tensors.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/quadric/quadric_extraction.hpp"
#include "triplex/verify/quadric_comparison.hpp"

namespace triplex {
namespace {

TensorField abc(int n) {
  GridOptions grid;
  grid.n = n;
  return generate_abc(grid);
}

FeatureTable level_sets(double magnitude, double eta) {
  FeatureTable table;
  table.add_magnitude(magnitude);
  table.add_isotropicity(eta);
  table.add_isotropicity(-eta);
  table.add_traceless();
  return table;
}

std::vector<std::int64_t> open_cells(const Extraction& e, FeatureSet features) {
  std::vector<std::int64_t> cells;
  for (const UnresolvedTet& t : e.unresolved)
    if ((t.features & features) != 0) cells.push_back(t.source_cell);
  return cells;
}

/// Both roads on all quadrics of a table. Returns the number of cells compared.
std::uint64_t compare_roads(const TensorField& field, const FeatureTable& table) {
  ExtractionOptions options;
  options.table = table;
  options.features =
      bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar) | table.level_sets();
  const Extraction certified = extract(field, options);
  std::uint64_t compared = 0;
  const auto compare = [&](const FeatureRow& row, const FeatureMesh& mesh, FeatureSet features,
                           const std::vector<std::int64_t>& ambiguous) {
    std::vector<std::int64_t> open = open_cells(certified, features);
    open.insert(open.end(), ambiguous.begin(), ambiguous.end());
    const QuadricExtraction quadrics = extract_quadric(field, row);
    EXPECT_TRUE(quadrics.unmeshed.empty()) << row.name;
    const QuadricComparison c =
        compare_quadrics(field, quadrics, mesh, open);
    EXPECT_TRUE(c.agree()) << row.name << ": " << c.differing.size() << " of " << c.compared
                           << " differ, " << c.left_out << " left out; " << c.quadrics.components
                           << "," << c.quadrics.euler << "," << c.quadrics.boundary_loops << " vs "
                           << c.mesh.components << "," << c.mesh.euler << ","
                           << c.mesh.boundary_loops;
    if (quadrics.contacts.empty()) {  // pieces around a hole may meet in one point
      EXPECT_TRUE(c.quadrics.manifold()) << row.name;
    }
    EXPECT_EQ(c.quadrics.nonmanifold_edges, 0u) << row.name;
    EXPECT_EQ(c.quadrics.orientation_conflicts, 0u) << row.name;
    printf("%s: compared %d left out %d\n", row.name.c_str(), int(c.compared), int(c.left_out));
    compared += c.compared;
  };
  const MergedMesh balanced =
      merged(certified.mesh(Feature::BalancedLinear), certified.mesh(Feature::BalancedPlanar));
  compare(table.row(Feature::BalancedLinear), balanced.mesh,
          bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar), balanced.ambiguous);
  for (const FeatureRow& row : table.rows())
    if (row.kind == FeatureKind::LevelSet)
      compare(row, certified.mesh(row.feature), bit(row.feature), {});
  return compared;
}

TEST(Roads, AgreeOnGenerators) {
  for (const int n : {8, 11, 16}) EXPECT_GT(compare_roads(abc(n), {}), 100u * n);
  GridOptions grid;
  grid.n = 9;
  EXPECT_GT(compare_roads(generate_lorenz(grid), level_sets(40, 0.2)), 100u);
  EXPECT_GT(compare_roads(generate_rayleigh_benard(grid), level_sets(2, 0.1)), 100u);
}

TEST(Roads, AgreeOnRandomTets) {
  oracle::Random random(8);
  std::uint64_t compared = 0;
  for (int n = 0; n < 150; ++n) {
    TensorField field;
    field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
    for (int v = 0; v < 4; ++v) field.tensors.push_back(oracle::double_tensor(random));
    compared += compare_roads(field, level_sets(1.5, 0.25));
  }
  EXPECT_GT(compared, 300u);
}

}  // namespace
}  // namespace triplex

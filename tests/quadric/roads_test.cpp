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
    const QuadricComparison c = compare_quadrics(field, quadrics, mesh, open);
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
    compared += c.compared;
    if (row.feature != Feature::BalancedLinear) return;
    open = open_cells(certified, features);
    const BalancedParts parts = split_balanced(quadrics);
    for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
      QuadricExtraction part = quadrics;
      part.mesh = f == Feature::BalancedLinear ? parts.linear : parts.planar;
      const QuadricComparison p = compare_part(field, part, certified.mesh(f), open);
      EXPECT_TRUE(p.agree()) << table.row(f).name << ": " << p.differing.size() << " of "
                             << p.compared << " differ, " << p.left_out << " left out";
      EXPECT_EQ(p.quadrics.nonmanifold_edges, 0u) << table.row(f).name;
      EXPECT_EQ(p.quadrics.orientation_conflicts, 0u) << table.row(f).name;
    }
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

// Points in general position: no contacts, so the surfaces must agree as a whole.
TEST(Roads, AgreeOnJitteredMeshes) {
  GridOptions grid;
  grid.n = 7;
  grid.jitter = 0.1;
  for (const std::uint64_t seed : {1, 2}) {
    grid.seed = seed;
    EXPECT_GT(compare_roads(generate_abc(grid), {}), 500u);
    EXPECT_GT(compare_roads(generate_rayleigh_benard(grid), level_sets(2, 0.1)), 100u);
    compare_roads(generate_lorenz(grid), level_sets(40, 0.2));
    compare_roads(generate_random_linear(grid), level_sets(2, 0.3));
  }
  grid.n = 4;
  EXPECT_GT(compare_roads(generate_noise(grid), level_sets(1, 0.2)), 500u);
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

TEST(Quadrics, TheSameForAnyNumberOfThreads) {
  const TensorField field = abc(9);
  const FeatureRow& row = standard_features().row(Feature::BalancedLinear);
  QuadricOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const QuadricExtraction a = extract_quadric(field, row, one),
                          b = extract_quadric(field, row, three);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.mesh.q, b.mesh.q);
  EXPECT_EQ(a.pieces, b.pieces);
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_EQ(a.parts, b.parts);
  EXPECT_EQ(a.unsplit, b.unsplit);
}

// q in doubles at points inside of patches knows nothing of arcs; near the curve, which is drawn as
// a polyline, points on the other side of it have small q.
TEST(Quadrics, PartsAreOnTheirSides) {
  GridOptions grid;
  grid.n = 6;
  grid.jitter = 0.1;
  for (const TensorField& field :
       {generate_abc(grid), generate_rayleigh_benard(grid), generate_random_linear(grid)}) {
    QuadricOptions options;
    options.samples = 8;
    const QuadricExtraction e =
        extract_quadric(field, standard_features().row(Feature::BalancedLinear), options);
    ASSERT_EQ(e.parts.size(), e.mesh.triangles.size());
    std::array<std::size_t, 3> triangles{};
    double right = 0, wrong = 0;
    for (std::size_t t = 0; t < e.parts.size(); ++t) {
      ++triangles[static_cast<std::size_t>(e.parts[t] + 1)];
      for (const std::uint32_t v : e.mesh.triangles[t])
        (e.mesh.q[v] * e.parts[t] >= 0 ? right : wrong) += std::fabs(e.mesh.q[v] * e.parts[t]);
    }
    EXPECT_GT(triangles[0], 1000u);
    EXPECT_GT(triangles[2], 1000u);
    EXPECT_LT(5 * triangles[1], triangles[0] + triangles[2]);
    EXPECT_LT(1000 * wrong, right);
  }
}

// The curve is a seam: an edge of one part alone lies on the border of the mesh or is one of the
// other part's.
TEST(Quadrics, PartsMeetAlongTheCurve) {
  GridOptions grid;
  grid.n = 6;
  grid.jitter = 0.1;
  const QuadricExtraction e =
      extract_quadric(generate_abc(grid), standard_features().row(Feature::BalancedLinear));
  const BalancedParts parts = split_balanced(e);
  FeatureMesh both = parts.linear;
  both.triangles.insert(both.triangles.end(), parts.planar.triangles.begin(),
                        parts.planar.triangles.end());
  const SurfaceTopology whole = surface_topology(e.mesh.triangles, e.mesh.points.size()),
                        sum = surface_topology(both.triangles, both.points.size());
  EXPECT_EQ(sum.euler, whole.euler);
  EXPECT_EQ(sum.components, whole.components);
  EXPECT_EQ(sum.boundary_loops, whole.boundary_loops);
  EXPECT_EQ(sum.nonmanifold_edges, 0u);
}

// Parts that are exchanged do not pass for those of the certified road.
TEST(Roads, ExchangedPartsDiffer) {
  const TensorField field = abc(8);
  ExtractionOptions options;
  options.features = bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar);
  const Extraction certified = extract(field, options);
  QuadricExtraction part = extract_quadric(field, standard_features().row(Feature::BalancedLinear));
  part.mesh = split_balanced(part).planar;
  const QuadricComparison c = compare_part(field, part, certified.mesh(Feature::BalancedLinear),
                                           open_cells(certified, options.features));
  EXPECT_FALSE(c.agree());
  EXPECT_GT(c.differing.size(), c.compared / 2);
}

TEST(Quadrics, ScaledTensorsGiveTheSameMesh) {
  const TensorField field = abc(7);
  const FeatureRow& row = standard_features().row(Feature::BalancedLinear);
  const QuadricExtraction a = extract_quadric(field, row);
  for (const int k : {-40, 3, 300, -300}) {
    const TensorField scaled =
        test::mapped(field, [k](const Tensor<double>& t) { return oracle::scaled(t, k); });
    const QuadricExtraction b = extract_quadric(scaled, row);
    EXPECT_EQ(a.pieces, b.pieces) << k;
    EXPECT_EQ(a.contacts, b.contacts) << k;
    if (std::abs(k) < 100) {  // beyond, points come from exact numbers and differ in the last bit
      EXPECT_EQ(a.mesh.triangles, b.mesh.triangles) << k;
    }
  }
}

TEST(Quadrics, RelabelledFieldsHaveTheSameTopology) {
  GridOptions grid, jittered;
  grid.n = jittered.n = 7;
  jittered.jitter = 0.1;
  const std::array fields = {abc(7), generate_abc(jittered), generate_lorenz(grid)};
  for (const TensorField& field : fields) {
    const FeatureRow& row = standard_features().row(Feature::BalancedLinear);
    const QuadricExtraction a = extract_quadric(field, row);
    const QuadricExtraction b = extract_quadric(test::relabelled(field, 11), row);
    EXPECT_EQ(a.pieces.size(), b.pieces.size());
    EXPECT_EQ(a.contacts.size(), b.contacts.size());
    EXPECT_EQ(a.types, b.types);
    const SurfaceTopology s = surface_topology(a.mesh.triangles, a.mesh.points.size()),
                          t = surface_topology(b.mesh.triangles, b.mesh.points.size());
    EXPECT_EQ(s.components, t.components);
    EXPECT_EQ(s.euler, t.euler);
    EXPECT_EQ(s.boundary_loops, t.boundary_loops);
    EXPECT_NEAR(area_approx(a.mesh.points, a.mesh.triangles),
                area_approx(b.mesh.points, b.mesh.triangles),
                1e-3 * area_approx(a.mesh.points, a.mesh.triangles));
  }
}

// On planes of symmetry quadrics are pairs of planes but for rounding, and conics pairs of lines:
// arcs along a line must not run to and fro on it.
TEST(Quadrics, AreasConvergeThroughPlanesOfSymmetry) {
  const TensorField field = abc(7);
  const FeatureRow& row = standard_features().row(Feature::BalancedLinear);
  std::array<double, 3> area{};
  for (int k = 0; k < 3; ++k) {
    const QuadricExtraction e = extract_quadric(field, row, {.samples = 4 << k});
    area[static_cast<std::size_t>(k)] = area_approx(e.mesh.points, e.mesh.triangles);
    EXPECT_TRUE(e.unmeshed.empty());
  }
  const double change = std::fabs(area[1] - area[0]);
  EXPECT_LT(change, 3e-3 * area[1]);
  EXPECT_LT(std::fabs(area[2] - area[1]), change / 3);  // second order: about a quarter
}

// p = x^2 + 10 z - 8179/27 on any mesh: a parabolic cylinder, exactly where rounding leaves it so.
TEST(Quadrics, LorenzIsOnItsClosedForm) {
  GridOptions grid;
  grid.n = 8;
  const QuadricExtraction e =
      extract_quadric(generate_lorenz(grid), standard_features().row(Feature::BalancedLinear));
  ASSERT_GT(e.mesh.points.size(), 1000u);
  for (const Point& x : e.mesh.points) EXPECT_NEAR(x[0] * x[0] + 10 * x[2], 8179.0 / 27, 1e-9);
}

TEST(Quadrics, PartsOfTheBalancedSurface) {
  GridOptions grid;
  grid.n = 8;
  grid.box =
      Box{{0.1, 0.2, 0.3}, {6.383, 6.483, 6.583}};  // off the planes of symmetry: no contacts
  const TensorField field = generate_abc(grid);
  const QuadricExtraction e =
      extract_quadric(field, standard_features().row(Feature::BalancedLinear));
  const BalancedParts parts = split_balanced(e);
  EXPECT_EQ(parts.linear.points, parts.planar.points);
  ExtractionOptions options;
  options.features = bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar);
  const Extraction certified = extract(field, options);
  const auto area = [](const FeatureMesh& m) { return area_approx(m.points, m.triangles); };
  const double whole = area(e.mesh), linear = area(parts.linear), planar = area(parts.planar);
  EXPECT_NEAR(linear + planar, whole, 1e-9 * whole);
  EXPECT_NEAR(linear, area(certified.mesh(Feature::BalancedLinear)), 0.03 * whole);
  EXPECT_NEAR(planar, area(certified.mesh(Feature::BalancedPlanar)), 0.03 * whole);
  for (const FeatureMesh* m : {&parts.linear, &parts.planar}) {
    const SurfaceTopology t = surface_topology(m->triangles, m->points.size());
    EXPECT_EQ(t.nonmanifold_edges, 0u);
    EXPECT_EQ(t.orientation_conflicts, 0u);
  }
}

/// Six times the volume on the inner side of an oriented closed surface.
double volume(const FeatureMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

// T = diag(x, y, z): |T| = r is a sphere, across many tets and inside one; outwards is outwards.
TEST(Quadrics, MagnitudeSpheres) {
  GridOptions grid;
  grid.n = 5;
  grid.box = Box{{-1.8, -2.05, -2.3}, {2.2, 1.95, 1.7}};
  TensorField field = generate_abc(grid);
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    const Point& x = field.mesh.points[v];
    field.tensors[v] = {x[0], 0, 0, 0, x[1], 0, 0, 0, x[2]};
  }
  for (const double r : {1.5, 0.05}) {
    FeatureTable table;
    const Feature f = table.add_magnitude(r);
    QuadricOptions options;
    options.samples = 16;
    const QuadricExtraction e = extract_quadric(field, table.row(f), options);
    const SurfaceTopology t = surface_topology(e.mesh.triangles, e.mesh.points.size());
    EXPECT_EQ(t.euler, 2) << r;
    EXPECT_EQ(t.components, 1u) << r;
    EXPECT_EQ(t.boundary_edges, 0u) << r;
    EXPECT_EQ(t.orientation_conflicts, 0u) << r;
    EXPECT_NEAR(volume(e.mesh), 8 * M_PI * r * r * r, 0.3 * r * r * r) << r;
  }
}

TEST(Quadrics, OfAnotherFeatureAreRefused) {
  EXPECT_THROW(extract_quadric(abc(2), standard_features().row(Feature::NeutralReal)),
               std::invalid_argument);
  FeatureTable table;
  GridOptions grid;
  grid.n = 4;
  const QuadricExtraction e =
      extract_quadric(generate_lorenz(grid), table.row(table.add_magnitude(40)));
  ASSERT_FALSE(e.mesh.points.empty());
  EXPECT_THROW(split_balanced(e), std::invalid_argument);
}

}  // namespace
}  // namespace triplex

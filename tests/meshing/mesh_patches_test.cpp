// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/mesh_patches.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "linear_oracle.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/meshing/wish_for_charts.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

using Random = std::mt19937_64;
using oracle::distance;
using oracle::distance_to_triangle;
using oracle::Linear;
using oracle::to_vec;
using oracle::Vec;

struct Meshed {
  Extraction extraction;
  MeshedPatches patches;
  const FeatureMesh& mesh(Feature f) const { return patches.features[index(f)]; }
};

Meshed mesh_field(const TensorField& field, std::optional<Tolerance> tolerance,
                  unsigned threads = 0) {
  ExtractionOptions options;
  options.keep_patches = true;
  options.threads = threads;
  if (tolerance) options.wish = wish_for_charts(field, options.table, *tolerance);
  Meshed result;
  result.extraction = extract(field, options);
  MeshingOptions meshing;
  meshing.tolerance = tolerance;
  meshing.threads = threads;
  result.patches = mesh_patches(field, *result.extraction.patches, meshing);
  return result;
}

constexpr std::array<Feature, 6> kPages = {Feature::NeutralComplex,   Feature::BalancedLinear,
                                           Feature::DegenerateLinear, Feature::NeutralReal,
                                           Feature::DegeneratePlanar, Feature::BalancedPlanar};

/// Points of the triangles, each within the bound of its cell of the true surface.
void expect_mesh_near_surface(const Meshed& meshed, const Linear& linear, Random& random,
                              int samples) {
  for (const Feature f : kPages) {
    const FeatureMesh& mesh = meshed.mesh(f);
    if (mesh.triangles.empty()) continue;
    for (int n = 0; n < samples; ++n) {
      const std::size_t t =
          std::uniform_int_distribution<std::size_t>(0, mesh.triangles.size() - 1)(random);
      const double bound = mesh.error_bound[t];
      if (!(bound < 0.1)) continue;  // a projection would find another part
      std::uniform_real_distribution<double> uniform(0, 1);
      double u = uniform(random), v = uniform(random);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      Vec x{};
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = (1 - u - v) * mesh.points[mesh.triangles[t][0]][k] +
               static_cast<long double>(u) * mesh.points[mesh.triangles[t][1]][k] +
               static_cast<long double>(v) * mesh.points[mesh.triangles[t][2]][k];
      const auto on_surface = linear.project(f, x, bound);
      // Near a node the iteration may not settle.
      if (on_surface) {
        EXPECT_LE(distance(x, *on_surface), bound * 1.0000001L);
      }
    }
  }
}

/// Points of the true pages inside the box, each within the largest bound of the mesh.
int expect_surface_near_mesh(const Meshed& meshed, const Linear& linear, const Box& box,
                             double tolerance, Random& random, int samples) {
  int tested = 0;
  for (const Feature f : kPages) {
    const FeatureMesh& mesh = meshed.mesh(f);
    for (int n = 0; n < samples; ++n) {
      Vec x;
      for (std::size_t k = 0; k < 3; ++k)
        x[k] = std::uniform_real_distribution<double>(box.lo[k], box.hi[k])(random);
      const auto on_sheet = linear.project(f, x, 1);
      if (!on_sheet || !linear.is_on_page(f, *on_sheet)) continue;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k)
        inside &= (*on_sheet)[k] > box.lo[k] && (*on_sheet)[k] < box.hi[k];
      if (!inside) continue;
      ++tested;
      long double nearest = HUGE_VALL;
      for (const auto& [a, b, c] : mesh.triangles)
        nearest =
            std::min(nearest, distance_to_triangle(*on_sheet, to_vec(mesh.points[a]),
                                                   to_vec(mesh.points[b]), to_vec(mesh.points[c])));
      EXPECT_LE(nearest, tolerance * 1.0000001L) << standard_features().row(f).name;
    }
  }
  return tested;
}

const Box kLorenzBox{{-30, -30, 0}, {30, 30, 60}};
const Box kUnitBox{{-1, -1, -1}, {1, 1, 1}};

TEST(MeshPatches, LorenzIsWithinTheToleranceBothWays) {
  GridOptions grid;
  grid.n = 1;
  const TensorField field = generate_lorenz(grid);
  const Linear linear(field);
  Random random(3);
  for (const double part : {1e-2, 1e-4}) {
    const Meshed meshed = mesh_field(field, Tolerance{part, true});
    EXPECT_TRUE(meshed.extraction.certified());
    const double tolerance = part * longest_edge_approx(field, TetId{0});
    const MeshAccuracy& accuracy = meshed.patches.accuracy;
    EXPECT_EQ(accuracy.unproven, 0u);
    EXPECT_LE(accuracy.beyond, accuracy.patches / 1000);
    expect_mesh_near_surface(meshed, linear, random, 300);
    const double bound = std::max(tolerance, accuracy.largest_error);
    EXPECT_GT(expect_surface_near_mesh(meshed, linear, kLorenzBox, bound, random, 40), 60);
  }
}

// Down to a millionth of the tet, where one page of the six is enough to wait for.
TEST(MeshPatches, LorenzBalancedDownToAMillionth) {
  GridOptions grid;
  grid.n = 1;
  const TensorField field = generate_lorenz(grid);
  ExtractionOptions options;
  options.features = bit(Feature::BalancedLinear) | bit(Feature::BalancedPlanar);
  options.keep_patches = true;
  const Tolerance tolerance{1e-6, true};
  options.wish = wish_for_charts(field, options.table, tolerance);
  const Extraction extraction = extract(field, options);
  MeshingOptions meshing;
  meshing.tolerance = tolerance;
  const MeshedPatches patches = mesh_patches(field, *extraction.patches, meshing);
  EXPECT_EQ(patches.accuracy.within, patches.accuracy.patches);
  const double bound = 1.001e-6 * longest_edge_approx(field, TetId{0});
  // p = x^2 + 10 z - 8179/27: the distance to the cylinder is at most |p| / 10.
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
    const FeatureMesh& mesh = patches.features[index(f)];
    for (const auto& t : mesh.triangles) {
      Vec m{};
      for (const std::uint32_t v : t)
        for (std::size_t k = 0; k < 3; ++k) m[k] += mesh.points[v][k] / 3.0L;
      EXPECT_LE(std::fabs(m[0] * m[0] + 10 * m[2] - 8179.0L / 27) / 10,
                bound * std::hypot(1.0, 6.0));
    }
  }
}

TEST(MeshPatches, RandomLinearFieldsAreWithinTheToleranceBothWays) {
  Random random(4);
  int tested = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    GridOptions grid;
    grid.n = 1;
    grid.seed = seed;
    const TensorField field = generate_random_linear(grid);
    const Meshed meshed = mesh_field(field, Tolerance{1e-3, false});
    if (!meshed.extraction.certified()) continue;
    const MeshAccuracy& accuracy = meshed.patches.accuracy;
    EXPECT_EQ(accuracy.unproven, 0u) << seed;
    EXPECT_LE(accuracy.beyond, 1 + accuracy.patches / 100) << seed;
    const Linear linear(field);
    expect_mesh_near_surface(meshed, linear, random, 100);
    tested += expect_surface_near_mesh(meshed, linear, kUnitBox,
                                       std::max(1e-3, accuracy.largest_error), random, 20);
  }
  EXPECT_GT(tested, 100);
}

// A parabolic cylinder between two planes, 60 long, of which z >= 0 is inside.
TEST(MeshPatches, AreasConvergeAtSecondOrderToTheClosedForm) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  const double half = std::sqrt(8179.0 / 27), s = half / 5;
  const double exact = 60 * 5 * (s * std::hypot(1, s) + std::asinh(s));
  std::array<double, 2> errors{};
  std::array<std::size_t, 2> triangles{};
  for (std::size_t n = 0; n < 2; ++n) {
    const Meshed meshed = mesh_field(field, Tolerance{n == 0 ? 1e-3 : 1e-5, true});
    double area = 0;
    for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
      area += area_approx(meshed.mesh(f).points, meshed.mesh(f).triangles);
      triangles[n] += meshed.mesh(f).triangles.size();
    }
    errors[n] = std::fabs(area - exact) / exact;
  }
  // A hundredth of the distance: a hundredth of the error in area, a hundred times the triangles,
  // less what the smallest patches have to begin with.
  EXPECT_LT(errors[1], errors[0] / 30);
  EXPECT_LT(errors[1], 1e-5);
  EXPECT_GT(triangles[1], 5 * triangles[0]);
  EXPECT_LT(triangles[1], 150 * triangles[0]);
}

// Two branches y = (a^3 - (22/3) x^2) / (10 x), z = (8179/27 - x^2) / 10, a = 17/9, mirror images
// of each other, from y = 30 to z = 0.
TEST(MeshPatches, TheCurveConvergesToTheLengthOfItsClosedForm) {
  const double a3 = std::pow(17.0 / 9, 3), b = 22.0 / 3;
  const double first = (-300 + std::sqrt(90000 + 4 * b * a3)) / (2 * b);
  const double last = std::sqrt(8179.0 / 27);
  double exact = 0;  // Simpson's rule in log x
  constexpr int kSteps = 20000;
  const double h = std::log(last / first) / kSteps;
  for (int n = 0; n <= kSteps; ++n) {
    const double x = first * std::exp(n * h);
    const double dy = -(a3 / (x * x) + b) / 10, dz = -x / 5;
    const double weight = n == 0 || n == kSteps ? 1 : n % 2 == 1 ? 4 : 2;
    exact += 2 * weight * h / 3 * x * std::sqrt(1 + dy * dy + dz * dz);
  }
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  std::array<double, 2> errors{};
  for (std::size_t n = 0; n < 2; ++n) {
    ExtractionOptions options;
    options.features = bit(Feature::TripleCurve);
    options.keep_patches = true;
    const Tolerance tolerance{n == 0 ? 1e-3 : 1e-6, true};
    const Extraction extraction = extract(field, options);
    MeshingOptions meshing;
    meshing.tolerance = tolerance;
    const MeshedPatches patches = mesh_patches(field, *extraction.patches, meshing);
    const FeatureMesh& curve = patches.features[index(Feature::TripleCurve)];
    errors[n] = std::fabs(length_approx(curve.points, curve.segments) - exact) / exact;
  }
  EXPECT_LT(errors[0], 1e-3);
  EXPECT_LT(errors[1], 1e-6);
  EXPECT_LT(errors[1], errors[0] / 30);
}

TEST(MeshPatches, ToleranceChangesNoTopology) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  const Extraction plain = extract(field);
  const Meshed meshed = mesh_field(field, Tolerance{1e-3, true});
  for (const Feature f : kPages) {
    const FeatureMesh &a = plain.mesh(f), &b = meshed.mesh(f);
    const SurfaceTopology x = surface_topology(a.triangles, a.points.size());
    const SurfaceTopology y = surface_topology(b.triangles, b.points.size());
    EXPECT_EQ(x.components, y.components) << standard_features().row(f).name;
    EXPECT_EQ(x.euler, y.euler) << standard_features().row(f).name;
    EXPECT_EQ(x.boundary_loops, y.boundary_loops) << standard_features().row(f).name;
    EXPECT_EQ(a.nodes.size(), b.nodes.size());
  }
}

// Pages that end on the curve share its points bit for bit.
TEST(MeshPatches, PagesShareTheCurve) {
  GridOptions grid;
  grid.n = 2;
  const Meshed meshed = mesh_field(generate_lorenz(grid), Tolerance{1e-4, true});
  const FeatureMesh& curve = meshed.mesh(Feature::TripleCurve);
  EXPECT_GT(curve.points.size(), meshed.extraction.mesh(Feature::TripleCurve).points.size());
  for (const Feature f : kPages) {
    const std::set<Point> points(meshed.mesh(f).points.begin(), meshed.mesh(f).points.end());
    for (const Point& x : curve.points) EXPECT_TRUE(points.contains(x));
  }
}

TEST(MeshPatches, NormalsAreUnitGradientsOnTheSideOfTheTriangles) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  const Meshed meshed = mesh_field(field, Tolerance{1e-3, true});
  for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar}) {
    const FeatureMesh& mesh = meshed.mesh(f);
    const double side = f == Feature::BalancedLinear ? -1 : 1;  // the angle of (p, q) grows
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double x = mesh.points[v][0], length = std::hypot(2 * x, 10);
      EXPECT_NEAR(mesh.normals[v][0], side * 2 * x / length, 1e-9);
      EXPECT_NEAR(mesh.normals[v][1], 0, 1e-9);
      EXPECT_NEAR(mesh.normals[v][2], side * 10 / length, 1e-9);
    }
  }
  // By area: needles along curved boundaries may be turned any way.
  long double wrong = 0, all = 0;
  for (const Feature f : kPages) {
    const FeatureMesh& mesh = meshed.mesh(f);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec x = to_vec(mesh.points[a]), y = to_vec(mesh.points[b]), z = to_vec(mesh.points[c]);
      const Vec u{y[0] - x[0], y[1] - x[1], y[2] - x[2]}, v{z[0] - x[0], z[1] - x[1], z[2] - x[2]};
      const long double along = (u[1] * v[2] - u[2] * v[1]) * mesh.normals[a][0] +
                                (u[2] * v[0] - u[0] * v[2]) * mesh.normals[a][1] +
                                (u[0] * v[1] - u[1] * v[0]) * mesh.normals[a][2];
      all += std::fabs(along);
      wrong += std::max(0.0L, -along);
    }
  }
  EXPECT_LT(wrong, all / 1000);
}

TEST(MeshPatches, DoesNotDependOnThreads) {
  GridOptions grid;
  grid.n = 3;
  const TensorField field = generate_lorenz(grid);
  const Meshed one = mesh_field(field, Tolerance{1e-2, true}, 1);
  const Meshed two = mesh_field(field, Tolerance{1e-2, true}, 2);
  for (std::size_t f = 0; f < one.patches.features.size(); ++f) {
    EXPECT_EQ(one.patches.features[f].points, two.patches.features[f].points);
    EXPECT_EQ(one.patches.features[f].triangles, two.patches.features[f].triangles);
    EXPECT_EQ(one.patches.features[f].error_bound, two.patches.features[f].error_bound);
    EXPECT_EQ(one.patches.features[f].normals, two.patches.features[f].normals);
  }
}

TEST(MeshPatches, ScalesWithTheField) {
  GridOptions grid;
  grid.n = 2;
  TensorField field = generate_lorenz(grid);
  const Meshed plain = mesh_field(field, Tolerance{1e-2, true});
  for (Tensor<double>& t : field.tensors)
    for (double& x : t) x = std::ldexp(x, 7);
  for (Point& p : field.mesh.points)
    for (double& x : p) x = std::ldexp(x, -3);
  const Meshed scaled = mesh_field(field, Tolerance{1e-2, true});
  for (const Feature f : kPages) {
    ASSERT_EQ(plain.mesh(f).triangles, scaled.mesh(f).triangles);
    for (std::size_t v = 0; v < plain.mesh(f).points.size(); ++v)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(std::ldexp(plain.mesh(f).points[v][k], -3), scaled.mesh(f).points[v][k]);
  }
}

TEST(MeshPatches, WithoutAToleranceThereIsOnePolygonPerPatch) {
  GridOptions grid;
  grid.n = 3;
  const Meshed meshed = mesh_field(generate_lorenz(grid), std::nullopt);
  for (const Feature f : kPages) {
    EXPECT_EQ(meshed.mesh(f).points.size(), meshed.extraction.mesh(f).points.size());
    EXPECT_EQ(meshed.mesh(f).triangles.size(), meshed.extraction.mesh(f).triangles.size());
  }
}

TEST(MeshPatches, StopsWhenAskedTo) {
  GridOptions grid;
  grid.n = 2;
  const TensorField field = generate_lorenz(grid);
  ExtractionOptions options;
  options.keep_patches = true;
  const Extraction extraction = extract(field, options);
  const std::atomic<bool> stop = true;
  MeshingOptions meshing;
  meshing.interrupted = &stop;
  EXPECT_THROW(mesh_patches(field, *extraction.patches, meshing), Interrupted);
}

}  // namespace
}  // namespace triplex

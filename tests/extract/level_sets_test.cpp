// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Magnitude, isotropicity and traceless surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "fields.hpp"
#include "triplex/certify/level_set.hpp"
#include "triplex/tensor/invariants.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

SurfaceTopology topology_of(const FeatureMesh& mesh) {
  return surface_topology(mesh.triangles, mesh.points.size());
}

/// T = x R_1 + y R_2 + z R_3 with orthonormal R: |T| = |x|, so a magnitude surface is a sphere.
TensorField radial_field(int n, double half) {
  GridOptions grid;
  grid.n = n;
  grid.box = Box{{-half, -half, -half}, {half, half, half}};
  return generate_constant(grid);
}
void set_radial(TensorField& field) {
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    const auto [x, y, z] = field.mesh.points[v];
    field.tensors[v] = {0, x, 0, 0, 0, y, z, 0, 0};
  }
}

TEST(MagnitudeSurface, IsASphereWhereItMustBe) {
  TensorField field = radial_field(6, 1.1);
  set_radial(field);
  ExtractionOptions options;
  const Feature s = options.table.add_magnitude(0.75);
  options.features = bit(s);
  const Extraction result = extract(field, options);
  EXPECT_TRUE(result.certified());
  const SurfaceTopology t = topology_of(result.mesh(s));
  EXPECT_EQ(t.components, 1u);
  EXPECT_EQ(t.euler, 2);
  EXPECT_EQ(t.boundary_loops, 0u);
  for (const auto& [x, y, z] : result.mesh(s).points) EXPECT_NEAR(std::hypot(x, y, z), 0.75, 1e-12);
  const double sphere = 4 * std::numbers::pi * 0.75 * 0.75;
  EXPECT_NEAR(area_approx(result.mesh(s).points, result.mesh(s).triangles), sphere, 0.06 * sphere);
  // Outward normals.
  for (const auto& tri : result.mesh(s).triangles) {
    const Point &a = result.mesh(s).points[tri[0]], &b = result.mesh(s).points[tri[1]],
                &c = result.mesh(s).points[tri[2]];
    double det = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                 a[2] * (b[0] * c[1] - b[1] * c[0]);
    EXPECT_GT(det, -1e-12);
  }
}

/// A sphere wholly inside one tet, which no sampling at the vertices can see.
TEST(MagnitudeSurface, IsFoundInsideOneTet) {
  TensorField field;
  field.mesh.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  field.mesh.tets = {{VertexId(0), VertexId(2), VertexId(1), VertexId(3)}};
  field.tensors.resize(4);
  set_radial(field);
  for (const double radius : {0.3, 0.05}) {
    ExtractionOptions options;
    options.max_bisections = 400;
    const Feature s = options.table.add_magnitude(radius);
    options.features = bit(s);
    const Extraction result = extract(field, options);
    EXPECT_TRUE(result.certified()) << radius;
    EXPECT_EQ(topology_of(result.mesh(s)).components, 1u) << radius;
    EXPECT_EQ(topology_of(result.mesh(s)).euler, 2) << radius;
  }
}

/// The vertices by another road, and the labels of the surfaces that a convex set must have: each
/// is genus zero, and between two points inside lie only points inside.
TEST(LevelSets, BoundConvexSetsInEveryLinearField) {
  int closed = 0, nappes = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    GridOptions grid;
    grid.n = 3;
    grid.seed = seed;
    const TensorField field = generate_random_linear(grid);
    double size = 0;
    for (const auto& t : field.tensors) size += magnitude_approx(t) / field.tensors.size();
    ExtractionOptions options;
    options.keep_tensors = true;
    options.features = 0;
    for (const double factor : {0.6, 1.0})
      options.features |= bit(options.table.add_magnitude(factor * size));
    for (const double eta : {-0.4, -0.1, 0.1, 0.4})
      options.features |= bit(options.table.add_isotropicity(eta));
    const Extraction result = extract(field, options);
    EXPECT_TRUE(result.certified()) << seed;
    for (const FeatureRow& row : result.table.rows()) {
      const FeatureMesh& mesh = result.mesh(row.feature);
      if (mesh.points.empty()) continue;
      const SurfaceTopology t = topology_of(mesh);
      EXPECT_EQ(t.euler, 2 * static_cast<std::int64_t>(t.components) -
                             static_cast<std::int64_t>(t.boundary_loops))
          << row.name << ", seed " << seed;
      const bool ball = row.level.kind == LevelSet::Kind::Magnitude;
      (ball ? closed : nappes) += 1;
      for (const Tensor<double>& x : mesh.tensors) {
        const double value = ball ? magnitude_approx(x) : isotropicity_approx(x);
        EXPECT_NEAR(value, row.level.value, 1e-9 * (ball ? size : 1)) << row.name;
      }
      // A segment between two points of the boundary stays in the closed convex set.
      std::mt19937_64 random(seed);
      for (int n = 0; n < 300; ++n) {
        const Tensor<double>&a = mesh.tensors[random() % mesh.tensors.size()],
              &b = mesh.tensors[random() % mesh.tensors.size()];
        Tensor<double> middle;
        for (int k = 0; k < 9; ++k) middle[k] = (a[k] + b[k]) / 2;
        if (ball) {
          EXPECT_LE(magnitude_approx(middle), row.level.value * (1 + 1e-9));
        } else {
          EXPECT_GE(isotropicity_approx(middle) * std::copysign(1.0, row.level.value),
                    std::fabs(row.level.value) - 1e-9);
        }
      }
    }
  }
  EXPECT_GT(closed, 8);
  EXPECT_GT(nappes, 8);
}

/// Magnitude surfaces are ellipsoids only and isotropicity surfaces never one-sheeted, since they
/// bound convex sets: exactly, the middle of two tensors inside is inside. (Both nappes of the
/// squared cone, or its outside, fail this at once.)
TEST(LevelSets, HaveAConvexInside) {
  std::mt19937_64 random(99);
  std::normal_distribution<double> normal;
  const std::array<LevelSet, 5> levels = {{{LevelSet::Kind::Magnitude, 2.5},
                                           {LevelSet::Kind::Isotropicity, 0.375},
                                           {LevelSet::Kind::Isotropicity, -0.375},
                                           {LevelSet::Kind::Isotropicity, -0.03125},
                                           {LevelSet::Kind::Traceless, 0}}};
  for (const LevelSet& level : levels) {
    std::vector<Tensor<Exact>> inside;
    int outside = 0;
    for (int n = 0; n < 3000; ++n) {
      Tensor<Exact> t;
      for (Exact& x : t) x = Exact(normal(random));
      for (const int k : {0, 4, 8}) t[k] = t[k] + Exact(2 * normal(random));
      if (exact_side(level, t) == Certainty::Positive) {
        inside.push_back(t);
      } else {
        ++outside;
      }
    }
    ASSERT_GT(inside.size(), 100u);
    EXPECT_GT(outside, 100);
    for (std::size_t n = 0; n < inside.size(); ++n) {
      const Tensor<Exact>&a = inside[n], &b = inside[random() % inside.size()];
      Tensor<Exact> middle;
      for (int k = 0; k < 9; ++k) middle[k] = Exact(0.5) * (a[k] + b[k]);
      EXPECT_EQ(exact_side(level, middle), Certainty::Positive);
    }
  }
}

TEST(TracelessSurface, IsCertifiedEverywhereAndFlatInEachTet) {
  GridOptions grid;
  grid.n = 4;
  grid.jitter = 0.2;
  const TensorField field = generate_noise(grid);
  ExtractionOptions options;
  options.keep_tensors = true;
  const Feature f = options.table.add_traceless();
  options.features = bit(f);
  const Extraction result = extract(field, options);
  EXPECT_TRUE(result.certified());
  EXPECT_EQ(result.refinement.bisections, 0u);
  ASSERT_GT(result.mesh(f).triangles.size(), 100u);
  for (const Tensor<double>& t : result.mesh(f).tensors)
    EXPECT_NEAR(trace_approx(t), 0, 1e-13 * magnitude_approx(t));
}

/// An incompressible field has no trace at all: the perturbation gives it one of one sign.
TEST(TracelessSurface, IsEmptyWhereTheTraceVanishes) {
  GridOptions grid;
  grid.n = 2;
  TensorField field = generate_noise(grid);
  for (auto& t : field.tensors) {
    t = {1, t[1], t[2], t[3], -3, t[5], t[6], t[7], 2};
  }
  ExtractionOptions options;
  const Feature f = options.table.add_traceless();
  const Feature g = options.table.add_isotropicity(-0.125);
  options.features = bit(f) | bit(g);
  const Extraction result = extract(field, options);
  EXPECT_TRUE(result.certified());
  EXPECT_TRUE(result.mesh(f).points.empty());
  EXPECT_TRUE(result.mesh(g).points.empty());
}

/// Threads, numbering and scale change nothing; negation swaps the nappes.
TEST(LevelSets, ObeyTheLaws) {
  GridOptions grid;
  grid.n = 5;
  grid.jitter = 0.15;
  const TensorField field = generate_noise(grid);
  ExtractionOptions options;
  const Feature s = options.table.add_magnitude(1.5);
  const Feature a = options.table.add_isotropicity(0.25);
  const Feature b = options.table.add_isotropicity(-0.25);
  options.features = bit(s) | bit(a) | bit(b);
  options.max_bisections = 1000;
  options.threads = 1;
  const Extraction one = extract(field, options);
  options.threads = 2;
  const Extraction two = extract(test::relabelled(field, 5), options);
  const Extraction minus = extract(test::mapped(field, test::negated), options);
  ExtractionOptions scaled_options;
  scaled_options.max_bisections = 1000;
  scaled_options.features = bit(scaled_options.table.add_magnitude(0x1.8p300));
  const Extraction scaled = extract(test::mapped(field,
                                                 [](Tensor<double> t) {
                                                   for (double& x : t) x *= 0x1p300;
                                                   return t;
                                                 }),
                                    scaled_options);
  ASSERT_GT(one.mesh(s).triangles.size(), 50u);
  ASSERT_GT(one.mesh(a).triangles.size(), 50u);
  for (const Feature f : {s, a, b})
    EXPECT_TRUE(test::geometry(one.mesh(f)) == test::geometry(two.mesh(f)));
  EXPECT_TRUE(test::geometry(one.mesh(s)) == test::geometry(minus.mesh(s)));
  EXPECT_TRUE(test::geometry(one.mesh(a)) == test::geometry(minus.mesh(b)));
  EXPECT_TRUE(test::geometry(one.mesh(b)) == test::geometry(minus.mesh(a)));
  // On its own the mesh is refined less; its topology is the same.
  ASSERT_TRUE(one.certified() && scaled.certified());
  EXPECT_EQ(topology_of(one.mesh(s)).euler, topology_of(scaled.features.back()).euler);
  EXPECT_EQ(topology_of(one.mesh(s)).components, topology_of(scaled.features.back()).components);
}

}  // namespace
}  // namespace triplex

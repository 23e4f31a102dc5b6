// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Fields whose surfaces are known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "triplex/baseline/a_patches.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

/// The tensor T0 + x Tx + y Ty + z Tz on a grid of [-1,1]^3.
TensorField linear_field(int n, const std::array<Tensor<double>, 4>& t) {
  TensorField field;
  GridOptions options;
  options.n = n;
  field.mesh = grid_mesh(options, {{-1, -1, -1}, {1, 1, 1}});
  for (const Point& x : field.mesh.points) {
    Tensor<double> sum = t[0];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 9; ++k) sum[k] += x[i] * t[i + 1][k];
    field.tensors.push_back(sum);
  }
  return field;
}

/// Sum over the triangles of (position . normal) / 3: of a closed surface its volume.
double volume(const FeatureMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles) {
    const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return six / 6;
}

void expect_sphere(int samples, double radius) {
  const TensorField field = linear_field(10, {{{},
                                               {0, 1, 0, 0, 0, 0, 0, 0, 0},
                                               {0, 0, 0, 0, 0, 1, 0, 0, 0},
                                               {0, 0, 0, 0, 0, 0, 1, 0, 0}}});
  APatchOptions options;
  const Feature sphere = options.table.add_magnitude(radius);
  options.features = bit(sphere);
  options.samples = samples;
  APatchStatistics statistics;
  const Approximation result = extract_a_patches(field, options, &statistics);
  ASSERT_EQ(statistics.features[index(sphere)].subdivided, 0u);  // or there may be cracks
  const FeatureMesh& mesh = result.mesh(sphere);
  const SurfaceTopology topology = surface_topology(mesh.triangles, mesh.points.size());
  EXPECT_TRUE(topology.closed() && topology.manifold());
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.euler, 2);
  EXPECT_EQ(topology.orientation_conflicts, 0u);
  EXPECT_TRUE(result.given_up.empty());
  for (const Point& x : mesh.points)
    EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), radius, 1e-14 * radius);
  const double area = 4 * std::numbers::pi * radius * radius;
  const double error = 0.03 / (samples * samples);  // of a mesh: second order
  EXPECT_NEAR(area_approx(mesh.points, mesh.triangles), area, error * area);
  EXPECT_NEAR(volume(mesh), area * radius / 3, 2 * error * area * radius / 3);
  EXPECT_EQ(mesh.certified, std::vector<std::uint8_t>(mesh.triangles.size(), 0));
}

TEST(ClosedForms, SphereOfConstantMagnitude) {
  expect_sphere(1, 0.75);
  expect_sphere(2, 0.75);
  expect_sphere(5, 0.75);
}

/// tr T = 3 z: the plane z = 0, with normals towards negative z, out of {tr T > 0}.
TEST(ClosedForms, TracelessPlane) {
  const TensorField field = linear_field(6, {{{0.1, 1, 0, 0, 0.1, 0, 0, 0, 0.1},
                                              {0, 0, 1, 0, 0, 0, 0, 0, 0},
                                              {0, 0, 0, 0, 0, 1, 0, 0, 0},
                                              {1, 0, 0, 0, 1, 0, 0, 0, 1}}});
  APatchOptions options;
  const Feature plane = options.table.add_traceless();
  options.features = bit(plane);
  const FeatureMesh mesh = extract_a_patches(field, options).mesh(plane);
  EXPECT_EQ(surface_topology(mesh.triangles, mesh.points.size()).euler, 1);
  EXPECT_NEAR(area_approx(mesh.points, mesh.triangles), 4, 1e-13);
  EXPECT_NEAR(volume(mesh), 4 * 0.1 / 3, 1e-13);  // z = -0.1 times a normal of -1
  for (const Point& x : mesh.points) EXPECT_NEAR(x[2], -0.1, 1e-15);
}

/// tr T = 3 z, |T|^2 = 3 z^2 + x^2 + y^2: the cone z^2 (1 - eta^2) = eta^2 (x^2 + y^2) / 3, of
/// which the sign of eta takes one nappe.
TEST(ClosedForms, NappeOfAnIsotropicityCone) {
  const TensorField field = linear_field(8, {{{},
                                              {0, 1, 0, 0, 0, 0, 0, 0, 0},
                                              {0, 0, 0, 0, 0, 1, 0, 0, 0},
                                              {1, 0, 0, 0, 1, 0, 0, 0, 1}}});
  for (const double eta : {0.6, -0.6}) {
    APatchOptions options;
    const Feature cone = options.table.add_isotropicity(eta);
    options.features = bit(cone);
    const FeatureMesh mesh = extract_a_patches(field, options).mesh(cone);
    ASSERT_GT(mesh.triangles.size(), 100u);
    const double slope = std::sqrt(0.36 / 0.64 / 3);
    for (const Point& x : mesh.points)
      if (std::hypot(x[0], x[1]) > 0.4) {
        EXPECT_NEAR(x[2], std::copysign(slope, eta) * std::hypot(x[0], x[1]), 1e-13);
      }
    double up = 0;  // the projected area, with the sign of the normals: out of the cone
    for (const auto& t : mesh.triangles) {
      const Point &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
      up += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    }
    EXPECT_NEAR(up, eta > 0 ? -4 : 4, 0.05);
  }
}

double lorenz_p(const Point& x) { return x[0] * x[0] + 10 * x[2] - 8179.0 / 27; }
double lorenz_q(const Point& x) {
  return -(49.0 / 9) * x[0] * x[0] - 10 * x[0] * x[1] + (170.0 / 9) * x[2] - 412216.0 / 729;
}

/// Points that the method found lie on the surface. Those at the ends of cuts lie between two such,
/// and have the invariant zero that divides the surface.
TEST(ClosedForms, VerticesOfLorenzLieOnTheSurfaces) {
  GridOptions grid;
  grid.n = 9;
  const TensorField field = generate_lorenz(grid);
  const Approximation result = extract_a_patches(field);
  constexpr double kP = 1000, kQ = 10000;  // the size of p and q in the box
  for (const FeatureRow& row : result.table.rows()) {
    const FeatureMesh& mesh = result.mesh(row.feature);
    ASSERT_GT(mesh.points.size(), 10u) << row.name;
    std::size_t on = 0;
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
      const double p = lorenz_p(mesh.points[n]), q = lorenz_q(mesh.points[n]);
      EXPECT_NEAR(mesh.p[n], p, 1e-12 * kP);
      EXPECT_NEAR(mesh.q[n], q, 1e-12 * kQ);
      if (std::fabs(p) > 1e-3 * kP) {
        EXPECT_NEAR(mesh.mode[n], 1.5 * std::sqrt(3) * std::fabs(q) / std::pow(std::fabs(p), 1.5),
                    1e-6 * (1 + mesh.mode[n]));
      }
      const double d = 4 * p * p * p + 27 * q * q;
      const bool p_is_zero = std::fabs(p) < 1e-9 * kP, q_is_zero = std::fabs(q) < 1e-9 * kQ;
      if (row.kind == FeatureKind::Curve) {
        EXPECT_TRUE(q_is_zero);  // p is second order in the size of the triangles
        continue;
      }
      if (row.mode.is_zero()) {
        on += q_is_zero || p_is_zero;
        EXPECT_GE(p * static_cast<int>(row.sign_p), -1e-9 * kP);
      } else {
        on += q_is_zero || (row.mode.is_infinite() ? p_is_zero : std::fabs(d) < 1e-9 * kQ * kQ);
        EXPECT_GE(q * static_cast<int>(row.sign_q), -1e-9 * kQ);
      }
    }
    if (row.kind == FeatureKind::Curve) continue;
    EXPECT_GT(on, mesh.points.size() * 49 / 50) << row.name;  // the others: midpoints of chords
  }
  const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
  const CurveTopology topology = curve_topology(curve.segments, curve.points.size());
  EXPECT_EQ(topology.components, 2u);
  EXPECT_EQ(topology.ends, 4u);
}

TEST(ClosedForms, ModePagesOfLorenz) {
  GridOptions grid;
  grid.n = 7;
  const TensorField field = generate_lorenz(grid);
  APatchOptions options;
  const std::array<std::array<Sign, 2>, 4> quadrants{{{Sign::Negative, Sign::Positive},
                                                      {Sign::Negative, Sign::Negative},
                                                      {Sign::Positive, Sign::Positive},
                                                      {Sign::Positive, Sign::Negative}}};
  options.features = 0;
  for (const auto& [p, q] : quadrants)
    options.features |= bit(options.table.add_mode({3, 2}, p, q));
  const Approximation result = extract_a_patches(field, options);
  for (const FeatureRow& row : result.table.rows()) {
    const FeatureMesh& mesh = result.mesh(row.feature);
    if (!contains(options.features, row.feature)) {
      EXPECT_TRUE(mesh.points.empty());
      continue;
    }
    ASSERT_GT(mesh.points.size(), 50u) << row.name;
    std::size_t on = 0, uncut = 0;
    for (std::size_t n = 0; n < mesh.points.size(); ++n) {
      EXPECT_GE(mesh.q[n] * static_cast<int>(row.sign_q), -1e-6);
      const bool on_page =
          std::fabs(mesh.mode[n] - 1.5) < 1e-6 && mesh.p[n] * static_cast<int>(row.sign_p) > 0;
      const bool on_cut = std::fabs(mesh.q[n]) < 1e-6;
      on += on_page || on_cut;
      uncut += on_page;
    }
    EXPECT_GT(on, mesh.points.size() * 99 / 100) << row.name;
    EXPECT_GT(uncut, mesh.points.size() / 2) << row.name;
  }
}

}  // namespace
}  // namespace triplex

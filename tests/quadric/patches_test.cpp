// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Single tets with quadrics by construction, through the entrance.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "form_fields.hpp"
#include "random_quadrics.hpp"
#include "triplex/quadric/quadric_extraction.hpp"
#include "triplex/topology/surface_topology.hpp"

namespace triplex {
namespace {

using namespace test;

QuadricExtraction balanced(const TensorField& field, int samples = 4) {
  QuadricOptions options;
  options.samples = samples;
  options.threads = 1;
  return extract_quadric(field, standard_features().row(Feature::BalancedLinear), options);
}

SurfaceTopology topology_of(const QuadricExtraction& e) {
  return surface_topology(e.mesh.triangles, e.mesh.points.size());
}

/// The mesh is that of the pieces, and an oriented manifold.
void expect_faithful(const QuadricExtraction& e) {
  EXPECT_TRUE(e.unmeshed.empty());
  const SurfaceTopology t = topology_of(e);
  std::uint64_t components = 0, loops = 0;
  std::int64_t euler = 0;
  for (const QuadricPiece& p : e.pieces) {
    components += p.components;
    loops += p.loops;
    euler += p.euler;
  }
  EXPECT_EQ(t.components, components);
  EXPECT_EQ(t.boundary_loops, loops);
  EXPECT_EQ(t.euler, euler);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.orientation_conflicts, 0u);
}

struct Expected {
  QuadricType type;
  std::uint32_t components, loops;
};

void expect_quadric(const std::vector<Linear>& plus, const std::vector<Linear>& minus,
                    const Expected& expected) {
  const TensorField field = quadric_field(kAroundOrigin, plus, minus);
  for (const int samples : {2, 4, 9}) {
    const QuadricExtraction e = balanced(field, samples);
    ASSERT_EQ(e.pieces.size(), 1u) << name_of(expected.type);
    EXPECT_EQ(e.pieces[0].type, expected.type) << name_of(e.pieces[0].type);
    EXPECT_EQ(e.pieces[0].components, expected.components) << name_of(expected.type);
    EXPECT_EQ(e.pieces[0].loops, expected.loops) << name_of(expected.type);
    EXPECT_EQ(e.types[static_cast<std::size_t>(expected.type)], 1u);
    expect_faithful(e);
    double largest = 0;
    for (const Point& x : e.mesh.points) {
      double value = 0, size = 0;
      for (const Linear& l : plus) value += l(x) * l(x), size += l(x) * l(x);
      for (const Linear& l : minus) value -= l(x) * l(x), size += l(x) * l(x);
      largest = std::fmax(largest, std::fabs(value) / size);
    }
    EXPECT_LT(largest, 1e-12) << name_of(expected.type);
  }
}

TEST(Patches, EveryTypeWithASurface) {
  using enum QuadricType;
  const auto u = [](double a, double b, double c, double d) -> Linear {
    return [=](const triplex::Point& x) { return a * x[0] + b * x[1] + c * x[2] + d; };
  };
  const Linear r = times(3, one_of);
  expect_quadric({r}, {x_of, y_of, z_of}, {Ellipsoid, 1, 0});
  expect_quadric({times(8, one_of)}, {x_of, y_of, z_of}, {Ellipsoid, 1, 3});
  // a tube from face to face, along the x axis and askew
  expect_quadric({u(0.25, 0, 0, 0.125), r}, {u(0, 1, .25, 0), u(.125, 0, 1, 0)},
                 {OneSheetHyperboloid, 1, 2});
  expect_quadric({r}, {u(0, 1, .25, 0), u(.125, 0, 1, 0)}, {EllipticCylinder, 1, 2});
  expect_quadric({u(1, .125, .25, 0)}, {y_of, z_of, one_of}, {TwoSheetHyperboloid, 2, 2});
  expect_quadric({u(1, .125, .25, 0)}, {r, u(.25, .125, 1, .375)}, {HyperbolicCylinder, 2, 2});
  expect_quadric({u(.25, .125, .0625, 5)}, {y_of, z_of}, {Cone, 1, 2});
  expect_quadric({u(1, .125, .25, 0)}, {r}, {ParallelPlanes, 2, 2});
  expect_quadric({u(1, .0625, 0, -10)}, {u(0, .0625, 0, -10)}, {CrossingPlanes, 2, 2});
  expect_quadric({u(0.5, .125, .25, 1)}, {u(0.5, .125, .25, -1)}, {SinglePlane, 1, 1});
  expect_quadric({u(0.5, .125, .25, 1)}, {u(0.5, .125, .25, -1), u(.375, 1, 0, 1)},
                 {ParabolicCylinder, 1, 1});
  expect_quadric({u(0.5, .125, .25, 1)},
                 {u(0.5, .125, .25, -1), u(.375, 1, 0, 1), u(0, 0.125, 1, 1)},
                 {EllipticParaboloid, 1, 1});
  expect_quadric({u(0.5, .125, .25, 1), u(0, 0.125, 1, 1)},
                 {u(0.5, .125, .25, -1), u(.375, 1, 0, 1)}, {HyperbolicParaboloid, 1, 1});
}

TEST(Patches, RandomCentralQuadrics) {
  std::mt19937 random(6);
  int several = 0;
  for (int n = 0; n < 1500; ++n) {
    const QuadricExtraction e = balanced(random_central_quadric(random, 1 + n % 2), 2 + n % 4);
    expect_faithful(e);
    if (HasFailure()) {
      ADD_FAILURE() << "field " << n;
      return;
    }
    for (const QuadricPiece& p : e.pieces) several += p.loops > p.components;
  }
  EXPECT_GT(several, 200);
}

TEST(Patches, RandomQuadrics) {
  std::mt19937 random(7);
  for (const auto& [plus, minus] :
       {std::pair<std::size_t, std::size_t>{1, 3}, {3, 1}, {2, 2}, {1, 2}, {2, 1}, {1, 1}})
    for (int n = 0; n < 300; ++n) {
      const QuadricExtraction e = balanced(random_quadric(random, plus, minus), 2 + n % 4);
      expect_faithful(e);
      if (HasFailure()) {
        ADD_FAILURE() << "field " << plus << minus << " " << n;
        return;
      }
    }
}

TEST(Patches, AreaOfASphere) {
  const TensorField field = quadric_field(kAroundOrigin, {times(3, one_of)}, {x_of, y_of, z_of});
  double last = 0;
  for (const int samples : {4, 8, 16, 32}) {
    const QuadricExtraction e = balanced(field, samples);
    const double error = 36 * M_PI - area_approx(e.mesh.points, e.mesh.triangles);
    EXPECT_GT(error, 0);
    if (last > 0) {
      EXPECT_LT(error, last / 3.5);  // second order
    }
    last = error;
  }
}

}  // namespace
}  // namespace triplex

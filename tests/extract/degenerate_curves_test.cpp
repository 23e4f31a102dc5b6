// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symmetric fields: the degenerate features are curves.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../oracle/symmetric_oracle.hpp"
#include "fields.hpp"
#include "triplex/field/symmetric.hpp"
#include "triplex/topology/curve_topology.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kBoth = bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar);
constexpr std::array<Feature, 2> kFeatures = {Feature::DegenerateLinear, Feature::DegeneratePlanar};

GridOptions grid(int n, double jitter = 0, std::uint64_t seed = 1) {
  GridOptions options;
  options.n = n;
  options.jitter = jitter;
  options.seed = seed;
  return options;
}

/// A symmetric tensor of the position, sampled on a grid of [-1, 1]^3.
template <class Tensor>
TensorField sampled(const GridOptions& options, const Tensor& tensor) {
  TensorField field = generate_symmetric(options);
  for (std::size_t v = 0; v < field.tensors.size(); ++v)
    field.tensors[v] = tensor(field.mesh.points[v]);
  return field;
}

Extraction extract_curves(const TensorField& field, unsigned threads = 0) {
  ExtractionOptions options;
  options.features = kBoth;
  options.threads = threads;
  return extract(field, options);
}

CurveTopology topology(const FeatureMesh& mesh) {
  return curve_topology(mesh.segments, mesh.points.size());
}

bool is_on_boundary(const Point& x, double half_width = 1) {
  return std::ranges::any_of(
      x, [&](double c) { return std::fabs(std::fabs(c) - half_width) < 1e-12; });
}

/// No branches; ends on the boundary of the box only.
void expect_closed_in_the_box(const FeatureMesh& mesh) {
  std::vector<int> degree(mesh.points.size());
  for (const auto& s : mesh.segments)
    for (const std::uint32_t v : s) ++degree[v];
  for (std::size_t v = 0; v < degree.size(); ++v) {
    EXPECT_LE(degree[v], 2);
    EXPECT_TRUE(degree[v] != 1 || is_on_boundary(mesh.points[v]));
  }
}

TEST(DegenerateCurves, OfALinearFieldDoNotDependOnTheMesh) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 6, 8}) {
    std::vector<Extraction> results;
    for (const GridOptions& options :
         {grid(1, 0, seed), grid(4, 0, seed), grid(4, 0.3, seed), grid(8, 0.2, seed)})
      results.push_back(extract_curves(generate_symmetric(options)));
    for (const Extraction& e : results) {
      EXPECT_TRUE(e.certified());
      EXPECT_EQ(e.curves, kBoth);
      EXPECT_FALSE(e.curves_shifted);
      for (const Feature f : kFeatures) {
        const FeatureMesh &mesh = e.mesh(f), &coarsest = results[0].mesh(f);
        EXPECT_TRUE(mesh.triangles.empty());
        EXPECT_EQ(topology(mesh).components, topology(coarsest).components);
        EXPECT_EQ(topology(mesh).closed, topology(coarsest).closed);
        EXPECT_NEAR(length_approx(mesh.points, mesh.segments),
                    length_approx(coarsest.points, coarsest.segments), 0.02);
        expect_closed_in_the_box(mesh);
      }
    }
  }
}

/// The field is linear: each vertex must be degenerate.
TEST(DegenerateCurves, VerticesAreDegenerate) {
  GridOptions corner = grid(1, 0, 2);
  const TensorField box = generate_symmetric(corner);
  ExtractionOptions options;
  options.features = kBoth;
  options.keep_tensors = true;
  const Extraction e = extract(generate_symmetric(grid(4, 0.2, 2)), options);
  for (const Feature f : kFeatures) {
    const FeatureMesh& mesh = e.mesh(f);
    ASSERT_GT(mesh.points.size(), 10u);
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const Eigen::Vector3d l =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(oracle::to_matrix(mesh.tensors[v]))
              .eigenvalues();
      const bool planar = f == Feature::DegeneratePlanar;
      EXPECT_NEAR(planar ? l[2] - l[1] : l[1] - l[0], 0, 1e-12);
      EXPECT_EQ(mesh.mode[v], 1);
      EXPECT_LT(mesh.p[v], 0);
      EXPECT_EQ(mesh.q[v] < 0, planar);
    }
  }
}

TEST(DegenerateCurves, AreClosedInNoise) {
  TensorField field = generate_noise(grid(4, 0.2, 5));
  for (Point& x : field.mesh.points)
    for (double& c : x) c = 2 * c - 1;
  take_symmetric_part(field);
  const Extraction e = extract_curves(field);
  EXPECT_TRUE(e.certified());
  std::uint64_t closed = 0;
  for (const Feature f : kFeatures) {
    expect_closed_in_the_box(e.mesh(f));
    closed += topology(e.mesh(f)).closed;
    EXPECT_GT(topology(e.mesh(f)).components, 20u);
  }
  EXPECT_GT(closed, 3u);
}

TEST(DegenerateCurves, DoNotDependOnThreadsOrNumbers) {
  TensorField field = generate_noise(grid(4, 0.2, 9));
  take_symmetric_part(field);
  const Extraction one = extract_curves(field, 1), four = extract_curves(field, 4);
  const Extraction other = extract_curves(test::relabelled(field, 3));
  for (const Feature f : kFeatures) {
    EXPECT_EQ(one.mesh(f).points, four.mesh(f).points);
    EXPECT_EQ(one.mesh(f).segments, four.mesh(f).segments);
    EXPECT_EQ(one.mesh(f).source_cell, four.mesh(f).source_cell);
    EXPECT_EQ(test::geometry(one.mesh(f)), test::geometry(other.mesh(f)));
  }
}

/// diag(1 + r, 1 - r, -2) with z beside, r = x^2 + y^2 - 0.4: planar on the circle r = z = 0, which
/// lies in a plane of faces, where all tensors have the axis z.
TEST(DegenerateCurves, ACircleInAPlaneOfFacesIsOneClosedCurve) {
  for (const double jitter : {0.0, 0.2}) {
    const Extraction e = extract_curves(sampled(grid(8, jitter), [](const Point& x) {
      const double r = x[0] * x[0] + x[1] * x[1] - 0.4;
      return Tensor<double>{1 + r, x[2], 0, x[2], 1 - r, 0, 0, 0, -2};
    }));
    EXPECT_TRUE(e.certified());
    EXPECT_TRUE(e.curves_shifted);
    EXPECT_TRUE(e.mesh(Feature::DegenerateLinear).segments.empty());
    const FeatureMesh& mesh = e.mesh(Feature::DegeneratePlanar);
    EXPECT_EQ(topology(mesh).components, 1u);
    EXPECT_EQ(topology(mesh).closed, 1u);
    for (const Point& x : mesh.points) EXPECT_NEAR(x[2], 0, 1e-12);
    EXPECT_NEAR(length_approx(mesh.points, mesh.segments), 2 * std::acos(-1) * std::sqrt(0.4), 0.1);
  }
}

/// The curve runs along edges of the mesh.
TEST(DegenerateCurves, ALineOfEdgesIsOneCurve) {
  const Extraction e = extract_curves(sampled(grid(4), [](const Point& x) {
    return Tensor<double>{1 + x[0], x[1], 0, x[1], 1 - x[0], 0, 0, 0, -2};
  }));
  EXPECT_TRUE(e.certified());
  EXPECT_TRUE(e.mesh(Feature::DegenerateLinear).segments.empty());
  const FeatureMesh& mesh = e.mesh(Feature::DegeneratePlanar);
  EXPECT_EQ(topology(mesh).components, 1u);
  EXPECT_EQ(topology(mesh).ends, 2u);
  EXPECT_NEAR(length_approx(mesh.points, mesh.segments), 2, 1e-12);
}

/// All tensors vanish at the origin, through which lines of degenerate points pass, each linear on
/// one side of it and planar on the other.
TEST(DegenerateCurves, ATripleDegeneratePointIsShifted) {
  const Extraction e = extract_curves(sampled(grid(5), [](const Point& x) {
    const auto& [a, b, c] = x;
    return Tensor<double>{a, b, c, b, c - a, a + 2 * b, c, a + 2 * b, -c};
  }));
  EXPECT_TRUE(e.certified());
  std::size_t ends = 0;
  for (const Feature f : kFeatures) {
    expect_closed_in_the_box(e.mesh(f));
    ends += topology(e.mesh(f)).ends;
  }
  // Lines through the origin leave the box twice.
  EXPECT_EQ(ends % 2, 0u);
  EXPECT_GT(ends, 0u);
}

TEST(DegenerateCurves, NothingIsMadeUpWhereTensorsVanishOrDoNotChange) {
  for (const Tensor<double>& t : {Tensor<double>{}, Tensor<double>{5, 0, 0, 0, 5, 0, 0, 0, 5},
                                  Tensor<double>{1, 0, 0, 0, 1, 0, 0, 0, -2}}) {
    const Extraction e = extract_curves(sampled(grid(2), [&](const Point&) { return t; }));
    EXPECT_TRUE(e.certified());
    EXPECT_TRUE(e.curves_shifted);
    for (const Feature f : kFeatures) EXPECT_TRUE(e.mesh(f).segments.empty());
  }
  const Extraction e = extract_curves(sampled(grid(8), [](const Point& x) {
    return x[0] < 0 ? Tensor<double>{}
                    : Tensor<double>{1 + x[0], x[1], 0.5, x[1], 1 - x[0], x[2], 0.5, x[2], -2};
  }));
  EXPECT_TRUE(e.certified());
  for (const Feature f : kFeatures)
    for (const auto& s : e.mesh(f).segments)
      for (const std::uint32_t v : s) EXPECT_GE(e.mesh(f).points[v][0], -0.25 - 1e-9);
}

/// Strain rates of the Arnold-Beltrami-Childress flow have no diagonal: they span three dimensions,
/// so that in the shifted field pairs of points nearly coincide on the circle of axes. Those of the
/// convection have mirror planes in faces.
TEST(DegenerateCurves, PointsThatOnlyTheShiftSeparatesAreOrdered) {
  for (const bool convection : {false, true}) {
    TensorField field = convection ? generate_rayleigh_benard(grid(8)) : generate_abc(grid(8, 0.2));
    take_symmetric_part(field);
    const Extraction e = extract_curves(field);
    EXPECT_TRUE(e.certified());
    EXPECT_TRUE(e.curves_shifted);
    for (const Feature f : kFeatures) {
      const CurveTopology t = topology(e.mesh(f));
      EXPECT_GT(t.components, 2u);
      EXPECT_EQ(t.branches, 0u);
      EXPECT_EQ(t.ends, 2 * (t.components - t.closed));
    }
  }
}

/// Tensors of small integers on few cells: every kind of coincidence.
TEST(DegenerateCurves, SmallIntegersAreCertifiedAndClosed) {
  std::mt19937_64 random(21);
  int shifted = 0;
  for (int n = 0; n < 20; ++n) {
    TensorField field = generate_symmetric(grid(1 + n % 3, n % 2 == 0 ? 0 : 0.2));
    const auto digit = [&] {
      return static_cast<double>(static_cast<int>(random() % (3 + 2 * (n % 4))) - 1 - n % 4);
    };
    for (Tensor<double>& t : field.tensors) {
      const double xx = digit(), yy = digit(), zz = digit(), yz = digit();
      const double xy = n % 5 == 0 ? 0 : digit(), xz = n % 7 == 0 ? 0 : digit();
      t = {xx, xy, xz, xy, yy, yz, xz, yz, zz};
    }
    const Extraction e = extract_curves(field);
    EXPECT_TRUE(e.certified()) << n;
    shifted += e.curves_shifted;
    for (const Feature f : kFeatures) expect_closed_in_the_box(e.mesh(f));
  }
  EXPECT_GT(shifted, 8);
}

TEST(DegenerateCurves, OtherFeaturesAreSurfacesAsBefore) {
  const TensorField field = generate_symmetric(grid(4, 0.2, 3));
  ExtractionOptions options;
  options.features = bit(Feature::NeutralReal);
  const Extraction alone = extract(field, options);
  const Extraction all = extract(field);
  EXPECT_EQ(all.curves, kBoth);
  EXPECT_GT(alone.mesh(Feature::NeutralReal).triangles.size(), 0u);
  EXPECT_GT(all.mesh(Feature::NeutralReal).triangles.size(), 0u);
  EXPECT_TRUE(all.mesh(Feature::BalancedLinear).triangles.empty());
  EXPECT_TRUE(all.certified());
  EXPECT_TRUE(all.nodes.empty());
  EXPECT_TRUE(all.nodes_undecided.empty());
}

TEST(DegenerateCurves, OneFeatureIsThatOfBoth) {
  const TensorField field = generate_symmetric(grid(4, 0.2, 3));
  const Extraction both = extract_curves(field);
  for (const Feature f : kFeatures) {
    ExtractionOptions options;
    options.features = bit(f);
    const Extraction one = extract(field, options);
    EXPECT_EQ(one.mesh(f).points, both.mesh(f).points);
    EXPECT_EQ(one.mesh(f).segments, both.mesh(f).segments);
    for (const Feature other : kFeatures) EXPECT_TRUE(other == f || one.mesh(other).points.empty());
  }
}

TEST(DegenerateCurves, AsymmetricFieldsHaveNone) {
  TensorField field = generate_symmetric(grid(2, 0.2, 3));
  field.tensors[5][1] = std::nextafter(field.tensors[5][1], 10);
  EXPECT_EQ(extract_curves(field).curves, 0u);
  take_symmetric_part(field);
  EXPECT_EQ(extract_curves(field).curves, kBoth);
}

TEST(DegenerateCurves, DomainsAreCutByTheOtherPages) {
  ExtractionOptions options;
  options.domains = true;
  const Extraction e = extract(generate_symmetric(grid(3, 0.2, 3)), options);
  const auto volumes = domain_volumes_approx(e.domains);
  double sum = 0;
  for (const double v : volumes) sum += v;
  EXPECT_NEAR(sum, 8, 1e-9);
  EXPECT_GT(volumes[static_cast<std::size_t>(Domain::RealLinear)], 0);
  EXPECT_GT(volumes[static_cast<std::size_t>(Domain::RealPlanar)], 0);
  EXPECT_NEAR(volumes[static_cast<std::size_t>(Domain::RealLinear)] +
                  volumes[static_cast<std::size_t>(Domain::RealPlanar)],
              8, 1e-9);
}

/// Curves close through the sides of a periodic domain.
TEST(DegenerateCurves, PeriodicSidesAreOne) {
  for (const bool constant : {false, true}) {
    TensorField field = generate_noise(grid(5, 0.2, 11));
    if (constant)  // not in general position
      for (Tensor<double>& t : field.tensors) t = {1, 0, 0, 0, t[0], t[1], 0, t[1], t[2]};
    make_periodic(field, 5, {true, true, true});
    take_symmetric_part(field);
    ExtractionOptions options;
    options.features = kBoth;
    options.periodic = {true, true, true};
    const Extraction e = extract(field, options);
    EXPECT_TRUE(e.certified());
    EXPECT_EQ(e.curves_shifted, constant);
    for (const Feature f : kFeatures) {
      const FeatureMesh& mesh = e.mesh(f);
      ASSERT_EQ(mesh.identified.size(), mesh.points.size());
      auto glued = mesh.segments;
      for (auto& s : glued)
        for (std::uint32_t& v : s) v = mesh.identified[v];
      const CurveTopology t = curve_topology(glued, mesh.points.size());
      EXPECT_EQ(t.ends, 0u);
      EXPECT_EQ(t.branches, 0u);
      EXPECT_EQ(t.closed, t.components);
    }
  }
}

}  // namespace
}  // namespace triplex

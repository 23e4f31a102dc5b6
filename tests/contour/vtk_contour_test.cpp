// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/contour/vtk_contour.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../extract/topology.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/field/ground_truth.hpp"

namespace triplex {
namespace {

const GroundTruth& truth_named(std::string_view name) {
  return *std::ranges::find(ground_truth_suite(), name, &GroundTruth::name);
}

struct Tested {
  TensorField field;
  Approximation result;
};
Tested contours_of(std::string_view name, int n, FeatureTable table = {}) {
  TensorField field = sample_ground_truth(truth_named(name), n);
  const FeatureSet all = table.all();
  Approximation result = extract_vtk_contours(field, table, all);
  return {std::move(field), std::move(result)};
}

Point corner(const FeatureMesh& mesh, std::size_t cell, int i) {
  return mesh.segments.empty() ? mesh.points[mesh.triangles[cell][i]]
                               : mesh.points[mesh.segments[cell][i]];
}
double determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<Point, 3> m;
  for (int k = 0; k < 3; ++k) m[0][k] = b[k] - a[k], m[1][k] = c[k] - a[k], m[2][k] = d[k] - a[k];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
/// The least barycentric coordinate of a point in a tet.
double depth(const TensorField& field, std::int64_t tet, const Point& x) {
  std::array<Point, 4> v;
  for (int i = 0; i < 4; ++i)
    v[i] = field.mesh.points[index(field.mesh.tets[static_cast<std::size_t>(tet)][i])];
  const double volume = determinant(v[0], v[1], v[2], v[3]);
  double least = 1;
  for (int i = 0; i < 4; ++i) {
    auto w = v;
    w[i] = x;
    least = std::min(least, determinant(w[0], w[1], w[2], w[3]) / volume);
  }
  return least;
}

TEST(VtkContour, CellsLieInTheirTets) {
  FeatureTable table;
  table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  table.add_magnitude(31);
  const auto [field, result] = contours_of("lorenz-classic", 8, table);
  std::size_t cells = 0;
  for (const FeatureMesh& mesh : result.features) {
    const std::size_t count = std::max(mesh.triangles.size(), mesh.segments.size());
    ASSERT_EQ(mesh.source_cell.size(), count);
    ASSERT_EQ(mesh.certified, std::vector<std::uint8_t>(count, 0));
    ASSERT_EQ(mesh.p.size(), mesh.points.size());
    for (std::size_t c = 0; c < count; ++c) {
      for (int i = 0; i < (mesh.segments.empty() ? 3 : 2); ++i)
        EXPECT_GT(depth(field, mesh.source_cell[c], corner(mesh, c, i)), -1e-12);
    }
    cells += count;
  }
  EXPECT_GT(cells, 1000u);
}

TEST(VtkContour, LabelsFollowTheOtherInvariant) {
  const auto [field, result] = contours_of("spine-loop-in-tet", 16);
  // Balanced: linear above z = 0; neutral: complex inside the circle. Up to the size of a cell.
  constexpr double kCell = 0.25;
  for (const Point& x : result.mesh(Feature::BalancedLinear).points) EXPECT_GT(x[2], -kCell / 4);
  for (const Point& x : result.mesh(Feature::BalancedPlanar).points) EXPECT_LT(x[2], kCell / 4);
  for (const Point& x : result.mesh(Feature::NeutralComplex).points)
    EXPECT_LT(std::hypot(x[0], x[1]), 0.5 + kCell / 2);
  for (const Point& x : result.mesh(Feature::NeutralReal).points)
    EXPECT_GT(std::hypot(x[0], x[1]), 0.5 - kCell / 2);
  for (const Point& x : result.mesh(Feature::DegenerateLinear).points) EXPECT_GT(x[2], -kCell / 4);
  EXPECT_FALSE(result.mesh(Feature::TripleCurve).segments.empty());
  for (const Point& x : result.mesh(Feature::TripleCurve).points)
    EXPECT_NEAR(std::hypot(x[0], x[1]), 0.5, kCell / 4);
}

/// On the spine loop, p, q, and D are near zero on the surfaces: the error of linear interpolation
/// falls with the square of the spacing.
TEST(VtkContour, ErrorsFallWithTheSquareOfTheSpacing) {
  const auto error = [](int n) {
    const auto [field, result] = contours_of("spine-loop-in-tet", n);
    double largest = 0;
    for (const Feature f : {Feature::BalancedLinear, Feature::BalancedPlanar})
      for (const Point& x : result.mesh(f).points)
        largest =
            std::max(largest, std::fabs(0.25 - x[0] * x[0] - x[1] * x[1] - 0.75 * x[2] * x[2]));
    return largest;
  };
  const double coarse = error(16), fine = error(32);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, 0.35 * coarse);
}

/// Normals point where the angle of (p, q) grows, of a level set outwards: checked by the closed
/// forms, at the middle of every triangle.
TEST(VtkContour, NormalsPointWhereTheAngleGrows) {
  FeatureTable table;
  const Feature mode = table.add_mode({2, 1}, Sign::Negative, Sign::Positive);
  const auto [field, result] = contours_of("spine-loop-in-tet", 16, table);
  const auto angle = [](const Point& x) {
    const double r = x[0] * x[0] + x[1] * x[1];
    const double p = 0.25 - r - 0.75 * x[2] * x[2];
    const double q = x[2] * (x[2] * x[2] / 4 + r / 2 + 0.25);
    return std::atan2(q, p);
  };
  std::vector<Feature> features = {mode};
  for (int f = 0; f < kStandardPages; ++f) features.push_back(static_cast<Feature>(f));
  for (const Feature f : features) {
    const FeatureMesh& mesh = result.mesh(f);
    std::size_t right = 0;
    ASSERT_GT(mesh.triangles.size(), 10u) << result.table.row(f).name;
    for (const auto& t : mesh.triangles) {
      Point middle{}, a, b, ahead, behind;
      for (int k = 0; k < 3; ++k) {
        const double x = mesh.points[t[0]][k];
        a[k] = mesh.points[t[1]][k] - x;
        b[k] = mesh.points[t[2]][k] - x;
        middle[k] = (x + mesh.points[t[1]][k] + mesh.points[t[2]][k]) / 3;
      }
      const Point normal = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                            a[0] * b[1] - a[1] * b[0]};
      const double length = std::hypot(normal[0], normal[1], normal[2]);
      for (int k = 0; k < 3; ++k) {
        ahead[k] = middle[k] + 1e-6 * normal[k] / length;
        behind[k] = middle[k] - 1e-6 * normal[k] / length;
      }
      right += std::remainder(angle(ahead) - angle(behind), 2 * M_PI) > 0;
    }
    // All but those next to the triple curve, where the angle turns with the distance.
    EXPECT_GT(right, 0.9 * static_cast<double>(mesh.triangles.size())) << result.table.row(f).name;
  }
}

TEST(VtkContour, SpheresAreClosedAndFaceOutwards) {
  FeatureTable table;
  const Feature ball = table.add_magnitude(6050);
  const auto [field, result] = contours_of("magnitude-ball", 32, table);
  const FeatureMesh& mesh = result.mesh(ball);
  EXPECT_EQ(test::topology_of(mesh), (test::Topology{1, 0, 2}));
  for (const auto& t : mesh.triangles) {
    const Point origin{};
    EXPECT_GT(determinant(origin, mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]), 0);
  }
  for (const Point& x : mesh.points) EXPECT_NEAR(std::hypot(x[0], x[1], x[2]), 55.0 / 256, 0.02);
}

TEST(VtkContour, MissesTheSphereInsideATet) {
  const auto [field, result] = contours_of("balanced-ball-linear", 8);
  EXPECT_TRUE(result.mesh(Feature::BalancedLinear).triangles.empty());
  EXPECT_TRUE(result.given_up.empty());
}

/// On easy fields with fine meshes contours and certified surfaces agree in topology.
TEST(VtkContour, AgreesWithTheCertifiedOnAnEasyField) {
  const auto [field, result] = contours_of("lorenz-classic", 16);
  const Extraction certified = extract(field);
  for (const Feature f : {Feature::NeutralReal, Feature::NeutralComplex, Feature::BalancedLinear,
                          Feature::BalancedPlanar, Feature::TripleCurve}) {
    EXPECT_EQ(test::topology_of(result.mesh(f)), test::topology_of(certified.mesh(f)))
        << result.table.row(f).name;
  }
}

/// Where surfaces are far apart and the mesh is fine, contours have the topology that was derived:
/// a road to it that shares nothing with certificates.
TEST(VtkContour, FatSurfacesHaveTheDerivedTopology) {
  for (const char* name : {"lorenz-classic", "lorenz-node-in-tet", "lorenz-node-on-face",
                           "spine-loop-in-tet", "degenerate-tube-1_8", "balanced-tube-1_1"}) {
    const auto [field, result] = contours_of(name, 32);
    const GroundTruth& truth = truth_named(name);
    const bool has_curve = truth.curve->components > 0;
    for (const SurfaceTruth& known : truth.surfaces) {
      if (has_curve && known.feature.starts_with("degenerate")) continue;  // a cusp: no contour
      const Feature feature = *result.table.named(known.feature);
      EXPECT_EQ(test::topology_of(result.mesh(feature)),
                (test::Topology{static_cast<std::uint64_t>(known.components),
                                static_cast<std::uint64_t>(known.boundary_loops), known.euler}))
          << name << ", " << known.feature;
    }
    EXPECT_EQ(test::topology_of(result.mesh(Feature::TripleCurve)),
              (test::Topology{static_cast<std::uint64_t>(truth.curve->components),
                              static_cast<std::uint64_t>(truth.curve->ends), truth.curve->closed}))
        << name;
  }
}

TEST(VtkContour, OnlyWhatIsAskedFor) {
  const TensorField field = sample_ground_truth(truth_named("lorenz-classic"), 8);
  const Approximation result =
      extract_vtk_contours(field, standard_features(), bit(Feature::NeutralReal));
  for (std::size_t f = 0; f < result.features.size(); ++f)
    EXPECT_EQ(result.features[f].points.empty(), f != index(Feature::NeutralReal));
}

TEST(VtkContour, IsotropicityAndTracelessAreThoseOfTheTensors) {
  // T = x I + constant: tr = 3 x + tr(T0).
  TensorField field = generate_constant({.n = 8});
  for (std::size_t v = 0; v < field.tensors.size(); ++v)
    for (const int i : {0, 4, 8}) field.tensors[v][i] += 8 * field.mesh.points[v][0] - 5;
  FeatureTable table;
  const Feature zero = table.add_traceless(), some = table.add_isotropicity(0.25),
                less = table.add_isotropicity(-0.25);
  const Approximation result = extract_vtk_contours(field, table, table.all());
  for (const auto& [f, eta] : {std::pair{zero, 0.0}, {some, 0.25}, {less, -0.25}}) {
    const FeatureMesh& mesh = result.mesh(f);
    ASSERT_FALSE(mesh.triangles.empty());
    for (const Point& x : mesh.points) {
      Tensor<double> t = kDefaultConstantTensor;
      for (const int i : {0, 4, 8}) t[i] += 8 * x[0] - 5;
      double norm = 0;
      for (const double e : t) norm += e * e;
      EXPECT_NEAR((t[0] + t[4] + t[8]) / std::sqrt(3 * norm), eta, 0.02);
    }
    // Outwards of tr > ..., so to lower x; of eta < 0 the set is tr < ..., so to higher x.
    const auto& [a, b, c] = mesh.triangles.front();
    const Point &A = mesh.points[a], &B = mesh.points[b], &C = mesh.points[c];
    const double nx = (B[1] - A[1]) * (C[2] - A[2]) - (B[2] - A[2]) * (C[1] - A[1]);
    EXPECT_EQ(nx > 0, eta < 0);
  }
}

}  // namespace
}  // namespace triplex

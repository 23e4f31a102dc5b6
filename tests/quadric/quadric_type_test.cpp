// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/quadric_type.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "form_fields.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {
namespace {

using enum QuadricType;
using Matrix = std::array<std::array<int, 4>, 4>;

/// Coefficients in x, y, z, w of a normal form: diagonal, and the entry (z, w).
struct NormalForm {
  std::array<int, 4> diagonal;
  int zw;
  QuadricType type;
};
const NormalForm kNormalForms[] = {
    {{1, 1, 1, -1}, 0, Ellipsoid},
    {{1, 1, 1, 1}, 0, Empty},
    {{1, 1, -1, -1}, 0, OneSheetHyperboloid},
    {{1, 1, -1, 1}, 0, TwoSheetHyperboloid},
    {{1, 1, 0, 0}, 1, EllipticParaboloid},
    {{1, -1, 0, 0}, 1, HyperbolicParaboloid},
    {{1, 1, -1, 0}, 0, Cone},
    {{1, 1, 1, 0}, 0, SinglePoint},
    {{1, 1, 0, -1}, 0, EllipticCylinder},
    {{1, 1, 0, 1}, 0, Empty},
    {{1, -1, 0, -1}, 0, HyperbolicCylinder},
    {{1, -1, 0, 1}, 0, HyperbolicCylinder},
    {{1, 0, 0, 0}, 1, ParabolicCylinder},
    {{1, -1, 0, 0}, 0, CrossingPlanes},
    {{1, 1, 0, 0}, 0, SingleLine},
    {{1, 0, 0, -1}, 0, ParallelPlanes},
    {{1, 0, 0, 1}, 0, Empty},
    {{0, 0, 0, 0}, 1, SinglePlane},
    {{1, 0, 0, 0}, 0, DoublePlane},
    {{0, 0, 0, 1}, 0, Empty},
    {{0, 0, 0, 0}, 0, Everything},
};

/// The form in barycentric coordinates of a tet with integer corners.
QuadraticForm<Exact, 4> on_tet(const NormalForm& normal, const Matrix& corners, int factor) {
  QuadraticForm<Exact, 4> f;
  for (int i = 0; i < 4; ++i)
    for (int j = i; j < 4; ++j) {
      Exact sum(0);
      for (int k = 0; k < 4; ++k)
        sum = sum + Exact(normal.diagonal[k]) * Exact(2 * corners[i][k] * corners[j][k]);
      sum =
          sum + Exact(normal.zw * (corners[i][2] * corners[j][3] + corners[i][3] * corners[j][2]));
      f(i, j) = Exact(factor) * sum;
    }
  return f;
}

int det3(const Matrix& m) {
  const auto d = [&](int i, int k) { return m[i][k] - m[3][k]; };
  return d(0, 0) * (d(1, 1) * d(2, 2) - d(1, 2) * d(2, 1)) -
         d(0, 1) * (d(1, 0) * d(2, 2) - d(1, 2) * d(2, 0)) +
         d(0, 2) * (d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0));
}

Matrix random_corners(std::mt19937& random) {
  Matrix m;
  do {
    for (auto& row : m) {
      for (int k = 0; k < 3; ++k) row[k] = std::uniform_int_distribution<int>(-9, 9)(random);
      row[3] = 1;
    }
  } while (det3(m) == 0);
  return m;
}

TEST(QuadricType, EveryTypeInEveryPosition) {
  std::mt19937 random(1);
  std::set<QuadricType> seen;
  for (const NormalForm& normal : kNormalForms)
    for (int n = 0; n < 200; ++n) {
      const int factor = n % 2 == 0 ? 1 : -3;
      const auto form = on_tet(normal, random_corners(random), factor);
      const QuadricType type = quadric_type(form);
      EXPECT_EQ(type, normal.type) << name_of(type) << " for " << name_of(normal.type);
      seen.insert(type);
    }
  EXPECT_EQ(seen.size(), kQuadricTypes);
}

/// Descartes' rule on the characteristic polynomial, whose roots are all real.
TEST(Inertia, AgreesWithTheCharacteristicPolynomial) {
  std::mt19937 random(2);
  std::map<int, int> ranks;
  for (int n = 0; n < 4000; ++n) {
    std::array<std::array<long long, 4>, 4> m{};
    const int range = n % 4 == 0 ? 1 : 3;
    for (int i = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j)
        m[i][j] = m[j][i] =
            (n % 3 == 0 && i == j) ? 0 : std::uniform_int_distribution<int>(-range, range)(random);
    QuadraticForm<Exact, 4> f;
    for (int i = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j) f(i, j) = Exact(static_cast<double>(m[i][j]));
    // Faddeev-LeVerrier: c[4] = 1
    std::array<long long, 5> c{0, 0, 0, 0, 1};
    auto power = m;
    for (int k = 1; k <= 4; ++k) {
      if (k > 1) {
        auto next = m;
        for (int i = 0; i < 4; ++i) power[i][i] += c[4 - k + 1];
        for (int i = 0; i < 4; ++i)
          for (int j = 0; j < 4; ++j) {
            next[i][j] = 0;
            for (int l = 0; l < 4; ++l) next[i][j] += m[i][l] * power[l][j];
          }
        power = next;
      }
      long long trace = 0;
      for (int i = 0; i < 4; ++i) trace += power[i][i];
      c[4 - k] = -trace / k;
    }
    Inertia expected;
    while (c[expected.zero] == 0) ++expected.zero;
    long long last = 0;
    for (int k = expected.zero; k <= 4; ++k) {
      if (c[k] == 0) continue;
      if (last != 0 && (last > 0) != (c[k] > 0)) ++expected.positive;
      last = c[k];
    }
    expected.negative = 4 - expected.zero - expected.positive;
    const auto found = inertia(f);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->positive, expected.positive);
    EXPECT_EQ(found->negative, expected.negative);
    EXPECT_EQ(found->zero, expected.zero);
    ++ranks[found->rank()];
  }
  EXPECT_EQ(ranks.size(), 5u);
}

QuadricType balanced_type(const std::vector<test::Linear>& plus,
                          const std::vector<test::Linear>& minus) {
  const TensorField field = test::quadric_field(test::kAroundOrigin, plus, minus);
  return quadric_type(SimplexForm<4>({}, field, test::kCorners));
}

TEST(QuadricType, OfBalancedSurfaces) {
  using namespace test;
  const auto half_sum = [](const Point& p) { return (p[2] + 1) / 2; };
  const auto half_difference = [](const Point& p) { return (p[2] - 1) / 2; };
  EXPECT_EQ(balanced_type({one_of}, {x_of, y_of, z_of}), Ellipsoid);
  EXPECT_EQ(balanced_type({x_of, y_of}, {z_of, one_of}), OneSheetHyperboloid);
  EXPECT_EQ(balanced_type({x_of}, {y_of, z_of, one_of}), TwoSheetHyperboloid);
  EXPECT_EQ(balanced_type({x_of, y_of, half_sum}, {half_difference}), EllipticParaboloid);
  EXPECT_EQ(balanced_type({x_of, half_sum}, {y_of, half_difference}), HyperbolicParaboloid);
  EXPECT_EQ(balanced_type({x_of}, {y_of, z_of}), Cone);
  EXPECT_EQ(balanced_type({one_of}, {x_of, z_of}), EllipticCylinder);
  EXPECT_EQ(balanced_type({one_of, x_of}, {z_of}), HyperbolicCylinder);
  EXPECT_EQ(balanced_type({half_sum}, {half_difference, y_of}), ParabolicCylinder);
  EXPECT_EQ(balanced_type({x_of}, {y_of}), CrossingPlanes);
  EXPECT_EQ(balanced_type({x_of}, {one_of}), ParallelPlanes);
  EXPECT_EQ(balanced_type({half_sum}, {half_difference}), SinglePlane);
  EXPECT_EQ(balanced_type({}, {y_of}), DoublePlane);
  EXPECT_EQ(balanced_type({y_of, x_of}, {}), SingleLine);
  EXPECT_EQ(balanced_type({y_of, x_of, z_of}, {}), SinglePoint);
  EXPECT_EQ(balanced_type({one_of}, {}), Empty);
  EXPECT_EQ(balanced_type({}, {}), Everything);
}

// A magnitude surface bounds an ellipsoid, never a hyperboloid; an isotropicity surface two nappes.
TEST(QuadricType, OfLevelSets) {
  TensorField field = test::one_tet(test::kAroundOrigin);
  const auto type = [&](QuadricSurface::Kind kind, double value) {
    return quadric_type(SimplexForm<4>({kind, value}, field, test::kCorners));
  };
  using Kind = QuadricSurface::Kind;
  for (std::size_t v = 0; v < 4; ++v) {
    const Point& x = field.mesh.points[v];
    field.tensors[v] = {x[0], x[1], 0, 0, 0, x[2], 0, 0, 0};
  }
  EXPECT_EQ(type(Kind::Magnitude, 1), Ellipsoid);
  EXPECT_EQ(type(Kind::Isotropicity, 0.25), Cone);
  EXPECT_EQ(type(Kind::Traceless, 0), SinglePlane);
  for (std::size_t v = 0; v < 4; ++v) field.tensors[v][5] = 0.5;
  EXPECT_EQ(type(Kind::Magnitude, 1), EllipticCylinder);
  EXPECT_EQ(type(Kind::Isotropicity, 0.25), HyperbolicCylinder);
  for (std::size_t v = 0; v < 4; ++v) field.tensors[v][7] = field.mesh.points[v][2];
  EXPECT_EQ(type(Kind::Isotropicity, 0.25), TwoSheetHyperboloid);
  for (std::size_t v = 0; v < 4; ++v) field.tensors[v][1] = field.tensors[v][7] = 0;
  EXPECT_EQ(type(Kind::Magnitude, 1), ParallelPlanes);
  for (std::size_t v = 0; v < 4; ++v) field.tensors[v] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_EQ(type(Kind::Magnitude, 1), Empty);
  EXPECT_EQ(type(Kind::Traceless, 0), Empty);
}

TEST(QuadricOf, OnlyTheFeaturesThatAreOnOne) {
  FeatureTable table;
  table.add_magnitude(2);
  table.add_traceless();
  int quadrics = 0;
  for (const FeatureRow& row : table.rows()) quadrics += quadric_of(row).has_value();
  EXPECT_EQ(quadrics, 4);
  EXPECT_FALSE(quadric_of(table.row(Feature::NeutralReal)).has_value());
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Degenerate points and arcs of symmetric tensors: gaps, faces, tets.

#include <gtest/gtest.h>

#include "../oracle/random_tensors.hpp"
#include "../oracle/symmetric_oracle.hpp"
#include "triplex/certify/degenerate_arc.hpp"
#include "triplex/certify/eigenvalue_gap.hpp"

namespace triplex {
namespace {

constexpr FeatureSet kLinear = bit(Feature::DegenerateLinear),
                     kPlanar = bit(Feature::DegeneratePlanar);
constexpr std::array<VertexId, 4> kTet = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};

Tensor<double> symmetric(oracle::Random& random) {
  Tensor<double> t = oracle::double_tensor(random);
  t[3] = t[1];
  t[6] = t[2];
  t[7] = t[5];
  return t;
}
std::array<Tensor<double>, 4> random_tensors(oracle::Random& random, double variation = 1) {
  const Tensor<double> center = symmetric(random);
  std::array<Tensor<double>, 4> tensors;
  for (auto& t : tensors) {
    t = symmetric(random);
    for (std::size_t k = 0; k < 9; ++k) t[k] = center[k] + variation * t[k];
  }
  return tensors;
}

/// One tet, whose vertices are in the order of their coordinates.
struct OneTet {
  TensorField input;
  std::optional<RefinableField> field;
  oracle::LinearSymmetric<4> linear;

  explicit OneTet(const std::array<Tensor<double>, 4>& tensors) {
    input.mesh.points = {{0, 0, 0}, {1, 0, 1}, {2, 1, 0}, {3, 0, 0}};
    input.mesh.tets = {kTet};
    input.tensors.assign(tensors.begin(), tensors.end());
    field.emplace(input);
    for (std::size_t i = 0; i < 4; ++i) linear.a[i] = oracle::to_matrix(tensors[i]);
  }
  SymmetricField symmetric(Shift shift = Shift::None) const {
    return SymmetricField(*field, shift);
  }
  std::array<VertexId, 3> face(std::size_t opposite) const {
    std::array<VertexId, 3> f;
    for (std::size_t i = 0; i < 3; ++i) f[i] = kTet[i < opposite ? i : i + 1];
    return f;
  }
  oracle::LinearSymmetric<3> linear_on(std::size_t opposite) const {
    oracle::LinearSymmetric<3> f;
    for (std::size_t i = 0; i < 3; ++i) f.a[i] = linear.a[i < opposite ? i : i + 1];
    return f;
  }
  /// The points of all faces; nothing if there is an obstacle.
  std::optional<std::vector<CellPoint>> points(Shift shift = Shift::None) const {
    std::vector<CellPoint> all;
    for (std::size_t k = 0; k < 4; ++k) {
      const FacePoints f = isolate_degenerate_points(symmetric(shift), face(k));
      if (f.obstacle != CurveObstacle::None) return std::nullopt;
      for (const DegeneratePoint& p : f.points) {
        CellPoint point{p.feature, p.axis, {}};
        for (std::size_t i = 0; i < 3; ++i) point.place[i < k ? i : i + 1] = p.weights[i].middle();
        all.push_back(point);
      }
    }
    return all;
  }
};

Eigen::Vector3d place_of(const CellPoint& p) { return {p.place[1], p.place[2], p.place[3]}; }

TEST(EigenvalueGap, HoldsAtSamplesWhereItIsProven) {
  oracle::Random random(11);
  int proven = 0, open = 0;
  for (int n = 0; n < 400; ++n) {
    const OneTet tet(random_tensors(random, 0.05 + 0.4 * (n % 5)));
    const FeatureSet missed = degenerate_features_missed(tet.symmetric(), kTet);
    proven += missed != 0;
    open += missed != (kLinear | kPlanar);
    std::gamma_distribution<double> weight(1);
    for (int s = 0; s < 300 && missed != 0; ++s) {
      Eigen::Vector4d w(weight(random), weight(random), weight(random), weight(random));
      w /= w.sum();
      for (const bool planar : {false, true}) {
        if (!contains(missed, planar ? Feature::DegeneratePlanar : Feature::DegenerateLinear))
          continue;
        const auto x = tet.linear.newton(w.tail<3>(), planar);
        EXPECT_FALSE(x && tet.linear.least_coordinate(*x) > 0) << n;
      }
    }
  }
  EXPECT_GT(proven, 200);
  EXPECT_GT(open, 50);
}

TEST(EigenvalueGap, IsNotProvenOnADegenerateTensor) {
  oracle::Random random(12);
  for (int n = 0; n < 100; ++n) {
    auto tensors = random_tensors(random, 0.001);
    // Planar at the centroid: 1, 1, -2.
    for (std::size_t k = 0; k < 9; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i) sum += tensors[i][k];
      tensors[3][k] = 4 * (k == 0 || k == 4 ? 1.0 : k == 8 ? -2.0 : 0.0) - sum;
    }
    const OneTet tet(tensors);
    EXPECT_FALSE(
        contains(degenerate_features_missed(tet.symmetric(), kTet), Feature::DegeneratePlanar));
  }
}

TEST(EigenvalueGap, ZeroTensorsAreMissedOnlyByTheShiftedField) {
  const OneTet tet({});
  EXPECT_EQ(degenerate_features_missed(tet.symmetric(), kTet), 0u);
  EXPECT_EQ(degenerate_features_missed(tet.symmetric(Shift::General), kTet), kLinear | kPlanar);
  const auto points = tet.points(Shift::General);
  ASSERT_TRUE(points);
  EXPECT_TRUE(points->empty());
}

TEST(DegeneratePoints, AreThoseThatNewtonFindsFromManyStarts) {
  oracle::Random random(13);
  int found = 0;
  for (int n = 0; n < 400; ++n) {
    const OneTet tet(random_tensors(random, n % 2 == 0 ? 2 : 0.5));
    for (const Shift shift : {Shift::None, Shift::General}) {
      const FacePoints face = isolate_degenerate_points(tet.symmetric(shift), tet.face(n % 4));
      ASSERT_EQ(face.obstacle, CurveObstacle::None);
      const auto linear = tet.linear_on(n % 4);
      for (const bool planar : {false, true}) {
        const auto expected = oracle::face_points(linear, planar);
        const Feature feature = planar ? Feature::DegeneratePlanar : Feature::DegenerateLinear;
        ASSERT_EQ(std::ranges::count(face.points, feature, &DegeneratePoint::feature),
                  static_cast<std::ptrdiff_t>(expected.size()))
            << n;
        for (const DegeneratePoint& p : face.points) {
          if (p.feature != feature) continue;
          ++found;
          const Eigen::Vector2d x(p.weights[1].middle(), p.weights[2].middle());
          EXPECT_TRUE(
              std::ranges::any_of(expected, [&](const auto& y) { return (x - y).norm() < 1e-9; }));
          for (const Range& w : p.weights) EXPECT_LT(w.hi - w.lo, 1e-12);
        }
      }
    }
  }
  EXPECT_GT(found, 200);
}

TEST(DegeneratePoints, ScaleDoesNotMatter) {
  oracle::Random random(14);
  for (int n = 0; n < 20; ++n) {
    auto tensors = random_tensors(random);
    const OneTet tet(tensors);
    for (auto& t : tensors) t = oracle::scaled(t, n % 2 == 0 ? 900 : -900);
    const OneTet other(tensors);
    const auto a = tet.points(), b = other.points();
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->size(), b->size());
    for (std::size_t i = 0; i < a->size(); ++i) EXPECT_EQ((*a)[i].place, (*b)[i].place);
  }
}

/// diag(1 + x - 1/3, 1 - x + 1/3, -2) with y - 1/3 beside: degenerate exactly at x = y = 1/3.
TEST(DegeneratePoints, ClosedForm) {
  std::array<Tensor<double>, 4> tensors;
  const std::array<std::array<double, 2>, 3> xy = {{{0, 0}, {3, 0}, {0, 3}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = xy[i][0] - 1, b = xy[i][1] - 1;
    tensors[i] = {3 + a, b, 0, b, 3 - a, 0, 0, 0, -6};
  }
  tensors[3] = {1, 2, 3, 2, 4, 5, 3, 5, 6};
  // All tensors of the face have the axis z: they span three dimensions, and the pencil is
  // singular.
  const OneTet tet(tensors);
  EXPECT_EQ(isolate_degenerate_points(tet.symmetric(), tet.face(3)).obstacle,
            CurveObstacle::Pencil);
  const FacePoints face = isolate_degenerate_points(tet.symmetric(Shift::General), tet.face(3));
  ASSERT_EQ(face.obstacle, CurveObstacle::None);
  ASSERT_EQ(face.points.size(), 1u);
  EXPECT_EQ(face.points[0].feature, Feature::DegeneratePlanar);
  for (const Range& w : face.points[0].weights) EXPECT_NEAR(w.middle(), 1.0 / 3, 1e-13);
}

TEST(DegeneratePoints, OnAnEdgeAreAnObstacleUntilShifted) {
  oracle::Random random(15);
  int crossed = 0;
  for (int n = 0; n < 40; ++n) {
    auto tensors = random_tensors(random);
    for (auto& t : tensors)
      for (double& x : t) x = std::round(16 * x);
    // The middle of the edge from 0 to 1 is diag(1, 1, -2).
    for (std::size_t k = 0; k < 9; ++k)
      tensors[1][k] = (k == 0 || k == 4 ? 32.0 : k == 8 ? -64.0 : 0.0) - tensors[0][k];
    const OneTet tet(tensors);
    for (const std::size_t k : {2u, 3u})
      EXPECT_EQ(isolate_degenerate_points(tet.symmetric(), tet.face(k)).obstacle,
                CurveObstacle::Boundary);
    const auto points = tet.points(Shift::General);
    ASSERT_TRUE(points);
    EXPECT_EQ(points->size() % 2, 0u);
    const CellArcs arcs = link_degenerate_points(tet.symmetric(Shift::General), kTet, *points);
    EXPECT_TRUE(arcs.obstacle == CurveObstacle::None || points->size() >= 4);
    crossed += !points->empty();
  }
  EXPECT_GT(crossed, 10);
}

TEST(DegenerateArcs, JoinThePointsThatStepsAlongTheCurveJoin) {
  oracle::Random random(16);
  int followed = 0, several = 0;
  for (int n = 0; n < 300; ++n) {
    const OneTet tet(random_tensors(random));
    const auto points = tet.points();
    ASSERT_TRUE(points);
    const CellArcs cell = link_degenerate_points(tet.symmetric(), kTet, *points);
    ASSERT_EQ(cell.obstacle, CurveObstacle::None);
    ASSERT_EQ(2 * cell.arcs.size(), points->size());
    std::vector<int> used(points->size());
    for (const DegenerateArc& arc : cell.arcs) {
      ++used[static_cast<std::size_t>(arc.from)];
      ++used[static_cast<std::size_t>(arc.to)];
      const bool planar = arc.feature == Feature::DegeneratePlanar;
      for (const auto& x : arc.inside) {  // on the curve
        const Eigen::Vector3d place(x[1], x[2], x[3]);
        const auto nearest = tet.linear.newton(place, planar);
        ASSERT_TRUE(nearest);
        EXPECT_LT((*nearest - place).norm(), 1e-8);
      }
      const CellPoint &a = (*points)[static_cast<std::size_t>(arc.from)],
                      &b = (*points)[static_cast<std::size_t>(arc.to)];
      const auto end = oracle::follow(tet.linear, place_of(a), planar);
      if (!end) continue;
      ++followed;
      EXPECT_LT((*end - place_of(b)).norm(), 2e-3) << n;
    }
    EXPECT_TRUE(std::ranges::all_of(used, [](int times) { return times == 1; }));
    several += cell.arcs.size() > 1;

    const auto shifted = tet.points(Shift::General);
    ASSERT_TRUE(shifted);
    const CellArcs same = link_degenerate_points(tet.symmetric(Shift::General), kTet, *shifted);
    ASSERT_EQ(same.arcs.size(), cell.arcs.size());
    for (std::size_t i = 0; i < cell.arcs.size(); ++i) {
      EXPECT_EQ(same.arcs[i].from, cell.arcs[i].from);
      EXPECT_EQ(same.arcs[i].to, cell.arcs[i].to);
    }
  }
  EXPECT_GT(followed, 100);
  EXPECT_GT(several, 15);
}

TEST(DegenerateArcs, BothPrecisionsAgree) {
  oracle::Random random(17);
  int several = 0;
  for (int n = 0; n < 300; ++n) {
    const OneTet tet(random_tensors(random));
    const auto points = tet.points();
    ASSERT_TRUE(points);
    if (points->size() < 4) continue;
    ++several;
    const CellArcs fast = link_degenerate_points(tet.symmetric(), kTet, *points);
    const CellArcs exact =
        link_degenerate_points(tet.symmetric(), kTet, *points, AxisPrecision::High);
    ASSERT_EQ(exact.obstacle, CurveObstacle::None);
    ASSERT_EQ(fast.arcs.size(), exact.arcs.size());
    for (std::size_t i = 0; i < fast.arcs.size(); ++i) {
      EXPECT_EQ(fast.arcs[i].from, exact.arcs[i].from);
      EXPECT_EQ(fast.arcs[i].to, exact.arcs[i].to);
    }
  }
  EXPECT_GT(several, 5);
}

/// Where xx = yy in all tensors, the conic of the axes is a pair of lines.
TEST(DegenerateArcs, CrossingCurvesAreAnObstacleUntilShifted) {
  oracle::Random random(19);
  int crossing = 0, empty = 0;
  for (int n = 0; n < 60; ++n) {
    auto tensors = random_tensors(random);
    for (auto& t : tensors) t[4] = t[0];
    const OneTet tet(tensors);
    const auto points = tet.points();
    if (!points) continue;
    const CellArcs cell = link_degenerate_points(tet.symmetric(), kTet, *points);
    EXPECT_EQ(cell.obstacle, points->empty() ? CurveObstacle::None : CurveObstacle::Crossing);
    (points->empty() ? empty : crossing) += 1;
    const auto shifted = tet.points(Shift::General);
    ASSERT_TRUE(shifted);
    ASSERT_EQ(shifted->size(), points->size());
    const CellArcs arcs = link_degenerate_points(tet.symmetric(Shift::General), kTet, *shifted);
    EXPECT_EQ(2 * arcs.arcs.size(), points->size());
  }
  EXPECT_GT(crossing, 10);
  EXPECT_GT(empty, 10);
}

/// What the code concludes from "no points on the faces".
TEST(DegenerateArcs, NoCurveClosesInsideATet) {
  oracle::Random random(18);
  int empty = 0;
  for (int n = 0; n < 200; ++n) {
    const OneTet tet(random_tensors(random, 0.6));
    const auto points = tet.points();
    ASSERT_TRUE(points);
    if (!points->empty()) continue;
    ++empty;
    for (int i = 0; i <= 6; ++i)
      for (int j = 0; i + j <= 6; ++j)
        for (int k = 0; i + j + k <= 6; ++k)
          for (const bool planar : {false, true}) {
            const auto x = tet.linear.newton(Eigen::Vector3d(i, j, k) / 6, planar);
            EXPECT_FALSE(x && tet.linear.least_coordinate(*x) > 1e-9) << n;
          }
  }
  EXPECT_GT(empty, 40);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact crossings of segments: against closed forms, dense sampling, and the certified meshes.
#include "triplex/verify/tet_segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "../oracle/one_tet.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

constexpr double kWhole = 0x1p40;

TetWeights random_point(std::mt19937& random) {
  std::exponential_distribution<double> d;
  return weights_near({d(random), d(random), d(random), d(random)});
}
TetWeights corner(int i) {
  TetWeights w{};
  w[static_cast<std::size_t>(i)] = std::int64_t{1} << kWeightBits;
  return w;
}
Tensor<double> tensor_on(const TensorField& field, const TetSegment& s, double t) {
  Tensor<double> sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double w =
        ((1 - t) * static_cast<double>(s.ends[0][i]) + t * static_cast<double>(s.ends[1][i])) /
        kWhole;
    for (std::size_t k = 0; k < 9; ++k)
      sum[k] += w * field.tensors[index(field.mesh.tets[index(s.tet)][i])][k];
  }
  return sum;
}

TEST(TetWeights, AddUpAndStayInside) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    std::normal_distribution<double> d;
    std::array<double, 4> b = {d(random), d(random), d(random), 0};
    b[3] = 1 - b[0] - b[1] - b[2];
    const TetWeights w = weights_near(b);
    EXPECT_EQ(std::accumulate(w.begin(), w.end(), std::int64_t{0}), std::int64_t{1} << 40);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_GE(w[k], 0);
      if (*std::ranges::min_element(b) >= 0) {
        EXPECT_NEAR(static_cast<double>(w[k]), b[k] * kWhole, 4);
      }
    }
  }
}

struct Values {
  double f, side;
};
/// The function of a surface and what chooses the page, in doubles.
Values values_of(const FeatureTable& table, const FeatureRow& row, const Tensor<double>& t) {
  const Tensor<double> a = triple_deviator(t);
  const double p = -double_dot(a, {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]}) / 18;
  const double q = (a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
                    a[2] * (a[3] * a[7] - a[4] * a[6])) /
                   27;
  if (row.kind == FeatureKind::LevelSet) {
    const double trace = t[0] + t[4] + t[8];
    switch (row.level.kind) {
      case LevelSet::Kind::Magnitude:
        return {std::sqrt(double_dot(t, t)) - row.level.value, 1};
      case LevelSet::Kind::Traceless:
        return {trace, 1};
      default:
        return {trace - std::sqrt(3) * row.level.value * std::sqrt(double_dot(t, t)), 1};
    }
  }
  (void)table;
  const auto s = [](Sign x) { return static_cast<double>(static_cast<int>(x)); };
  if (row.mode.is_infinite()) return {p, s(row.sign_q) * q};
  if (row.mode.is_zero()) return {q, s(row.sign_p) * p};
  // 27 q^2 = 4 mu^2 |p|^3 on that side of p.
  const double mu = row.mode.value(), size = s(row.sign_p) * p;
  return {27 * q * q - 4 * mu * mu * size * size * size, s(row.sign_q) * q};
}

/// Random tets: as many crossings as changes of sign on a dense sample, wherever the sample is
/// trustworthy (every value clear of rounding, every crossing apart from the next).
TEST(CrossingsOn, AreTheChangesOfSignOfADenseSample) {
  FeatureTable table;
  table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  table.add_mode({3, 1}, Sign::Positive, Sign::Negative);
  table.add_magnitude(1.25);
  table.add_isotropicity(0.25);
  table.add_isotropicity(-0.25);
  table.add_traceless();
  std::mt19937 random(2);
  constexpr int kSteps = 4000;
  std::vector<int> found(table.rows().size(), 0), several(table.rows().size(), 0);
  for (int n = 0; n < 200; ++n) {
    const TensorField field = generate_noise_on_tet(static_cast<std::uint64_t>(n));
    const TetSegment s{TetId(0), {random_point(random), random_point(random)}};
    for (const FeatureRow& row : table.rows()) {
      if (row.kind == FeatureKind::Curve) continue;
      const auto exact = crossings_on(field, table, row.feature, s);
      ASSERT_TRUE(exact) << row.name;
      std::vector<SegmentCrossing> sampled;
      bool clear = true;
      std::vector<double> turns;  // where the page changes
      Values last = values_of(table, row, tensor_on(field, s, 0));
      for (int i = 1; i <= kSteps; ++i) {
        const Values now = values_of(table, row, tensor_on(field, s, 1.0 * i / kSteps));
        if ((now.side > 0) != (last.side > 0)) turns.push_back((i - 0.5) / kSteps);
        if ((now.f > 0) != (last.f > 0)) {
          if (now.side > 0) sampled.push_back({(i - 0.5) / kSteps, now.f > 0});
        }
        last = now;
      }
      for (std::size_t i = 0; i + 1 < exact->size(); ++i)
        if ((*exact)[i + 1].t - (*exact)[i].t < 2.0 / kSteps) clear = false;
      for (const SegmentCrossing& c : *exact)
        for (const double t : turns) clear = clear && std::fabs(c.t - t) > 2.0 / kSteps;
      for (const SegmentCrossing& c : sampled)
        for (const double t : turns) clear = clear && std::fabs(c.t - t) > 2.0 / kSteps;
      if (!clear) continue;
      ASSERT_EQ(exact->size(), sampled.size()) << row.name << ", field " << n;
      const double factor = row.kind == FeatureKind::LevelSet &&
                                    row.level.kind == LevelSet::Kind::Isotropicity &&
                                    row.level.value < 0
                                ? -1
                                : 1;
      for (std::size_t i = 0; i < sampled.size(); ++i) {
        EXPECT_NEAR((*exact)[i].t, sampled[i].t, 1.0 / kSteps) << row.name;
        EXPECT_EQ((*exact)[i].rises, factor > 0 ? sampled[i].rises : !sampled[i].rises) << row.name;
      }
      found[index(row.feature)] += static_cast<int>(sampled.size());
      several[index(row.feature)] += sampled.size() > 1;
    }
  }
  for (const FeatureRow& row : table.rows()) {
    if (row.kind == FeatureKind::Curve) continue;
    EXPECT_GT(found[index(row.feature)], 5) << row.name;
  }
  EXPECT_GT(std::accumulate(several.begin(), several.end(), 0), 20);
}

/// Two sheets of q = 0 at a distance that no sample sees: q = -(x - 1/2)^2 + 2^-60 times a
/// constant, on a block triangular field.
TEST(CrossingsOn, TellSheetsApartThatAreAsNearAsDoublesAllow) {
  // Block [[u, c], [1, u]] next to -2u, u = 1: q = -2 (1 - c) with c = x: zero at x = 1 only.
  const double delta = 0x1p-30;
  const auto at = [&](double x) -> Tensor<double> {
    // q = -(block determinant) * 2u, block determinant (x - 1/2 - delta)(x - 1/2 + delta).
    return {x - 0.5 - delta, 0, 0, 0, x - 0.5 + delta, 0, 0, 0, -2 * (x - 0.5)};
  };
  const TensorField field = oracle::on_one_tet({at(0), at(0), at(0), at(1)});
  const TetSegment s{TetId(0), {corner(0), corner(1)}};  // vertex 1 of the tet is (1, 0, 0)
  const auto roots = crossings_on(field, standard_features(), Feature::NeutralReal, s);
  ASSERT_TRUE(roots);
  ASSERT_EQ(roots->size(), 3u);
  EXPECT_NEAR((*roots)[1].t - (*roots)[0].t, delta, 1e-15);
  EXPECT_NEAR((*roots)[2].t - (*roots)[1].t, delta, 1e-15);
}

TEST(CrossingsOn, TiesAreNotAnswered) {
  const Tensor<double> neutral{1, 0, 0, 0, -1, 0, 0, 0, 0}, one{1, 0, 0, 0, 2, 0, 0, 0, -3},
      minus{-1, 0, 0, 0, -2, 0, 0, 0, 3};
  const TetSegment s{TetId(0), {corner(0), corner(1)}};
  const auto ask = [&](const Tensor<double>& a, const Tensor<double>& b) {
    return crossings_on(oracle::on_one_tet({a, a, a, b}), standard_features(), Feature::NeutralReal,
                        s);
  };
  EXPECT_FALSE(ask(neutral, one)) << "a root at an end";
  EXPECT_FALSE(ask(neutral, neutral)) << "zero throughout";
  EXPECT_FALSE(ask(one, minus)) << "a triple root at zero tensors, on the triple curve";
  EXPECT_TRUE(ask(one, one));
}

constexpr std::array<std::array<int, 3>, 4> kFaces = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// On the plane of the face opposite to vertex i, relative to the height of the tet over it.
bool lies_on_face(const TensorField& field, std::size_t tet, int i, const Point& x) {
  const auto vertex = [&](int k) -> const Point& {
    return field.mesh.points[index(field.mesh.tets[tet][static_cast<std::size_t>(k)])];
  };
  const auto& [a, b, c] = kFaces[static_cast<std::size_t>(i)];
  const auto height = [&](const Point& y) {
    const auto d = [&](int v, int k) { return vertex(v)[k] - vertex(a)[k]; };
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      sum += (y[k] - vertex(a)[k]) * (d(b, l) * d(c, m) - d(b, m) * d(c, l));
    }
    return sum;
  };
  return std::fabs(height(x)) < 1e-9 * std::fabs(height(vertex(i)));
}

/// Faces: the points of the certified triple curve on the faces of the input are those that the
/// winding number tells.
TEST(WindingOn, TellsWhichFacesTheCurveMeets) {
  GridOptions grid;
  grid.n = 6;
  grid.jitter = 0.2;
  grid.seed = 5;
  const TensorField field = generate_lorenz(grid);
  const Extraction result = extract(field);
  ASSERT_TRUE(result.certified());
  const FeatureMesh& curve = result.mesh(Feature::TripleCurve);
  std::vector<std::set<std::uint32_t>> points(field.mesh.tets.size());
  for (std::size_t n = 0; n < curve.segments.size(); ++n)
    points[static_cast<std::size_t>(curve.source_cell[n])].insert(curve.segments[n].begin(),
                                                                  curve.segments[n].end());
  int met = 0;
  for (std::size_t t = 0; t < field.mesh.tets.size(); ++t) {
    int sum = 0;
    for (int i = 0; i < 4; ++i) {
      const auto& [a, b, c] = kFaces[static_cast<std::size_t>(i)];
      const auto winding = winding_on(field, TetId(static_cast<std::uint32_t>(t)),
                                      {corner(a), corner(b), corner(c)});
      ASSERT_TRUE(winding);
      const auto on_face = std::ranges::count_if(
          points[t], [&](std::uint32_t v) { return lies_on_face(field, t, i, curve.points[v]); });
      EXPECT_EQ(on_face % 2, std::abs(*winding) % 2) << t;
      EXPECT_LE(std::abs(*winding), on_face);
      sum += *winding;
      met += *winding != 0;
    }
    EXPECT_EQ(sum, 0) << "what goes in comes out";
  }
  EXPECT_GT(met, 40);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/meshing/surface_function.hpp"

#include <gtest/gtest.h>

#include <random>

namespace triplex {
namespace {

using Random = std::mt19937_64;

/// f in long doubles, from its definition.
struct Oracle {
  const FeatureTable& table;
  Feature feature;

  static std::array<long double, 9> deviator(const std::array<long double, 9>& a) {
    const long double third = (a[0] + a[4] + a[8]) / 3;
    auto d = a;
    for (int k : {0, 4, 8}) d[static_cast<std::size_t>(k)] -= third;
    return d;
  }
  /// Of T for level sets; of a traceless tensor for pages.
  long double value(const std::array<long double, 9>& a) const {
    const FeatureRow& row = table.row(feature);
    long double square = 0, trace = a[0] + a[4] + a[8];
    for (const long double x : a) square += x * x;
    if (row.kind == FeatureKind::LevelSet) {
      const long double s = row.level.value;
      switch (row.level.kind) {
        case LevelSet::Kind::Magnitude:
          return square - s * s;
        case LevelSet::Kind::Isotropicity:
          return 3 * s * s * square - trace * trace;
        case LevelSet::Kind::Traceless:
          return -trace;
      }
    }
    long double trace_of_square = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) trace_of_square += a[3 * i + j] * a[3 * j + i];
    const long double P = -trace_of_square;
    const long double Q =
        6 * (a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
             a[2] * (a[3] * a[7] - a[4] * a[6]));
    const Sheet& sheet = table.sheet(feature);
    if (sheet.kind == Sheet::Kind::Balanced) return P;
    if (sheet.kind == Sheet::Kind::Neutral) return Q;
    const long double mapped = sheet.map.p_factor * P;
    const long double v = std::sqrt(std::max(0.0L, -mapped) / 6);
    return sheet.map.q_factor * Q - static_cast<int>(sheet.sign_q) * 12 * v * v * v;
  }
};

FeatureTable table_of_all() {
  FeatureTable table;
  table.add_mode({1, 2}, Sign::Negative, Sign::Positive);
  table.add_mode({3, 2}, Sign::Positive, Sign::Negative);
  table.add_magnitude(1.25);
  table.add_isotropicity(0.4);
  table.add_isotropicity(-0.7);
  table.add_traceless();
  return table;
}

std::vector<Feature> surfaces(const FeatureTable& table) {
  std::vector<Feature> result;
  for (const FeatureRow& row : table.rows())
    if (row.kind != FeatureKind::Curve) result.push_back(row.feature);
  return result;
}

/// Traceless if asked for, so that tripled deviators and deviators are of one kind.
Tensor<double> random_tensor(Random& random, bool with_trace) {
  Tensor<double> t;
  for (double& x : t) x = std::uniform_real_distribution<double>(-1, 1)(random);
  if (!with_trace) t[8] = -(t[0] + t[4]);
  return t;
}

std::array<long double, 9> mix(std::span<const Tensor<double>> hull, Random& random) {
  std::vector<long double> w;
  long double sum = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    w.push_back(-std::log(std::uniform_real_distribution<double>(1e-6, 1)(random)));
    sum += w.back();
  }
  std::array<long double, 9> a{};
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t k = 0; k < 9; ++k) a[k] += w[i] / sum * hull[i][k];
  return a;
}

EntryBounds bounds_of(std::span<const Tensor<double>> hull) {
  EntryBounds bounds;
  for (const Tensor<double>& t : hull)
    for (const double x : t) bounds.magnitude = std::max(bounds.magnitude, std::fabs(x));
  return bounds;
}

TEST(SurfaceFunction, TheLargestValueBoundsAllOnTheHull) {
  const FeatureTable table = table_of_all();
  Random random(1);
  for (const Feature feature : surfaces(table)) {
    const SurfaceFunction f(table, feature, 0);
    const Oracle oracle{table, feature};
    for (int n = 0; n < 200; ++n) {
      // Narrow and wide triangles.
      const double width = std::ldexp(1.0, -(n % 12));
      std::array<Tensor<double>, 3> hull;
      hull[0] = random_tensor(random, f.takes_trace());
      for (std::size_t i = 1; i < 3; ++i) {
        hull[i] = hull[0];
        const Tensor<double> step = random_tensor(random, f.takes_trace());
        for (std::size_t k = 0; k < 9; ++k) hull[i][k] += width * step[k];
      }
      const double bound = f.largest_value<3>(hull, bounds_of(hull));
      long double largest = 0;
      for (int s = 0; s < 40; ++s)
        largest = std::max(largest, std::fabs(oracle.value(mix(hull, random))));
      EXPECT_LE(largest, bound) << table.row(feature).name << ' ' << n;
      // Not idly: where the triangle is small, by what f changes on it.
      if (width < 0.01) {
        EXPECT_LE(bound, static_cast<double>(largest) * 2 + 100 * width);
      }
    }
  }
}

TEST(SurfaceFunction, DerivativesBoundAllOnTheHull) {
  const FeatureTable table = table_of_all();
  Random random(2);
  for (const Feature feature : surfaces(table)) {
    const SurfaceFunction f(table, feature, 0);
    const Oracle oracle{table, feature};
    for (int n = 0; n < 100; ++n) {
      std::array<Tensor<double>, 4> hull;
      for (Tensor<double>& t : hull) t = random_tensor(random, f.takes_trace());
      const Tensor<double> along = random_tensor(random, f.takes_trace());
      std::array<Tensor<double>, 5> all{hull[0], hull[1], hull[2], hull[3], along};
      const Bounds bounds = f.derivative_on(hull, along, bounds_of(all));
      for (int s = 0; s < 20; ++s) {
        const auto a = mix(hull, random);
        constexpr long double h = 1e-6L;
        auto forward = a, backward = a;
        for (std::size_t k = 0; k < 9; ++k) forward[k] += h * along[k], backward[k] -= h * along[k];
        const long double slope = (oracle.value(forward) - oracle.value(backward)) / (2 * h);
        EXPECT_LE(bounds.low, slope + 1e-5L) << table.row(feature).name;
        EXPECT_GE(bounds.high, slope - 1e-5L) << table.row(feature).name;
        Tensor<double> rounded;
        for (std::size_t k = 0; k < 9; ++k) rounded[k] = static_cast<double>(a[k]);
        EXPECT_NEAR(f.derivative(rounded, along), static_cast<double>(slope), 1e-4);
        EXPECT_NEAR(f.value(rounded), static_cast<double>(oracle.value(a)), 1e-12);
      }
    }
  }
}

// Where f vanishes at the corners, what is left is of second order: also on a sheet through the
// triple degenerate curve, of order 3/2 there.
TEST(SurfaceFunction, IsSmallOnSmallTrianglesWithCornersOnTheSurface) {
  const FeatureTable& table = standard_features();
  const SurfaceFunction f(table, Feature::DegenerateLinear, 0);
  // diag(2,-1,-1) + h B: D = 0 where the 2x2 block is degenerate.
  const auto triangle = [](double h) {
    const auto corner = [](double a,
                           double b) {  // block [[-1+a, b], [0, -1+a]]: a double eigenvalue
      return Tensor<double>{2 - 2 * a, 0, 0, 0, -1 + a, b, 0, 0, -1 + a};
    };
    return std::array<Tensor<double>, 3>{corner(0, 0.1), corner(h, 0.1), corner(0, 0.1 + h)};
  };
  for (const double h : {1e-2, 1e-3, 1e-4}) {
    const auto hull = triangle(h);
    EXPECT_LT(f.largest_value<3>(hull, bounds_of(hull)), 100 * h * h);
  }
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenvalue_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "../oracle/eigenvector_oracle.hpp"

namespace triplex {
namespace {

using oracle::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// 1 on the border of the hexagon: half its width between opposite sides is sqrt(3)/2.
double gauge(double x, double y) {
  double largest = 0;
  for (int k = 0; k < 6; ++k) {
    const double angle = (2 * k) * std::numbers::pi / 6;
    largest = std::fmax(largest, x * std::cos(angle) + y * std::sin(angle));
  }
  return largest / (std::numbers::sqrt3 / 2);
}

// Degrees counter-clockwise from the top.
double degrees(const std::array<double, 2>& h) {
  const double angle = std::atan2(-h[0], h[1]) * 180 / std::numbers::pi;
  return angle < 0 ? angle + 360 : angle;
}

TEST(EigenvalueSpace, SpecialModesInThePapersOrder) {
  const std::array<Tensor<double>, 7> examples = {{{1, 0, 0, 0, 0, 0, 0, 0, -1},
                                                   {2, 0, 0, 0, -1, 1, 0, 0, -1},
                                                   {0, 1, 0, 0, 0, 1, 1, 0, 0},
                                                   {0, 1, 0, -1, 0, 0, 0, 0, 0},
                                                   {0, -1, 0, 0, 0, -1, -1, 0, 0},
                                                   {1, 1, 0, 0, 1, 0, 0, 0, -2},
                                                   {0, 1, 0, 0, 0, 1, 0, 0, 0}}};
  const std::array<const char*, 7> names = {
      "real neutral",    "linear degenerate", "linear balanced",  "complex neutral",
      "planar balanced", "planar degenerate", "triple degenerate"};
  for (int k = 0; k < 7; ++k) {
    const SpecialMode& special = special_modes()[k];
    EXPECT_EQ(special.name, names[k]);
    EXPECT_EQ(special.place, classify(examples[k]));
    const Mode m = mode(examples[k]);
    EXPECT_EQ(special.mode.sign_p, m.sign_p);
    EXPECT_EQ(special.mode.sign_q, m.sign_q);
    EXPECT_EQ(std::isnan(m.mu), k == 6);
    if (k < 6) {
      EXPECT_EQ(special.mode.mu, m.mu);
      EXPECT_NEAR(degrees(special.hexagon), 60 * k, 1e-12);
      EXPECT_NEAR(std::hypot(special.hexagon[0], special.hexagon[1]), 1, 1e-15);
    }
    EXPECT_EQ(hexagon_approx(m), special.hexagon);
    const std::optional<Mode> back = mode_on_hexagon(special.hexagon);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->sign_p, m.sign_p);
    EXPECT_EQ(back->sign_q, m.sign_q);
    if (k < 6) {
      EXPECT_EQ(back->mu, m.mu);
    } else {
      EXPECT_TRUE(std::isnan(back->mu));
    }
  }
}

// Every mode lies on the border, on the edge of its domain, and comes back; along the border the
// place moves on monotonously.
TEST(EigenvalueSpace, HexagonThereAndBack) {
  struct Edge {
    Sign p, q;
    bool above_one;
    int first_corner;
  };
  const std::array<Edge, 6> edges = {{{Sign::Negative, Sign::Positive, false, 0},
                                      {Sign::Negative, Sign::Positive, true, 1},
                                      {Sign::Positive, Sign::Positive, false, 2},
                                      {Sign::Positive, Sign::Negative, false, 3},
                                      {Sign::Negative, Sign::Negative, true, 4},
                                      {Sign::Negative, Sign::Negative, false, 5}}};
  for (const Edge& edge : edges) {
    double previous = edge.first_corner * 60;
    const bool falling = edge.first_corner == 2 || edge.first_corner == 4 || edge.first_corner == 5;
    for (int n = 1; n < 200; ++n) {
      const int k = falling ? 200 - n : n;
      const double mu = edge.above_one             ? 200.0 / (200 - k)
                        : edge.p == Sign::Negative ? k / 200.0
                                                   : k / (200.0 - k);
      const std::array<double, 2> h = hexagon_approx({mu, edge.p, edge.q});
      EXPECT_NEAR(gauge(h[0], h[1]), 1, 1e-14);
      EXPECT_GT(degrees(h), previous);
      EXPECT_LT(degrees(h), edge.first_corner * 60 + 60);
      previous = degrees(h);
      for (const double factor : {1.0, 1e-300, 1e300}) {
        const std::optional<Mode> back = mode_on_hexagon({h[0] * factor, h[1] * factor});
        ASSERT_TRUE(back.has_value());
        EXPECT_EQ(back->sign_p, edge.p);
        EXPECT_EQ(back->sign_q, edge.q);
        EXPECT_NEAR(back->mu / mu, 1, 1e-12);
      }
    }
  }
  EXPECT_FALSE(mode_on_hexagon({kInfinity, 0}).has_value());
  EXPECT_FALSE(mode_on_hexagon({0, std::nan("")}).has_value());
}

TEST(EigenvalueSpace, ConeThereAndBack) {
  Random random(1);
  for (int n = 0; n < 5000; ++n) {
    const Tensor<double> t = oracle::tensor_of_any_kind(random, n);
    const Point x = eigenvalue_space_approx(t);
    const oracle::RationalInvariants i = oracle::rational_invariants(t);
    const mpq_class magnitude = oracle::sum_of_squares(t);
    const mpq_class deviator = oracle::sum_of_squares(oracle::rational_deviator(t));
    if (magnitude == 0) {
      for (const double c : x) ASSERT_TRUE(std::isnan(c));
      continue;
    }
    const double trace = mpq_class(mpq_class(t[0]) + mpq_class(t[4]) + mpq_class(t[8])).get_d();
    ASSERT_NEAR(x[2], trace / std::sqrt(3 * magnitude.get_d()), 1e-15);
    ASSERT_EQ(x[0] == 0 && x[1] == 0, i.p == 0 && i.q == 0);
    if (deviator == 0) {
      ASSERT_EQ(std::fabs(x[2]), 1);
    }
    const std::optional<ModeAndIsotropicity> back = from_eigenvalue_space(x);
    ASSERT_TRUE(back.has_value());
    ASSERT_EQ(back->isotropicity, x[2]);
    if (i.p == 0 && i.q == 0) {
      ASSERT_TRUE(std::isnan(back->mode.mu));
      continue;
    }
    // 1 - |eta| relatively, from 1 - eta^2 = |A|^2 / |T|^2.
    const mpq_class ratio = deviator / magnitude;
    ASSERT_NEAR(gauge(x[0], x[1]) / (ratio.get_d() / (1 + std::fabs(x[2]))), 1, 1e-13);
    const Mode m = mode(t);
    if (m.mu == 0 || std::isinf(m.mu) || (m.mu > 1e-3 && m.mu < 1e3)) {
      ASSERT_EQ(back->mode.sign_p, m.sign_p);
      ASSERT_EQ(back->mode.sign_q, m.sign_q);
      if (std::isinf(m.mu)) {
        ASSERT_EQ(back->mode.mu, m.mu);
      } else {
        ASSERT_NEAR(back->mode.mu, m.mu, 1e-9 * m.mu);
      }
    }
  }
  EXPECT_FALSE(from_eigenvalue_space({0, 0, 1.5}).has_value());
  EXPECT_FALSE(from_eigenvalue_space({0, 0, std::nan("")}).has_value());
  EXPECT_FALSE(from_eigenvalue_space({0, kInfinity, 0}).has_value());
}

TEST(EigenvalueSpace, Laws) {
  Random random(2);
  for (int n = 0; n < 2000; ++n) {
    const Tensor<double> t =
        n % 2 == 0 ? oracle::double_tensor(random) : oracle::degenerate_tensor(random);
    const Point x = eigenvalue_space_approx(t);
    if (std::isnan(x[2])) continue;
    const Point transposed = eigenvalue_space_approx(oracle::transposed(t));
    const Point negated = eigenvalue_space_approx(oracle::negated(t));
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(transposed[k], x[k], 1e-8);
      ASSERT_NEAR(negated[k], k == 1 ? x[k] : -x[k], 1e-8);
    }
    for (const int k : {-900, 900}) ASSERT_EQ(eigenvalue_space_approx(oracle::scaled(t, k)), x);
  }
}

TEST(EigenvalueSpace, ExtremeTensors) {
  for (const double a : {1e-320, 3.0, 1e307}) {
    EXPECT_EQ(eigenvalue_space_approx({a, 0, 0, 0, a, 0, 0, 0, a}), (Point{0, 0, 1}));
    EXPECT_EQ(eigenvalue_space_approx({-a, 0, 0, 0, -a, 0, 0, 0, -a}), (Point{0, 0, -1}));
  }
  // Nearly a multiple of the identity: not on the axis.
  const Point near_tip = eigenvalue_space_approx({1, 1e-100, 0, 1e-100, 1, 0, 0, 0, 1});
  EXPECT_EQ(near_tip[2], 1);
  EXPECT_EQ(near_tip[0], 0);
  EXPECT_NEAR(near_tip[1] / 1e-200, 1.0 / 3, 1e-12);  // |A|^2 / |T|^2 / 2 = 2e-200 / 3 / 2
  // On the axis between the tips.
  const Point on_axis = eigenvalue_space_approx({1, 3, 0, 0, 1, 0, 0, 0, 1});
  EXPECT_EQ(on_axis[0], 0);
  EXPECT_EQ(on_axis[1], 0);
  EXPECT_NEAR(on_axis[2], 0.5, 1e-15);
}

// The paper says that mode and isotropicity of a unit tensor determine its eigenvalues: not so.
TEST(EigenvalueSpace, DoesNotDetermineEigenvalues) {
  for (const double a : {0.1, 0.3, 0.7}) {
    const Tensor<double> t = {a, std::sqrt(1 - 2 * a * a), 0, 0, 0, 0, 0, 0, -a};
    EXPECT_EQ(eigenvalue_space_approx(t)[2], 0);
    EXPECT_NEAR(eigenvalue_space_approx(t)[1], 1, 1e-15);
    EXPECT_NEAR(eigenvalues(t).real[0], a, 1e-15);
  }
}

TEST(EigenvalueSpace, ModeDeterminesEigenvaluesUpToAFactor) {
  Random random(3);
  for (int n = 0; n < 5000; ++n) {
    const Tensor<double> t = oracle::tensor_of_any_kind(random, n);
    const Eigenvalues l = deviator_eigenvalues(t);
    const Eigenvalues m = deviator_eigenvalues_of_mode(mode(t));
    ASSERT_EQ(m.all_real, l.all_real);
    const auto largest = [](const Eigenvalues& e) {
      const double real = std::fmax(std::fabs(e.real[0]), std::fabs(e.real[2]));
      return std::fmax(real, std::hypot(e.re, e.im));
    };
    const double size = largest(l);
    if (size == 0) {
      ASSERT_EQ(largest(m), 0);
      continue;
    }
    // mode(t) has 2^-29, and square roots near its corner mu = 1 keep half of the digits
    const double unit = largest(m);
    for (int k = 0; k < (l.all_real ? 3 : 1); ++k) {
      ASSERT_NEAR(m.real[k] / unit, l.real[k] / size, 1e-4);
      if (std::fabs(mode(t).mu - 1) > 1e-3) {
        ASSERT_NEAR(m.real[k] / unit, l.real[k] / size, 1e-6);
      }
    }
    if (l.all_real) {
      for (int k = 0; k < 2; ++k) ASSERT_EQ(m.real[k] == m.real[k + 1], l.real[k] == l.real[k + 1]);
    }
    ASSERT_NEAR(m.im / unit, l.im / size, 1e-4);
  }
}

}  // namespace
}  // namespace triplex

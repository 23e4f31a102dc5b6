// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../oracle/random_tensors.hpp"
#include "form_fields.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/quadric/adjugate.hpp"

namespace triplex {
namespace {

using Kind = QuadricSurface::Kind;
constexpr QuadricSurface kSurfaces[] = {
    {Kind::Balanced, 0}, {Kind::Magnitude, 0.7}, {Kind::Isotropicity, 0.3}, {Kind::Traceless, 0}};

Tensor<Exact> exact(const Tensor<double>& t) {
  Tensor<Exact> r;
  for (int i = 0; i < 9; ++i) r[i] = Exact(t[i]);
  return r;
}

// The bound holds, and is not far from what happens: a smaller one would be caught.
TEST(QuadricForm, FilterBound) {
  oracle::Random random(1);
  for (const QuadricSurface& surface : kSurfaces) {
    double worst = 0;
    for (int n = 0; n < 20000; ++n) {
      const int k = n % 3 == 0 ? 0 : n % 3 == 1 ? 60 : -70;
      const Tensor<double> a = oracle::scaled(oracle::double_tensor(random), k),
                           b = oracle::scaled(oracle::double_tensor(random), k);
      double magnitude = 0;
      for (int i = 0; i < 9; ++i)
        magnitude = std::fmax(magnitude, std::fmax(std::fabs(a[i]), std::fabs(b[i])));
      const Exact error =
          Exact(quadric_polar(surface, a, b)) - quadric_polar(surface, exact(a), exact(b));
      const double relative =
          std::fabs(to_double_approx(error)) / quadric_polar_error(surface, magnitude);
      ASSERT_LE(relative, 1) << static_cast<int>(surface.kind);
      worst = std::fmax(worst, relative);
    }
    EXPECT_GT(worst, 0.001);
  }
  EXPECT_TRUE(std::isinf(quadric_polar_error(kSurfaces[0], 0x1p-200)));
  EXPECT_TRUE(std::isinf(quadric_polar_error(kSurfaces[0], 0)));
}

// The value of the form is that of the function of the interpolated tensor.
TEST(QuadricForm, IsTheFunctionOfTheTensor) {
  oracle::Random random(2);
  for (const QuadricSurface& surface : kSurfaces)
    for (int n = 0; n < 50; ++n) {
      TensorField field = test::one_tet(test::kAroundOrigin);
      for (auto& t : field.tensors) t = oracle::integer_tensor(random, 9);
      const SimplexForm<4> form(surface, field, test::kCorners);
      const auto& f = form.exact();
      std::array<Exact, 4> x;
      Exact sum(0);
      for (Exact& xi : x) sum = sum + (xi = Exact(oracle::integer(random, 5)));
      Tensor<Exact> t;
      for (int i = 0; i < 9; ++i) {
        t[i] = Exact(0);
        for (std::size_t v = 0; v < 4; ++v) t[i] = t[i] + x[v] * Exact(field.tensors[v][i]);
      }
      const Exact trace = t[0] + t[4] + t[8];
      const Exact squares = double_dot(t, t), value(surface.value);
      const Exact expected =
          surface.kind == Kind::Balanced
              ? Exact(3) * (trace * trace + Exact(3) * minus_trace_of_product(t, t))
          : surface.kind == Kind::Magnitude    ? squares - value * value * sum * sum
          : surface.kind == Kind::Isotropicity ? trace * trace - Exact(3) * value * value * squares
                                               : Exact(2) * trace * sum;
      EXPECT_EQ(bilinear(f, x, x), expected) << static_cast<int>(surface.kind);
    }
}

TEST(QuadricForm, AdjugateAndCenter) {
  oracle::Random random(3);
  for (int n = 0; n < 200; ++n) {
    QuadraticForm<Exact, 4> f;
    for (Exact& x : f.entries) x = Exact(oracle::integer(random, 9));
    const auto adj = adjugate(f);
    const Exact det = determinant(f, adj);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        Exact sum(0);
        for (int k = 0; k < 4; ++k) sum = sum + f(i, k) * adj(k, j);
        EXPECT_EQ(sum, i == j ? det : Exact(0));
      }
    // the centre is conjugate to every displacement
    const std::array<Exact, 4> c = center(adj);
    for (int i = 0; i < 3; ++i) {
      std::array<Exact, 4> d = {Exact(0), Exact(0), Exact(0), Exact(-1)};
      d[i] = Exact(1);
      EXPECT_EQ(bilinear(f, c, d), Exact(0));
    }
  }
}

// Where doubles cancel, form_approx uses exact numbers.
TEST(QuadricForm, ApproxOfTinyEntries) {
  TensorField field = test::one_tet(test::kAroundOrigin);
  for (std::size_t v = 0; v < 4; ++v)  // |T|^2 = 2 up to 2^-51
    field.tensors[v] = {1, v == 3 ? 1 + 0x1p-52 : 1, 0, 0, 0, 0, 0, 0, 0};
  const SimplexForm<4> form({Kind::Magnitude, std::sqrt(2.0)}, field, test::kCorners);
  const auto f = form_approx(form);
  const Exact zero = form.exact()(0, 0), last = form.exact()(3, 3);
  EXPECT_NEAR(f(3, 3) / f(0, 0), to_double_approx(last) / to_double_approx(zero), 1e-9);
}

}  // namespace
}  // namespace triplex

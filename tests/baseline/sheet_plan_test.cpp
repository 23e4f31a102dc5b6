// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "baseline/sheet_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "baseline/form_ranges.hpp"
#include "baseline/tet_coefficients.hpp"
#include "triplex/field/generators.hpp"

namespace triplex::baseline {
namespace {

/// Ranges in the lanes are the smallest and largest coefficient of each tet by itself, bit for bit,
/// wherever in a block the tet is.
TEST(FormRanges, AreThoseOfTheCoefficients) {
  GridOptions grid;
  grid.n = 3;
  const TensorField field = generate_noise(grid);
  const std::span<const std::array<VertexId, 4>> tets(field.mesh.tets);
  for (const std::size_t block : {1u, 3u, 8u, 13u}) {
    for (std::size_t first = 0; first < tets.size(); first += block) {
      const std::size_t count = std::min<std::size_t>(block, tets.size() - first);
      std::array<FormRanges, kRangeBlock> ranges;
      form_ranges(field, tets.subspan(first, count), 0.5, std::span(ranges).first(count));
      for (std::size_t n = 0; n < count; ++n) {
        const SortedTet sorted(tets[first + n]);
        EXPECT_TRUE(std::is_sorted(sorted.ids.begin(), sorted.ids.end()));
        std::array<Tensor<double>, 4> a;
        for (std::size_t i = 0; i < 4; ++i) {
          a[i] = field.tensors[index(sorted.ids[i])];
          for (double& entry : a[i]) entry *= 0.5;
          a[i] = triple_deviator(a[i]);
        }
        const Forms<double, 4> f = forms_of<double, 4>(a);
        EXPECT_EQ(ranges[n].p_min, *std::min_element(f.p.begin(), f.p.end()));
        EXPECT_EQ(ranges[n].p_max, *std::max_element(f.p.begin(), f.p.end()));
        EXPECT_EQ(ranges[n].q_min, *std::min_element(f.q.begin(), f.q.end()));
        EXPECT_EQ(ranges[n].q_max, *std::max_element(f.q.begin(), f.q.end()));
      }
    }
  }
}

/// What the ranges exclude has one sign at many points of the rectangle of values; and what they do
/// not exclude is rarely without a zero there.
TEST(ExcludedByRanges, AgainstValuesOfTheSextic) {
  std::mt19937 engine(21);
  std::uniform_real_distribution<double> number(-1, 1);
  int excluded = 0, kept = 0;
  for (const ModeMap map : {ModeMap{}, ModeMap{9, 18}, ModeMap{-4, 4}})
    for (int n = 0; n < 2000; ++n) {
      SheetPlan plan;
      plan.polynomial = Polynomial::Sextic;
      plan.map = map;
      FormRanges r{number(engine), number(engine), number(engine), number(engine)};
      if (r.p_min > r.p_max) std::swap(r.p_min, r.p_max);
      if (r.q_min > r.q_max) std::swap(r.q_min, r.q_max);
      bool negative = false, positive = false;
      for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j) {
          const double p = map.p_factor * (r.p_min + (r.p_max - r.p_min) * i / 40);
          const double q = map.q_factor * (r.q_min + (r.q_max - r.q_min) * j / 40);
          (2 * p * p * p + 3 * q * q < 0 ? negative : positive) = true;
        }
      if (excluded_by_ranges(plan, r)) {
        ++excluded;
        EXPECT_NE(negative, positive);
      } else {
        kept += negative != positive;
      }
    }
  EXPECT_GT(excluded, 1500);
  EXPECT_LT(kept, 300);
}

TEST(ExcludedByRanges, OneSignOfTheForms) {
  SheetPlan minor, det;
  det.polynomial = Polynomial::Det;
  EXPECT_TRUE(excluded_by_ranges(minor, {0, 1, -1, 1}));  // zero counts as positive
  EXPECT_FALSE(excluded_by_ranges(minor, {-1, 0, 1, 1}));
  EXPECT_TRUE(excluded_by_ranges(minor, {-2, -1, -1, 1}));
  EXPECT_TRUE(excluded_by_ranges(det, {-1, 1, 0, 1}));
  EXPECT_FALSE(excluded_by_ranges(det, {-1, 1, -1, 0}));
}

/// Coefficients are those of the polynomial: at a point of the tet the form has the value that the
/// tensor there gives.
TEST(TetCoefficients, HaveTheValuesOfTheTensors) {
  std::mt19937 engine(22);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto value = [](const auto& c, const auto& monomials, const Barycentric<4>& x) {
    double sum = 0;
    for (std::size_t n = 0; n < c.size(); ++n) {
      double term = c[n] * monomials.multinomial[n];
      for (int i = 0; i < 4; ++i) term *= std::pow(x[i], monomials.exponents[n][i]);
      sum += term;
    }
    return sum;
  };
  for (int n = 0; n < 50; ++n) {
    std::array<FieldPoint, 4> v{};
    std::array<Tensor<double>, 4> a;
    Barycentric<4> x{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (double& entry : v[i].t) entry = number(engine);
      a[i] = triple_deviator(v[i].t);
      x[i] = 0.25 + 0.05 * number(engine);
    }
    Tensor<double> t{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 9; ++k) t[k] += x[i] * v[i].t[k];
    const double trace = t[0] + t[4] + t[8], square = double_dot(t, t);
    const double sum = x[0] + x[1] + x[2] + x[3];  // homogeneous forms, so any sum will do
    EXPECT_NEAR(value(trace_coefficients(v), kMonomials<4, 1>, x), trace, 1e-14);
    EXPECT_NEAR(value(magnitude_coefficients(v, 0.7), kMonomials<4, 2>, x),
                square - 0.49 * sum * sum, 1e-13);
    EXPECT_NEAR(value(isotropicity_coefficients(v, -0.4), kMonomials<4, 2>, x),
                trace * trace - 3 * 0.16 * square, 1e-13);
    const Forms<double, 1> f = forms_of<double, 1>({triple_deviator(t)});
    const double p = -9 * f.p[0], q = 6 * f.q[0], scale = 1 + std::fabs(p * p * p) + q * q;
    EXPECT_NEAR(value(sextic_coefficients(forms_of<double, 4>(a), {-9, 6}), kMonomials<4, 6>, x),
                2 * p * p * p + 3 * q * q, 1e-11 * scale);
  }
}

}  // namespace
}  // namespace triplex::baseline

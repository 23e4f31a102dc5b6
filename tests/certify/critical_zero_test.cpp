// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/critical_zero.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../oracle/one_tet.hpp"
#include "../oracle/random_tensors.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {
namespace {

constexpr std::array kFace = {VertexId(0), VertexId(1), VertexId(2)};

std::array<Tensor<double>, 4> four_tensors(oracle::Random& random) {
  std::array<Tensor<double>, 4> tensors;
  for (auto& t : tensors) t = oracle::double_tensor(random);
  return tensors;
}

/// On the face q is the product of three entries, as on the planes of symmetry of the ABC flow.
TensorField with_product(oracle::Random& random) {
  auto tensors = four_tensors(random);
  for (auto& t : tensors) t[0] = t[4] = t[8] = t[2] = 0;
  return oracle::on_one_tet(tensors);
}

Tensor<Exact> interpolated(const RefinableField& field, const ExactWeights<3>& w) {
  Tensor<Exact> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const Tensor<Exact> a = field.exact(kFace[i]);
    for (std::size_t k = 0; k < 9; ++k) sum[k] = sum[k] + w[i] * a[k];
  }
  return sum;
}

TEST(CriticalZero, IsFoundExactlyWhereTwoFactorsOfQVanish) {
  oracle::Random random(3);
  int found = 0;
  for (int n = 0; n < 200; ++n) {
    const TensorField input = with_product(random);
    const RefinableField field(input);
    for (const ExactWeights<3>& w : critical_zeros(Simplex<3>(field, kFace))) {
      ++found;
      for (const Exact& x : w) EXPECT_EQ(sign(x), Sign::Positive);
      const Tensor<Exact> a = interpolated(field, w);
      // The derivative of the determinant along an edge, by the cofactors.
      for (std::size_t i = 1; i < 3; ++i) {
        const Tensor<Exact> to = field.exact(kFace[i]), from = field.exact(kFace[0]);
        Exact derivative(0);
        for (std::size_t k = 0; k < 9; ++k) {
          Tensor<Exact> row = a;
          const std::size_t r = k / 3;
          for (std::size_t c = 0; c < 3; ++c) row[3 * r + c] = Exact(c == k % 3 ? 1 : 0);
          derivative = derivative + forms_of<Exact, 1>({row}).q[0] * (to[k] - from[k]);
        }
        EXPECT_TRUE(derivative.is_zero());
      }
    }
  }
  EXPECT_GT(found, 20);
}

TEST(CriticalZero, GenericFacesHaveNone) {
  oracle::Random random(4);
  for (int n = 0; n < 200; ++n) {
    const TensorField input = oracle::on_one_tet(four_tensors(random));
    const RefinableField field(input);
    EXPECT_TRUE(critical_zeros(Simplex<3>(field, kFace)).empty());
    EXPECT_TRUE(critical_zeros(Simplex<2>(field, {kFace[0], kFace[1]})).empty());
  }
}

TEST(CriticalZero, OnAnEdgeLiesBetweenTwoZerosThatAgreeUpToRounding) {
  std::array<Tensor<double>, 4> tensors{};
  for (auto& t : tensors) t = {0, 0, 1, 1, 0, 1, 1, 1, 0};
  tensors[0][3] = -1, tensors[1][3] = 3;
  tensors[0][7] = -1 - 0x1p-52, tensors[1][7] = 3;
  const TensorField input = oracle::on_one_tet(tensors);
  const RefinableField field(input);
  const auto zeros = critical_zeros(Simplex<2>(field, {kFace[0], kFace[1]}));
  const auto is_between = [](const ExactWeights<2>& w) {
    // -w_0 + 3 w_1 is positive, (-1 - 2^-52) w_0 + 3 w_1 negative.
    return sign(Exact(3) * w[1] - w[0]) == Sign::Positive &&
           sign(Exact(3) * w[1] - Exact(1 + 0x1p-52) * w[0]) == Sign::Negative;
  };
  EXPECT_TRUE(std::ranges::any_of(zeros, is_between));
}

/// Regions of one sign of a form on a lattice of a triangle, and sign changes on each side.
struct Regions {
  int count = 0;
  std::array<int, 3> changes{};
};
template <class Value>
Regions regions_of(const Value& value) {
  constexpr int kParts = 48;
  std::vector<std::array<int, 2>> points;
  std::vector<int> label;
  const auto at = [&](int i, int j) { return i * (2 * kParts + 3 - i) / 2 + j; };
  std::vector<bool> positive;
  for (int i = 0; i <= kParts; ++i)
    for (int j = 0; i + j <= kParts; ++j) {
      points.push_back({i, j});
      positive.push_back(value(static_cast<double>(i) / kParts, static_cast<double>(j) / kParts) >
                         0);
    }
  label.assign(points.size(), -1);
  Regions r;
  for (std::size_t start = 0; start < points.size(); ++start) {
    if (label[start] >= 0) continue;
    std::vector<std::size_t> stack = {start};
    label[start] = r.count;
    while (!stack.empty()) {
      const auto [i, j] = points[stack.back()];
      const bool sign_here = positive[stack.back()];
      stack.pop_back();
      constexpr std::array<std::array<int, 2>, 6> kSteps = {
          {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};
      for (const auto& [di, dj] : kSteps) {
        if (i + di < 0 || j + dj < 0 || i + di + j + dj > kParts) continue;
        const auto next = static_cast<std::size_t>(at(i + di, j + dj));
        if (label[next] >= 0 || positive[next] != sign_here) continue;
        label[next] = r.count;
        stack.push_back(next);
      }
    }
    ++r.count;
  }
  for (int n = 0; n < kParts; ++n) {
    const auto differ = [&](int a, int b) {
      return positive[static_cast<std::size_t>(a)] != positive[static_cast<std::size_t>(b)];
    };
    r.changes[0] += differ(at(n, 0), at(n + 1, 0));
    r.changes[1] += differ(at(0, n), at(0, n + 1));
    r.changes[2] += differ(at(n, kParts - n), at(n + 1, kParts - n - 1));
  }
  return r;
}

TEST(Saddle, LeavesAtMostTwoRegionsWhereEdgesAreCrossedOnce) {
  oracle::Random random(5);
  const FeatureTable table;
  SignStages stages;
  int certified = 0, refused_many = 0;
  for (int n = 0; n < 3000; ++n) {
    const TensorField input = oracle::on_one_tet(four_tensors(random));
    const RefinableField field(input);
    const Simplex<3> face(field, kFace);
    for (const int s : {kBalancedSheet, kNeutralSheet}) {
      const Sheet& sheet = table.sheets()[static_cast<std::size_t>(s)];
      const Regions r = regions_of([&](double y, double z) {
        Tensor<double> t{};
        for (std::size_t k = 0; k < 9; ++k)
          t[k] = (1 - y - z) * field.approximate(kFace[0]).a[k] +
                 y * field.approximate(kFace[1]).a[k] + z * field.approximate(kFace[2]).a[k];
        const auto f = forms_of<double, 1>({t});
        return s == kBalancedSheet ? f.p[0] : f.q[0];
      });
      const bool once = std::ranges::all_of(r.changes, [](int c) { return c <= 1; });
      const bool saddle = certifies_saddle(face, sheet, stages);
      if (once && r.count > 2) {
        ++refused_many;
        EXPECT_FALSE(saddle);
      }
      if (once && saddle) {
        ++certified;
        EXPECT_LE(r.count, 2);
      }
    }
  }
  EXPECT_GT(certified, 100);
  EXPECT_GT(refused_many, 10);
}

}  // namespace
}  // namespace triplex

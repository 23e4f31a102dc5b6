// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/point_arrays.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "../oracle/random_tensors.hpp"

namespace triplex {
namespace {

using Values = std::vector<double>;

constexpr Tensor<double> kZero = {};
constexpr Tensor<double> kIdentity = {2, 0, 0, 0, 2, 0, 0, 0, 2};
constexpr Tensor<double> kLinear = {4, 1, 0, 0, 0, 0, 0, 0, -1};  // eigenvalues 4, 0, -1
constexpr Tensor<double> kPlanar = {-4, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr Tensor<double> kNeutral = {1, 0, 0, 0, 0, 0, 0, 0, -1};
constexpr Tensor<double> kNode = {2, 0, 0, 0, -1, 0, 0, 0, -1};
constexpr Tensor<double> kDegenerate = {2, 0, 0, 0, -1, 1, 0, 0, -1};
constexpr Tensor<double> kJordan = {0, 1, 0, 0, 0, 1, 0, 0, 0};
constexpr Tensor<double> kBalanced = {0, 1, 0, 0, 0, 1, 1, 0, 0};
// A rotation about z with the orbits of x' = -4 y, y' = x: an ellipse of axes 2 and 1.
constexpr Tensor<double> kSpin = {0, -4, 0, 1, 0, 0, 0, 0, 1};

Values evaluate(std::string_view name, const Tensor<double>& t) {
  const PointArray* const row = point_array_named(name);
  if (row == nullptr) {
    ADD_FAILURE() << name;
    return {};
  }
  Values values(static_cast<std::size_t>(row->components), -77);
  row->evaluate(t, values.data());
  return values;
}

void expect_values(std::string_view name, const Tensor<double>& t, const Values& expected) {
  const Values actual = evaluate(name, t);
  ASSERT_EQ(actual.size(), expected.size()) << name;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    if (std::isnan(expected[i])) {
      EXPECT_TRUE(std::isnan(actual[i])) << name << ' ' << i << ": " << actual[i];
    } else if (std::isinf(expected[i])) {
      EXPECT_EQ(actual[i], expected[i]) << name << ' ' << i;
    } else {
      EXPECT_NEAR(actual[i], expected[i], 1e-12) << name << ' ' << i;
    }
  }
}

const double kNaN = std::nan("");
const Values kNone = {kNaN, kNaN, kNaN};

TEST(PointArrays, NamesAreUniqueAndFound) {
  std::set<std::string_view> names;
  for (const PointArray& row : point_array_table()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos);
    EXPECT_EQ(point_array_named(row.name), &row);
    EXPECT_FALSE(row.meaning.empty());
  }
  EXPECT_EQ(point_array_named("no-such-array"), nullptr);
  EXPECT_EQ(point_array_named(""), nullptr);
}

// Every component is written and nothing behind them, for tensors of every kind and size; values
// are finite or NaN in all components, but for over- and underflow of invariants.
TEST(PointArrays, WriteTheirComponentsAndNothingElse) {
  oracle::Random random(1);
  for (int n = 0; n < 300; ++n) {
    const Tensor<double> shape =
        n % 2 == 0 ? oracle::degenerate_tensor(random) : oracle::double_tensor(random);
    for (const int exponent : {0, 1010, -1060}) {
      const Tensor<double> t = oracle::scaled(shape, exponent);
      for (const PointArray& row : point_array_table()) {
        constexpr double kCanary = 123.456;
        std::array<double, 10> out;
        out.fill(kCanary);
        row.evaluate(t, out.data());
        int nans = 0;
        for (int i = 0; i < row.components; ++i) {
          EXPECT_NE(out[i], kCanary) << row.name;
          nans += static_cast<int>(std::isnan(out[i]));
        }
        EXPECT_TRUE(nans == 0 || nans == row.components) << row.name;
        for (std::size_t i = row.components; i < out.size(); ++i) EXPECT_EQ(out[i], kCanary);
      }
    }
  }
}

TEST(PointArrays, InvariantsAndDomain) {
  expect_values("tensor", kLinear, {4, 1, 0, 0, 0, 0, 0, 0, -1});
  expect_values("deviator", kLinear, {3, 1, 0, 0, -1, 0, 0, 0, -2});
  expect_values("trace", kLinear, {3});
  expect_values("magnitude", kLinear, {std::sqrt(18)});
  expect_values("isotropicity", kIdentity, {1});
  expect_values("isotropicity", kZero, {kNaN});
  expect_values("p", kLinear, {-7});
  expect_values("q", kLinear, {6});
  expect_values("discriminant", kLinear, {4 * 343 - 27 * 36});
  expect_values("mode", kDegenerate, {1});
  expect_values("mode", kBalanced, {HUGE_VAL});
  expect_values("mode", kJordan, {kNaN});
  const std::vector<std::pair<Tensor<double>, double>> domains = {
      {kLinear, 2},
      {kPlanar, 3},
      {kNeutral, 9},
      {kNode, 8},
      {kBalanced, 7},
      {kJordan, 12},
      {kSpin, 0},
      {oracle::negated(kSpin), 5},
      {oracle::negated(kNode), 10},
      {oracle::negated(kBalanced), 11},
      {{0, -4, 0, 1, 0, 0, 0, 0, 0}, 6},
      {{-1, 0.5, 0, -0.5, -1, 0, 0, 0, 2}, 1},
      {{1, 0.5, 0, -0.5, 1, 0, 0, 0, -2}, 4}};
  for (const auto& [t, code] : domains) expect_values("domain", t, {code});
}

TEST(PointArrays, Eigenvalues) {
  expect_values("eigenvalues", kLinear, {4, 0, -1});
  expect_values("eigenvalues", kSpin, {1, 0, 0});
  expect_values("eigenvalue-imaginary", kLinear, {0});
  expect_values("eigenvalue-imaginary", kSpin, {2});
  expect_values("eigenvalue-space", kIdentity, {0, 0, 1});
  expect_values("eigenvalue-space", kZero, kNone);
  expect_values("eigenvalue-space", kNeutral, {0, 1, 0});
}

TEST(PointArrays, EigenvectorsWhereTheyAreUnique) {
  const double r = std::sqrt(0.5);
  expect_values("eigenvector-major", kLinear, {1, 0, 0});
  expect_values("eigenvector-medium", kLinear, {-1 / std::sqrt(17), 4 / std::sqrt(17), 0});
  expect_values("eigenvector-minor", kLinear, {0, 0, 1});
  expect_values("eigenvector-major", kNode, {1, 0, 0});
  expect_values("eigenvector-medium", kNode, kNone);
  expect_values("eigenvector-minor", kNode, kNone);
  expect_values("eigenvector-medium", kDegenerate, {0, 1, 0});
  expect_values("eigenvector-minor", kDegenerate, {0, 1, 0});
  for (const char* const name : {"eigenvector-major", "eigenvector-medium", "eigenvector-minor"}) {
    expect_values(name, kJordan, {1, 0, 0});
    expect_values(name, kIdentity, kNone);
    expect_values(name, kSpin, kNone);
  }
  expect_values("real-eigenvector", kSpin, {0, 0, 1});
  expect_values("real-eigenvector", kLinear, kNone);
  expect_values("dominant-eigenvector", kLinear, {1, 0, 0});
  expect_values("dominant-eigenvector", kPlanar, {4 / std::sqrt(17), -1 / std::sqrt(17), 0});
  expect_values("dominant-eigenvector", kNeutral, kNone);
  expect_values("dominant-eigenvector", kNode, {1, 0, 0});
  expect_values("dominant-eigenvector", kSpin, {0, 0, 1});
  expect_values("dominant-eigenvector", {0, r, 0, r, 0, 0, 0, 0, -0.1}, {r, r, 0});
}

TEST(PointArrays, DualEigenvectorsAndSchurForm) {
  expect_values("dual-eigenvector-major", kSpin, {1, 0, 0});
  expect_values("dual-eigenvector-minor", kSpin, {0, 1, 0});
  expect_values("eccentricity", kSpin, {std::sqrt(0.75)});
  expect_values("dual-eigenvector-major", kLinear, kNone);
  expect_values("eccentricity", kNode, {kNaN});
  expect_values("eccentricity", kDegenerate, {1});
  expect_values("schur", kNode, {-1, 0, 0, 0, -1, 0, 0, 0, 2});
  const Values s = evaluate("schur", kSpin);
  EXPECT_NEAR(s[0], 1.5, 1e-12);  // the symmetric part has eigenvalues +-3/2
  EXPECT_NEAR(s[3], 2.5, 1e-12);
  EXPECT_NEAR(s[8], 1, 1e-12);
  const Values q = evaluate("schur-rotation", kSpin);
  EXPECT_NEAR(std::fabs(q[8]), 1, 1e-12);
}

}  // namespace
}  // namespace triplex

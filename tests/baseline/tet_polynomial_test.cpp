// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "baseline/tet_polynomial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "baseline/segment_root.hpp"

namespace triplex::baseline {
namespace {

/// The polynomial at a point, by its definition.
template <int Degree>
double value_at(const Coefficients<4, Degree>& c, const Barycentric<4>& x) {
  double sum = 0;
  for (std::size_t n = 0; n < c.size(); ++n) {
    double term = c[n] * kMonomials<4, Degree>.multinomial[n];
    for (int i = 0; i < 4; ++i) term *= std::pow(x[i], kMonomials<4, Degree>.exponents[n][i]);
    sum += term;
  }
  return sum;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double number(double low = -1, double high = 1) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// A point of the face of these vertices.
  Barycentric<4> point(VertexMask face) {
    Barycentric<4> x{};
    double sum = 0;
    for (int i = 0; i < 4; ++i)
      if (face >> i & 1u) sum += x[i] = number(0, 1);
    for (double& w : x) w /= sum;
    return x;
  }
  template <int Degree>
  Coefficients<4, Degree> coefficients() {
    Coefficients<4, Degree> c;
    for (double& value : c) value = number();
    return c;
  }
  /// A linear function and noise: patches are frequent among these.
  template <int Degree>
  Coefficients<4, Degree> nearly_linear(double noise) {
    std::array<double, 4> v;
    for (double& value : v) value = number();
    Coefficients<4, Degree> c;
    for (std::size_t n = 0; n < c.size(); ++n) {
      c[n] = noise * number();
      for (int i = 0; i < 4; ++i) c[n] += v[i] * kMonomials<4, Degree>.exponents[n][i] / Degree;
    }
    return c;
  }

 private:
  std::mt19937 engine_;
};

template <int Degree>
void check_halves(Dice& dice) {
  const auto c = dice.coefficients<Degree>();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      const auto [keeps_i, keeps_j] = halves<Degree>(c, i, j);
      const Barycentric<4> x = dice.point(15);
      Barycentric<4> of_i = x, of_j = x;  // the same point of each half, in the whole
      of_i[i] += x[j] / 2;
      of_i[j] = x[j] / 2;
      of_j[j] += x[i] / 2;
      of_j[i] = x[i] / 2;
      EXPECT_NEAR((value_at<Degree>(keeps_i, x)), (value_at<Degree>(c, of_i)), 1e-13);
      EXPECT_NEAR((value_at<Degree>(keeps_j, x)), (value_at<Degree>(c, of_j)), 1e-13);
    }
}

TEST(Halves, AreThePolynomialOnTheHalves) {
  Dice dice(1);
  for (int n = 0; n < 20; ++n) {
    check_halves<1>(dice);
    check_halves<2>(dice);
    check_halves<3>(dice);
    check_halves<6>(dice);
  }
}

/// Two tets that share the face of vertices 0, 1, 2, which are 2, 0, 3 of the other.
TEST(Halves, HaveTheSameBitsOnASharedFace) {
  Dice dice(2);
  const auto c = dice.coefficients<6>();
  auto other = dice.coefficients<6>();
  const auto there = [](const std::array<std::uint8_t, 4>& e) {
    return static_cast<std::size_t>((kMonomials<4, 6>.find({e[1], 0, e[0], e[2]})));
  };
  const auto& exponents = kMonomials<4, 6>.exponents;
  for (std::size_t n = 0; n < c.size(); ++n)
    if (exponents[n][3] == 0) other[there(exponents[n])] = c[n];
  const auto here = halves<6>(c, 0, 2);
  const auto beyond = halves<6>(other, 3, 2);  // the same edge, from its other end
  for (std::size_t n = 0; n < c.size(); ++n) {
    if (exponents[n][3] != 0) continue;
    EXPECT_EQ(here.first[n], beyond.second[there(exponents[n])]);
    EXPECT_EQ(here.second[n], beyond.first[there(exponents[n])]);
  }
}

template <int Degree>
void check_segments(const Coefficients<4, Degree>& c, VertexMask positive, Dice& dice) {
  constexpr int kSamples = 64;
  for (int segment = 0; segment < 8; ++segment) {
    const Barycentric<4> from = dice.point(15u & ~positive), to = dice.point(positive);
    Barycentric<4> ends{};
    for (int i = 0; i < 4; ++i) ends[i] = from[i] + to[i];
    const auto along = along_segment<4, Degree>(c, positive, ends);
    const double root = root_approx(along);
    int changes = 0;
    double last = -1;
    for (int s = 0; s <= kSamples; ++s) {
      const double t = static_cast<double>(s) / kSamples;
      Barycentric<4> x;
      for (int i = 0; i < 4; ++i) x[i] = (1 - t) * from[i] + t * to[i];
      const double value = value_at<Degree>(c, x);
      EXPECT_NEAR(value, value_and_slope(along, t).first, 1e-12);
      if (std::fabs(value) < 1e-14) continue;  // rounding hides the sign
      changes += (value < 0) != (last < 0);
      last = value;
    }
    EXPECT_EQ(changes, 1);
    EXPECT_NEAR(value_and_slope(along, root).first, 0, 1e-13);
  }
}

/// The claim of a patch against dense sampling, of an empty tet too.
template <int Degree>
std::array<int, 3> check_claims(unsigned seed, PatchTest patch_test, double noise) {
  Dice dice(seed);
  std::array<int, 3> count{};  // three-sided, four-sided, mixed
  for (int n = 0; n < 250; ++n) {
    const auto c = dice.nearly_linear<Degree>(noise);
    const SignTest test = sign_test<4, Degree>(c, patch_test);
    for (int i = 0; i < 4; ++i) {
      Barycentric<4> corner{};
      corner[i] = 1;
      EXPECT_EQ((value_at<Degree>(c, corner) >= 0), (test.positive >> i & 1u) != 0);
    }
    if (test.pattern == SignPattern::OneSign) {
      for (int s = 0; s < 30; ++s)
        EXPECT_EQ((value_at<Degree>(c, dice.point(15)) < 0), test.positive == 0);
    } else if (test.pattern == SignPattern::Patch) {
      ++count[std::popcount(test.positive) == 2];
      check_segments<Degree>(c, test.positive, dice);
    } else {
      ++count[2];
    }
  }
  return count;
}

TEST(SignTest, ClaimsHoldOnDenseSamples) {
  for (const PatchTest patch_test : {PatchTest::Layers, PatchTest::LayersOrGrowth}) {
    for (const auto& count :
         {check_claims<2>(3, patch_test, 0.4), check_claims<3>(4, patch_test, 0.2),
          check_claims<6>(5, patch_test, 0.05)}) {
      EXPECT_GT(count[0], 5);
      EXPECT_GT(count[1], 5);
      EXPECT_GT(count[2], 5);
    }
    const auto linear = check_claims<1>(6, patch_test, 0);
    EXPECT_EQ(linear[2], 0);
  }
}

/// A plane in degree six: the layers between the lone vertex and the others are mixed at several
/// depths, however small the tet. Growth sees the plane.
TEST(SignTest, GrowthAcceptsPlanesThatLayersDoNot) {
  Coefficients<4, 6> c;
  constexpr std::array<double, 4> kValues{-1, 0.1, 5, 5};
  for (std::size_t n = 0; n < c.size(); ++n) {
    c[n] = 0;
    for (int i = 0; i < 4; ++i) c[n] += kValues[i] * kMonomials<4, 6>.exponents[n][i] / 6;
  }
  EXPECT_EQ((sign_test<4, 6>(c, PatchTest::Layers).pattern), SignPattern::Mixed);
  const SignTest test = sign_test<4, 6>(c, PatchTest::LayersOrGrowth);
  EXPECT_EQ(test.pattern, SignPattern::Patch);
  EXPECT_EQ(test.positive, 0b1110u);
  // Falling towards one positive vertex somewhere: no growth.
  c[kMonomials<4, 6>.find({1, 5, 0, 0})] = 0.2;
  EXPECT_EQ((sign_test<4, 6>(c, PatchTest::LayersOrGrowth).pattern), SignPattern::Mixed);
}

TEST(SignTest, ZeroCountsAsPositive) {
  Coefficients<4, 2> c{};
  SignTest test = sign_test<4, 2>(c, PatchTest::Layers);
  EXPECT_EQ(test.pattern, SignPattern::OneSign);
  EXPECT_EQ(test.positive, 15u);
  c[kEdgeCoefficients<4, 2>.at[2][2][0]] = -1;
  test = sign_test<4, 2>(c, PatchTest::Layers);
  EXPECT_EQ(test.pattern, SignPattern::Patch);
  EXPECT_EQ(test.positive, 0b1011u);
  c.fill(-0.0);
  EXPECT_EQ((sign_test<4, 2>(c, PatchTest::Layers).positive), 15u);
}

TEST(AlongEdge, IsTheSegmentBetweenTwoVertices) {
  Dice dice(7);
  const auto c = dice.coefficients<6>();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      Barycentric<4> ends{};
      ends[i] = ends[j] = 1;
      const auto edge = along_edge<4, 6>(c, i, j), segment = along_segment<4, 6>(c, 1u << j, ends);
      for (std::size_t k = 0; k < edge.size(); ++k) EXPECT_NEAR(edge[k], segment[k], 1e-15);
    }
}

TEST(Root, IsFoundToRounding) {
  EXPECT_EQ(root_approx(std::array<double, 2>{-1, 3}), 0.25);
  EXPECT_EQ(root_approx(std::array<double, 3>{-1, -1, 0}), 1);  // zero at the end
  EXPECT_NEAR(root_approx(std::array<double, 3>{-1e-300, 1, 1}), 5e-301, 0x1p-53);
  // (t - 0.3)^3: coefficients by polarisation. The root is known to the cube root of rounding.
  std::array<double, 4> cube;
  for (int k = 0; k < 4; ++k) cube[k] = std::pow(0.7, k) * std::pow(-0.3, 3 - k);
  EXPECT_NEAR(root_approx(cube), 0.3, 1e-4);
  // Flat at both ends, where Newton's steps leave the interval.
  EXPECT_NEAR(root_approx(std::array<double, 7>{-1, -1, -1, 1e-3, 1, 1, 1}), 0.5, 1e-3);
  constexpr std::array<double, 7> kSteep{-1e-12, -1e-12, -1e-12, 0, 0, 0, 1};
  EXPECT_NEAR(value_and_slope(kSteep, root_approx(kSteep)).first, 0, 0x1p-51);
  // Where a bracket alone would leave: several roots, one of them is found.
  constexpr std::array<double, 7> kWaves{-1, 9, -20, 20, -20, 9, 1};
  EXPECT_NEAR(value_and_slope(kWaves, root_approx(kWaves)).first, 0, 20 * 0x1p-50);
}

}  // namespace
}  // namespace triplex::baseline

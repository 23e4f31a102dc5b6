// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a nappe certificate claims is held against dense sampling along lines of its direction.
#include "triplex/certify/nappe.hpp"

#include <gtest/gtest.h>

#include "../oracle/block_fields.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/graph.hpp"
#include "triplex/certify/pencil.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {
namespace {

using test::OneTet;
using test::Random;
using test::uniform;
using test::Wide;

/// D along a segment as a word of signs: real 'r', complex 'c', repeats dropped.
template <int N>
std::string pattern_along(const Simplex<N>& simplex, const test::Coordinates<N>& at,
                          const test::Coordinates<N>& direction, double from, double to,
                          int samples) {
  std::string word;
  for (int k = 0; k <= samples; ++k) {
    const double t = from + (to - from) * k / samples;
    std::array<Wide, N> w;
    for (int i = 0; i < N; ++i)
      w[i] = static_cast<Wide>(at[i]) + static_cast<Wide>(t) * static_cast<Wide>(direction[i]);
    const int sign = test::sign_of(test::discriminant(simplex.field(), simplex.vertices(), w));
    const char c = sign > 0 ? 'r' : 'c';
    if (sign != 0 && (word.empty() || word.back() != c)) word += c;
  }
  return word;
}

struct Patterns {
  int lines = 0, wrong = 0, with_gap = 0;  // with_gap: complex, real, complex
};

/// The segments of lines along a direction through random points of a simplex; some of them close
/// to `near`, where samples are dense.
template <int N>
Patterns patterns(const Simplex<N>& simplex, const NappeDirection<N>& d, Random& random,
                  const test::Coordinates<N>& near, int lines = 200) {
  std::array<double, N> direction{};
  for (int k = 1; k < N; ++k) {
    direction[k] = d[k - 1];
    direction[0] -= d[k - 1];
  }
  Patterns found;
  for (int n = 0; n < lines; ++n) {
    const auto any = test::random_weights(random, N);
    const double pull = n % 2 == 0 ? 1 : std::exp2(-uniform(random, 0, 30));
    std::array<double, N> at;
    for (int i = 0; i < N; ++i) at[i] = near[i] + pull * (any[i] - near[i]);
    double from = -HUGE_VAL, to = HUGE_VAL;
    for (int i = 0; i < N; ++i) {
      if (direction[i] == 0) continue;
      const double t = -at[i] / direction[i];
      (direction[i] > 0 ? from : to) = direction[i] > 0 ? std::max(from, t) : std::min(to, t);
    }
    for (const double zoom : {1.0, pull, 8 * pull}) {
      const auto word = pattern_along(simplex, at, direction, std::max(from, from * zoom),
                                      std::min(to, to * zoom), 80);
      ++found.lines;
      found.wrong += word.find("rcr") != std::string::npos;
      found.with_gap += word == "crc";
    }
  }
  return found;
}

class NappeTest : public testing::Test {
 protected:
  SignStages stages_;
};

constexpr std::array<double, 4> kCentre = {0.25, 0.25, 0.25, 0.25};

TEST_F(NappeTest, CertifiedLinesLeaveTheComplexDomainAndEnterItAtMostOnce) {
  Random random(1);
  int certified = 0, faces = 0;
  for (int n = 0; n < 800; ++n) {
    const Eigen::Matrix3d base = test::random_matrix(random);
    std::array<Eigen::Matrix3d, 4> t;
    for (auto& m : t)
      m = base + std::exp2(-static_cast<double>(n % 6)) * test::random_matrix(random);
    OneTet tet(t);
    const Simplex<4> cell = tet.cell();
    if (const auto d = nappe_direction(cell, stages_)) {
      ++certified;
      EXPECT_EQ(patterns(cell, *d, random, kCentre, 20).wrong, 0) << n;
    }
    const Simplex<3> face(cell, {0, 1, 2});
    if (const auto d = nappe_direction(face, stages_)) {
      ++faces;
      EXPECT_EQ(patterns(face, *d, random, {0.3, 0.3, 0.4}, 20).wrong, 0) << n;
    }
  }
  EXPECT_GT(certified, 40);
  EXPECT_GT(faces, 40);
}

/// Through a node and next to it: the two nappes touch, and every line meets each at most once.
TEST_F(NappeTest, HoldsThroughNodes) {
  Random random(2);
  int certified = 0, with_gap = 0;
  const test::Weights node = {0.3, 0.2, 0.1, 0.4};
  for (int n = 0; n < 200; ++n) {
    OneTet tet(test::planted_node(random, node, std::exp2(-2.0 - n % 8)));
    const auto d = nappe_direction(tet.cell(), stages_);
    if (!d) continue;
    ++certified;
    const Patterns p = patterns(tet.cell(), *d, random, node, 30);
    EXPECT_EQ(p.wrong, 0) << n;
    with_gap += p.with_gap > 0;
  }
  EXPECT_GT(certified, 100);  // others hold more of the field than the cone
  EXPECT_GT(with_gap, 90);
}

/// Corner values of (u, v, w) that are linear in space.
std::array<Eigen::Matrix3d, 4> field_of(const std::array<Eigen::Vector3d, 4>& uvw, Random& random) {
  const Eigen::Matrix3d basis = test::random_basis(random);
  std::array<Eigen::Matrix3d, 4> t;
  for (int i = 0; i < 4; ++i) t[i] = test::block_tensor(uvw[i], 1 + 0.01 * i, basis);
  return t;
}

/// u^2 + gap^2 = w^2: two sheets that come as near as 2 gap, or, without gap, cross.
TEST_F(NappeTest, HoldsNearlyCrossingSheets) {
  Random random(3);
  for (const double gap : {1e-3, 1e-5, 1e-7, 1e-9, 0.0}) {
    const std::array<Eigen::Vector3d, 4> uvw = {Eigen::Vector3d{-0.05, gap, 0.1},
                                                {0.08, gap, 0.12},
                                                {0.01, gap, -0.1},
                                                {-0.02, gap, -0.13}};
    OneTet tet(field_of(uvw, random));
    const auto d = nappe_direction(tet.cell(), stages_);
    ASSERT_TRUE(d) << gap;
    const Patterns p = patterns(tet.cell(), *d, random, {0.23, 0.22, 0.3, 0.25});
    EXPECT_EQ(p.wrong, 0);
    EXPECT_GT(p.with_gap, 0);
    EXPECT_FALSE(
        certifies_graph(tet.cell(), FeatureTable().sheet(Feature::DegeneratePlanar), stages_));
    EXPECT_FALSE(certifies_pencil(tet.cell(), Sheet{.kind = Sheet::Kind::Curved}, stages_));
  }
}

/// Without a timelike direction nothing is claimed.
TEST_F(NappeTest, RefusesTubesAndClosedSurfaces) {
  Random random(4);
  for (const double radius : {1e-1, 1e-3, 1e-6}) {
    const std::array<Eigen::Vector3d, 4> uvw = {Eigen::Vector3d{0.2, 0, radius},
                                                {-0.1, 0.2, radius},
                                                {-0.1, -0.2, radius},
                                                {0, 0.05, radius}};
    OneTet tet(field_of(uvw, random));
    EXPECT_FALSE(nappe_direction(tet.cell(), stages_)) << radius;
  }
  for (const double a : {0.125, 0.01}) {
    std::array<Eigen::Matrix3d, 4> t;
    const std::array<std::array<double, 3>, 4> corners = {
        {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
    for (int i = 0; i < 4; ++i) {
      const auto [x, y, z] = corners[i];
      t[i] << 2 * a, -z, y, z, -a, -x, -y, x, -a;
    }
    OneTet tet(t);
    EXPECT_FALSE(nappe_direction(tet.cell(), stages_));
  }
}

/// Nothing is proven where the third eigenvalue meets the pair: on the triple degenerate curve.
TEST_F(NappeTest, RefusesTheTripleDegenerateCurve) {
  Random random(5);
  for (int n = 0; n < 200; ++n) {
    // A nilpotent tensor at the centre.
    Eigen::Matrix3d nilpotent;
    nilpotent << 0, 1, uniform(random), 0, 0, 1, 0, 0, 0;
    const Eigen::Matrix3d basis = test::random_basis(random);
    std::array<Eigen::Matrix3d, 4> t;
    Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
    for (auto& m : t)
      mean += 0.25 * (m = std::exp2(-static_cast<double>(n % 8)) * test::random_matrix(random));
    for (auto& m : t) m += basis * nilpotent * basis.inverse() - mean;
    OneTet tet(t);
    EXPECT_FALSE(nappe_direction(tet.cell(), stages_));
  }
}

/// Tensors of any scale, and data that make intervals overflow, prove nothing wrong.
TEST_F(NappeTest, NeedsNoUsableBasis) {
  Random random(6);
  for (const double tiny : {1e-300, 1e-160, 1e-80}) {
    const std::array<Eigen::Vector3d, 4> uvw = {
        Eigen::Vector3d{0.2, 0, tiny}, {-0.1, 0.2, tiny}, {-0.1, -0.2, tiny}, {0, 0.05, 2 * tiny}};
    OneTet tet(field_of(uvw, random));
    EXPECT_FALSE(nappe_direction(tet.cell(), stages_));
  }
  std::array<Eigen::Matrix3d, 4> same;
  for (auto& m : same) m = Eigen::Vector3d(1, 1, -2).asDiagonal();
  OneTet constant(same);
  EXPECT_FALSE(nappe_direction(constant.cell(), stages_));
}

}  // namespace
}  // namespace triplex

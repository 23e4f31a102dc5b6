// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is claimed of two sheets that nearly coincide is held against dense sampling in wide
// arithmetic along lines of the certificate's direction.
#include "triplex/certify/sheet_pair.hpp"

#include <gtest/gtest.h>

#include "../oracle/block_fields.hpp"
#include "triplex/certify/degenerate_roots.hpp"

namespace triplex {
namespace {

using test::OneTet;
using test::Random;
using test::uniform;
using test::Wide;

/// The corners' block [[u, v + w], [v - w, -u]]: u changes sign, v and w are small and nearly
/// constant, so D < 0 between two sheets about sqrt(w^2 - v^2) from u = 0, or nowhere.
std::array<Eigen::Matrix3d, 4> thin_field(Random& random, double v, double w) {
  const Eigen::Matrix3d basis = test::random_basis(random);
  const std::array<double, 4> u = {-0.11, 0.05, 0.12, 0.07};
  std::array<Eigen::Matrix3d, 4> t;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d uvw(u[i] + 0.01 * uniform(random), v * (1 + 0.1 * uniform(random)),
                              w * (1 + 0.1 * uniform(random)));
    t[i] = test::block_tensor(uvw, 1 + 0.05 * uniform(random), basis);
  }
  return t;
}

/// The signs of D along a line through a point of a simplex, near the sheets and far from them;
/// repeats dropped.
template <int N>
std::string word_along(const Simplex<N>& simplex, const NappeDirection<N>& d,
                       const std::array<double, N>& at) {
  std::array<double, N> rate{};
  for (int k = 1; k < N; ++k) rate[k] = d[k - 1], rate[0] -= d[k - 1];
  double from = -HUGE_VAL, to = HUGE_VAL;
  for (int i = 0; i < N; ++i) {
    if (rate[i] == 0) continue;
    const double t = -at[i] / rate[i];
    (rate[i] > 0 ? from : to) = rate[i] > 0 ? std::max(from, t) : std::min(to, t);
  }
  const auto value = [&](double t) {
    std::array<Wide, N> w;
    for (int i = 0; i < N; ++i)
      w[i] = static_cast<Wide>(at[i]) + static_cast<Wide>(t) * static_cast<Wide>(rate[i]);
    return test::discriminant(simplex.field(), simplex.vertices(), w);
  };
  // D is convex near its minimum: thirds.
  double lo = from, hi = to;
  for (int n = 0; n < 120; ++n) {
    const double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
    (value(a) < value(b) ? hi : lo) = value(a) < value(b) ? b : a;
  }
  const double centre = lo + (hi - lo) / 2;
  std::vector<double> samples = {from, centre, to};
  for (double h = (to - from) / 2; h > 1e-14 * (to - from); h /= 1.5)
    for (const double t : {centre - h, centre + h})
      if (t > from && t < to) samples.push_back(t);
  std::ranges::sort(samples);
  std::string word;
  for (const double t : samples) {
    const Wide x = value(t);
    const char c = x > 0 ? 'r' : 'c';
    if (x != 0 && (word.empty() || word.back() != c)) word += c;
  }
  return word;
}

TEST(SheetPair, LinesMeetEachSheetAtMostOnceHoweverThinTheLayer) {
  Random random(1);
  SignStages stages;
  int tets = 0, faces = 0, through = 0;
  for (const double size : {1e-2, 1e-4, 1e-6, 1e-8})
    for (int n = 0; n < 25; ++n) {
      OneTet tet(thin_field(random, 0.3 * size, size));
      const Simplex<4> cell = tet.cell();
      if (const auto pair = SheetPair<4>::find(cell, stages)) {
        ++tets;
        EXPECT_FALSE(pair->is_empty());
        for (int line = 0; line < 20; ++line) {
          const auto w = test::random_weights(random);
          const std::string word = word_along<4>(cell, pair->direction(), w);
          EXPECT_EQ(word.find("crc"), std::string::npos) << word;
          through += word == "rcr";
        }
      }
      faces += SheetPair<3>::find(Simplex<3>(cell, {0, 1, 2}), stages).has_value();
    }
  EXPECT_GT(tets, 80);
  EXPECT_GT(faces, 80);
  EXPECT_GT(through, 1000);
}

TEST(SheetPair, NoSheetsWhereTheCouplingsAgree) {
  Random random(2);
  SignStages stages;
  int empty = 0;
  for (const double size : {1e-2, 1e-4, 1e-6, 1e-8})
    for (int n = 0; n < 25; ++n) {
      OneTet tet(thin_field(random, size, 0.3 * size));
      const auto pair = SheetPair<4>::find(tet.cell(), stages);
      if (!pair) continue;
      EXPECT_TRUE(pair->is_empty());
      empty += pair->is_empty();
      for (int line = 0; line < 20; ++line)
        EXPECT_EQ(word_along<4>(tet.cell(), pair->direction(), test::random_weights(random)), "r");
    }
  EXPECT_GT(empty, 80);
}

/// The two roots on an edge lie on different sheets, the lower one first along the direction.
TEST(SheetPair, RootsOnEdgesAreToldApart) {
  Random random(3);
  SignStages stages;
  int edges = 0;
  for (const double size : {1e-3, 1e-5, 1e-7})
    for (int n = 0; n < 25; ++n) {
      OneTet tet(thin_field(random, 0.2 * size, size));
      const Simplex<4> cell = tet.cell();
      const auto pair = SheetPair<4>::find(cell, stages);
      const auto roots = isolate_degenerate_roots(Simplex<2>(cell, {0, 1}), stages);
      ASSERT_TRUE(roots.has_value());
      ASSERT_EQ(roots->count, 2);
      if (!pair) continue;
      const auto side = [&](std::size_t i) {
        return pair->sheet_at(cell, {{0, 1}, roots->roots[i].t});
      };
      EXPECT_EQ(side(0) * side(1), -1);
      ++edges;
    }
  EXPECT_GT(edges, 60);
}

/// A field whose layer closes inside the tet is no pair of sheets.
TEST(SheetPair, ALayerThatEndsIsRefused) {
  Random random(4);
  SignStages stages;
  for (int n = 0; n < 25; ++n) {
    const Eigen::Matrix3d basis = test::random_basis(random);
    std::array<Eigen::Matrix3d, 4> t;
    for (std::size_t i = 0; i < 4; ++i) {
      const double u = std::array{-0.11, 0.05, 0.12, 0.07}[i];
      const double upper = i < 2 ? 1e-3 : -1e-3;  // changes sign across the sheet u = 0
      Eigen::Matrix3d block;
      block << u + 1, upper, 0, -1e-3, 1 - u, 0, 0, 0, -2;
      t[i] = basis * block * basis.inverse();
    }
    OneTet tet(t);
    EXPECT_FALSE(SheetPair<4>::find(tet.cell(), stages).has_value());
  }
}

}  // namespace
}  // namespace triplex

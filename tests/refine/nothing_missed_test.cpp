// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Nothing missed: in every certified tet, the domain at each point of a dense lattice is one that
// the labels and rotations of the tet allow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "triplex/certify/edge_side.hpp"
#include "triplex/certify/simplex.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

constexpr unsigned kAllSectors = 0x3f;

/// The sectors that occur in a certified tet: those along its edges' ways around the origin, and
/// all six if the spine passes through.
unsigned allowed_sectors(const RefinedComplex& complex, const Leaf& leaf) {
  SignStages stages;
  const auto sector = [&](int i) {
    return static_cast<Sector>(complex.sectors[index(leaf.vertices[i])]);
  };
  std::array<std::array<int, 4>, 4> rotation{};
  unsigned allowed = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) {
      const int r = rotation_along(complex.field, leaf.vertices[i], leaf.vertices[j], sector(i),
                                   sector(j), standard_features(), stages)
                        .value();
      rotation[i][j] = r;
      rotation[j][i] = -r;
      for (int k = 0; k <= std::abs(r); ++k)
        allowed |=
            1u << ((index(sector(i)) + (r > 0 ? k : -k) + 2 * kStandardPages) % kStandardPages);
    }
  for (const auto& f : {std::array{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}})
    if (rotation[f[0]][f[1]] + rotation[f[1]][f[2]] + rotation[f[2]][f[0]] != 0) return kAllSectors;
  return allowed;
}

/// The sector of a tensor in doubles; nothing where rounding could matter.
std::optional<Sector> sampled_sector(const Tensor<double>& a, double size) {
  const auto f = forms_of<double, 1>({a});
  const double P = f.p[0], Q = f.q[0];
  const double p_blur = 1e-11 * size * size, q_blur = p_blur * size;
  if (std::fabs(P) < p_blur || std::fabs(Q) < q_blur) return std::nullopt;
  const auto sector = [](Domain d) { return static_cast<Sector>(d); };
  if (P > 0) return sector(Q > 0 ? Domain::InnerComplexLinear : Domain::InnerComplexPlanar);
  const double minus_d = 2 * P * P * P + 3 * Q * Q;
  const double blur = 6 * P * P * p_blur + 6 * std::fabs(Q) * q_blur;
  if (std::fabs(minus_d) < blur) return std::nullopt;
  if (Q > 0) return sector(minus_d < 0 ? Domain::RealLinear : Domain::OuterComplexLinear);
  return sector(minus_d < 0 ? Domain::RealPlanar : Domain::OuterComplexPlanar);
}

struct Sampling {
  std::size_t leaves = 0, points = 0, blurred = 0, wrong = 0;
};

Sampling sample(const RefinedComplex& complex) {
  constexpr int kSteps = 8;  // 165 points per tet
  Sampling s;
  for (const Leaf& leaf : complex.leaves) {
    if (leaf.open != 0) continue;
    ++s.leaves;
    const unsigned allowed = allowed_sectors(complex, leaf);
    std::array<Tensor<double>, 4> corner;
    double size = 0;
    for (int i = 0; i < 4; ++i) {
      corner[i] = complex.field.approximate(leaf.vertices[i]).a;
      for (const double x : corner[i]) size = std::max(size, std::fabs(x));
    }
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j)
        for (int k = 0; i + j + k <= kSteps; ++k) {
          const std::array<int, 4> n = {i, j, k, kSteps - i - j - k};
          Tensor<double> a{};
          for (int v = 0; v < 4; ++v)
            for (int e = 0; e < 9; ++e) a[e] += n[v] / double(kSteps) * corner[v][e];
          ++s.points;
          const auto sector = sampled_sector(a, size);
          s.blurred += !sector;
          s.wrong += sector && !(allowed >> index(*sector) & 1u);
        }
  }
  return s;
}

struct NamedField {
  const char* name;
  int n;
  double jitter;
};
class NothingMissedTest : public testing::TestWithParam<NamedField> {};

TEST_P(NothingMissedTest, LatticeAgreesWithTheLabels) {
  GridOptions grid;
  grid.n = GetParam().n;
  grid.jitter = GetParam().jitter;
  grid.seed = 11;
  const TensorField field = generator_named(GetParam().name)->generate(grid);
  RefineOptions options;
  options.max_bisections = 10;
  const Sampling s = sample(refine(field, options));
  EXPECT_EQ(s.wrong, 0u);
  EXPECT_GT(s.leaves, field.mesh.tets.size() / 2);
  EXPECT_LT(s.blurred, s.points / 50);
}

INSTANTIATE_TEST_SUITE_P(Fields, NothingMissedTest,
                         testing::Values(NamedField{"abc", 9, 0}, NamedField{"abc", 8, 0.1},
                                         NamedField{"lorenz", 9, 0.1},
                                         NamedField{"rayleigh-benard", 7, 0.1},
                                         NamedField{"noise", 4, 0},
                                         NamedField{"random-linear", 4, 0}));

}  // namespace
}  // namespace triplex

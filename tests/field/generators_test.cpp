// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/generators.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <set>
#include <tuple>

#include "triplex/field/input_check.hpp"

namespace triplex {
namespace {

constexpr double kPi = std::numbers::pi;

Tensor<double> deviator(Tensor<double> t) {
  const double third = (t[0] + t[4] + t[8]) / 3;
  for (int i = 0; i < 9; i += 4) t[i] -= third;
  return t;
}

double det(const Tensor<double>& a) {
  return a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
         a[2] * (a[3] * a[7] - a[4] * a[6]);
}

/// The sum of the principal 2x2 minors.
double second_invariant(const Tensor<double>& a) {
  return a[0] * a[4] - a[1] * a[3] + a[0] * a[8] - a[2] * a[6] + a[4] * a[8] - a[5] * a[7];
}

bool same_bits(const Tensor<double>& a, const Tensor<double>& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

/// FNV-1a over the bytes of points, tets and tensors.
std::uint64_t fingerprint(const TensorField& field) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  const auto add = [&](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3ull;
    }
  };
  add(field.mesh.points.data(), field.mesh.points.size() * sizeof(Point));
  add(field.mesh.tets.data(), field.mesh.tets.size() * sizeof(field.mesh.tets[0]));
  add(field.tensors.data(), field.tensors.size() * sizeof(field.tensors[0]));
  return hash;
}

// ---- closed forms ----

TEST(Generators, LorenzFollowsItsClosedForms) {
  const TensorField field = generate_lorenz({.n = 9, .jitter = 0.15, .seed = 5});
  for (std::size_t i = 0; i < field.tensors.size(); ++i) {
    const auto [x, y, z] = field.mesh.points[i];
    const Tensor<double> a = deviator(field.tensors[i]);
    const double p = x * x + 10 * z - 8179.0 / 27;
    const double q = -(49.0 / 9) * x * x - 10 * x * y + (170.0 / 9) * z - 412216.0 / 729;
    EXPECT_NEAR(second_invariant(a), p, 1e-11) << i;
    EXPECT_NEAR(det(a), q, 1e-10) << i;
  }
}

TEST(Generators, LorenzBoxHoldsNodeAndSpine) {
  const TensorField field = generate_lorenz({.n = 2});
  const Point lo = field.mesh.points.front(), hi = field.mesh.points.back();
  // The node, and a point on each branch of the spine.
  for (const double x : {0.0, 5.0, -5.0}) {
    const double w = 17.0 / 9;
    const double y = x == 0 ? 0 : (w * w * w - 22.0 / 3 * x * x) / (10 * x);
    const double z = x == 0 ? 263.0 / 9 : (8179.0 / 27 - x * x) / 10;
    EXPECT_TRUE(lo[0] < x && x < hi[0] && lo[1] < y && y < hi[1] && lo[2] < z && z < hi[2]);
    const Tensor<double> a = deviator(lorenz_gradient({x, y, z}));
    if (x == 0) {  // the double eigenvalue 17/9 has a plane of eigenvectors: A - l I has rank 1
      Tensor<double> m = a;
      for (int i = 0; i < 9; i += 4) m[i] -= w;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          const int r1 = (r + 1) % 3, c1 = (c + 1) % 3;
          EXPECT_NEAR(m[3 * r + c] * m[3 * r1 + c1] - m[3 * r + c1] * m[3 * r1 + c], 0, 1e-12);
        }
      }
    } else {
      EXPECT_NEAR(second_invariant(a), 0, 1e-11);
      EXPECT_NEAR(det(a), 0, 1e-11);
    }
  }
}

TEST(Generators, AbcFollowsItsClosedForm) {
  const AbcParameters f;
  EXPECT_EQ(f.b, std::sqrt(2.0 / 3));
  EXPECT_EQ(f.c, std::sqrt(1.0 / 3));
  const TensorField field = generate_abc({.n = 7, .jitter = 0.15});
  for (std::size_t i = 0; i < field.tensors.size(); ++i) {
    const auto [x, y, z] = field.mesh.points[i];
    const double q =
        f.a * f.b * f.c *
        (std::cos(x) * std::cos(y) * std::cos(z) - std::sin(x) * std::sin(y) * std::sin(z));
    EXPECT_NEAR(det(field.tensors[i]), q, 1e-14);
    EXPECT_EQ(field.tensors[i][0] + field.tensors[i][4] + field.tensors[i][8], 0);
  }
}

/// Where a cosine or a sine vanishes the entry is zero, not of the size of rounding.
TEST(Generators, AbcVanishesExactlyOnItsPlanesOfSymmetry) {
  for (const int n : {4, 12, 20, 28}) {
    const TensorField field = generate_abc({.n = n});
    for (const Tensor<double>& a : field.tensors)
      for (const double x : a) EXPECT_TRUE(x == 0 || std::fabs(x) > 1e-3);
  }
}

TEST(Generators, AbcIsPeriodicBitForBit) {
  for (const CellSplit split : {CellSplit::Six, CellSplit::Five}) {
    const int n = 6;
    const TensorField field = generate_abc({.n = n, .jitter = 0.2, .split = split});
    const auto id = [&](int i, int j, int k) {
      return (static_cast<std::size_t>(k) * (n + 1) + j) * (n + 1) + i;
    };
    for (int a = 0; a <= n; ++a) {
      for (int b = 0; b <= n; ++b) {
        EXPECT_TRUE(same_bits(field.tensors[id(0, a, b)], field.tensors[id(n, a, b)]));
        EXPECT_TRUE(same_bits(field.tensors[id(a, 0, b)], field.tensors[id(a, n, b)]));
        EXPECT_TRUE(same_bits(field.tensors[id(a, b, 0)], field.tensors[id(a, b, n)]));
      }
    }
  }
}

TEST(Generators, AbcCopiesOnlyWholePeriods) {
  const Box box{{0, 0, 0}, {2 * kPi, 1, 1}};
  const TensorField field = generate_abc({.n = 1, .box = box});
  EXPECT_TRUE(same_bits(field.tensors[0], field.tensors[1]));
  EXPECT_FALSE(same_bits(field.tensors[0], field.tensors[2]));
  EXPECT_FALSE(same_bits(field.tensors[0], field.tensors[4]));
}

TEST(Generators, RayleighBenardGradientIsThatOfTheVelocity) {
  const double h = 0x1p-18;
  for (const auto& f : {RayleighBenardParameters{}, RayleighBenardParameters{0.3, -0.7}}) {
    const TensorField mesh = generate_rayleigh_benard({.n = 4, .jitter = 0.15});
    for (const Point& x : mesh.mesh.points) {
      const Tensor<double> t = rayleigh_benard_gradient(x, f);
      for (int j = 0; j < 3; ++j) {
        Point up = x, down = x;
        up[j] += h;
        down[j] -= h;
        const Point u = rayleigh_benard_velocity(up, f), d = rayleigh_benard_velocity(down, f);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(t[3 * i + j], (u[i] - d[i]) / (2 * h), 1e-8);
      }
      EXPECT_NEAR(t[0] + t[4] + t[8], 0, 1e-14);
      const RayleighBenardParameters no_swirl{f.modulation, 0};
      const Tensor<double> s = rayleigh_benard_gradient(x, no_swirl);
      EXPECT_NEAR(s[3] - s[1], 0, 1e-14) << "vertical vorticity";
    }
  }
}

/// Planes of symmetry at multiples of a quarter period: what does not couple there is exactly zero.
TEST(Generators, GradientsAreThoseOfTheirVelocities) {
  for (const GeneratorRow& row : generator_table()) {
    if (row.velocity == nullptr) continue;
    SCOPED_TRACE(row.name);
    const TensorField field = row.generate({.n = 3});
    for (std::size_t k = 0; k < field.mesh.points.size(); ++k) {
      for (std::size_t j = 0; j < 3; ++j) {
        Point ahead = field.mesh.points[k], behind = ahead;
        const double step = 1e-5;
        ahead[j] += step;
        behind[j] -= step;
        const Point a = row.velocity(ahead), b = row.velocity(behind);
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR((a[i] - b[i]) / (2 * step), field.tensors[k][3 * i + j], 1e-7);
      }
    }
  }
  EXPECT_NE(generator_named("abc")->velocity, nullptr);
  EXPECT_EQ(generator_named("noise")->velocity, nullptr);
}

TEST(Generators, PlanesOfSymmetryAreExact) {
  for (int k = -8; k <= 8; ++k) {
    const double at = k / 2.0;
    const bool whole = k % 2 == 0;
    const Point other{0.3, 0.7, 0.4};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Point x = other;
      x[axis] = at;
      const Point u = rayleigh_benard_velocity(x);
      const Tensor<double> t = rayleigh_benard_gradient(x);
      if (whole) {  // nothing couples the normal direction to the plane
        EXPECT_EQ(u[axis], 0) << k;
        for (std::size_t i = 0; i < 3; ++i) {
          if (i == axis) continue;
          EXPECT_EQ(t[3 * axis + i], 0) << k;
          EXPECT_EQ(t[3 * i + axis], 0) << k;
        }
      }
    }
  }
}

/// Mirrored in x = 1, and turned around the line x = 1, z = 1/2, which reverses time: to the bit,
/// on a grid whose spacing is no double.
TEST(Generators, RayleighBenardIsSymmetricInItsRoundings) {
  constexpr int n = 11;
  const TensorField field = generate_rayleigh_benard({.n = n});
  const auto at = [&](int i, int j, int k) {
    return static_cast<std::size_t>((k * (n + 1) + j) * (n + 1) + i);
  };
  constexpr std::array<double, 3> kMirror = {-1, 1, 1}, kTurn = {-1, 1, -1};
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const auto &x = field.mesh.points[at(i, j, k)], &y = field.mesh.points[at(n - i, j, n - k)];
        EXPECT_EQ(x[0] + y[0], 2);
        EXPECT_EQ(x[2] + y[2], 1);
        const Tensor<double>&t = field.tensors[at(i, j, k)],
              &mirrored = field.tensors[at(n - i, j, k)],
              &turned = field.tensors[at(n - i, j, n - k)];
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_EQ(mirrored[3 * r + c], kMirror[r] * kMirror[c] * t[3 * r + c]);
            EXPECT_EQ(turned[3 * r + c], -kTurn[r] * kTurn[c] * t[3 * r + c]);
          }
      }
}

TEST(Generators, RayleighBenardStaysInItsBox) {
  const TensorField field = generate_rayleigh_benard({.n = 5});
  const Point hi{2, 1, 1};
  EXPECT_EQ(field.mesh.points.back(), hi);
  for (const Point& x : field.mesh.points) {
    const Point u = rayleigh_benard_velocity(x);
    for (int k = 0; k < 3; ++k) {
      if (x[k] == 0 || x[k] == hi[k]) {
        EXPECT_EQ(u[k], 0);
      }
    }
  }
  // Two cells: up at both ends, down in the middle.
  EXPECT_GT(rayleigh_benard_velocity({0, 0.5, 0.5})[2], 0.5);
  EXPECT_LT(rayleigh_benard_velocity({1, 0.5, 0.5})[2], -0.5);
  EXPECT_GT(rayleigh_benard_velocity({2, 0.5, 0.5})[2], 0.5);
}

TEST(Generators, RandomLinearIsExactlyLinearOnEveryDyadicGrid) {
  for (const std::uint64_t seed : {1u, 2u, 99u}) {
    // The coefficients from the corners of the box [-1,1]^3: exact, as all numbers are short.
    const TensorField coarse = generate_random_linear({.n = 1, .seed = seed});
    for (const int n : {4, 16}) {
      const TensorField fine = generate_random_linear({.n = n, .jitter = 0.15, .seed = seed});
      for (std::size_t v = 0; v < fine.tensors.size(); ++v) {
        const Point& x = fine.mesh.points[v];
        for (int i = 0; i < 9; ++i) {
          const double origin = coarse.tensors[0][i];
          double value = origin;
          for (int k = 0; k < 3; ++k) {
            value += (coarse.tensors[std::size_t{1} << k][i] - origin) / 2 * (x[k] + 1);
          }
          EXPECT_EQ(fine.tensors[v][i], value);
        }
      }
    }
  }
  EXPECT_NE(generate_random_linear({.n = 1, .seed = 1}).tensors,
            generate_random_linear({.n = 1, .seed = 2}).tensors);
}

TEST(Generators, SymmetricIsExactlySymmetricAndLinear) {
  const TensorField field = generate_symmetric({.n = 4, .jitter = 0.2, .seed = 3});
  const TensorField corners = generate_symmetric({.n = 1, .seed = 3});
  std::set<double> values;
  for (const auto& t : field.tensors) {
    values.insert(t.begin(), t.end());
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < i; ++j) EXPECT_EQ(t[3 * i + j], t[3 * j + i]);
    }
  }
  EXPECT_GT(values.size(), 5 * field.tensors.size());  // six per tensor, but for chance
  for (int i = 0; i < 9; ++i) {  // the middle of the box has the mean of its corners
    double sum = 0;
    for (const auto& t : corners.tensors) sum += t[i];
    EXPECT_EQ(generate_symmetric({.n = 2, .seed = 3}).tensors[13][i], sum / 8);
  }
}

TEST(Generators, ConstantIsTheGivenTensorEverywhere) {
  const Tensor<double> tensor{0.1, -2, 3, 1e300, 0x1p-1074, 6, 7, 8, -9};
  for (const CellSplit split : {CellSplit::Six, CellSplit::Five}) {
    for (const auto& t :
         generate_constant({.n = 3, .jitter = 0.1, .split = split}, tensor).tensors) {
      EXPECT_EQ(t, tensor);
    }
  }
  for (const auto& t : generate_constant({.n = 2}).tensors) EXPECT_EQ(t, kDefaultConstantTensor);
  EXPECT_NE(det(kDefaultConstantTensor), 0);
  Tensor<double> bad = tensor;
  bad[4] = std::nan("");
  EXPECT_THROW(generate_constant({.n = 2}, bad), BadInput);
}

TEST(Generators, NoiseIsIndependentAndInRange) {
  const TensorField field = generate_noise({.n = 10});
  std::set<double> values;
  double sum = 0, largest = 0;
  for (const auto& t : field.tensors) {
    for (const double x : t) {
      values.insert(x);
      sum += x;
      largest = std::fmax(largest, std::fabs(x));
    }
  }
  EXPECT_EQ(values.size(), 9 * field.tensors.size());
  EXPECT_LT(std::fabs(sum) / static_cast<double>(values.size()), 0.02);
  EXPECT_LE(largest, 1);
  EXPECT_GT(largest, 0.99);
}

// ---- all of them ----

TEST(Generators, AllPassTheInputCheck) {
  EXPECT_EQ(generator_table().size(), 7u);
  for (const GeneratorRow& row : generator_table()) {
    for (const CellSplit split : {CellSplit::Six, CellSplit::Five}) {
      for (const double jitter : {0.0, 0.11}) {
        const TensorField field = row.generate({.n = 7, .jitter = jitter, .split = split});
        EXPECT_NO_THROW(check_input(field)) << row.name;
        EXPECT_EQ(field.array_name, "tensor");
      }
    }
    EXPECT_EQ(generator_named(row.name), &row);
  }
  EXPECT_EQ(generator_named("lorentz"), nullptr);
}

TEST(Generators, SameSeedSameBits) {
  const GridOptions options{.n = 6, .jitter = 0.15, .seed = 7};
  // Integer arithmetic and exact scaling only: these numbers hold on every machine.
  EXPECT_EQ(fingerprint(generate_noise(options)), 511577311614853510u);
  EXPECT_EQ(fingerprint(generate_random_linear(options)), 1584639123906069917u);
  for (const GeneratorRow& row : generator_table()) {
    EXPECT_EQ(fingerprint(row.generate(options)), fingerprint(row.generate(options)));
    GridOptions other = options;
    other.seed = 8;
    EXPECT_NE(fingerprint(row.generate(options)), fingerprint(row.generate(other)));
  }
}

}  // namespace
}  // namespace triplex

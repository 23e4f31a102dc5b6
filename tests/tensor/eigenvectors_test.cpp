// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenvectors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <numeric>

#include "../oracle/eigenvector_oracle.hpp"
#include "triplex/tensor/eigenspace.hpp"

namespace triplex {
namespace {

using oracle::Random;
using oracle::sine;

constexpr double kResidual = 0x1p-40;
constexpr double kExactResidual = 0x1p-49;  // where exact arithmetic finds the vectors

bool is_none(const Direction& v) {
  return std::isnan(v[0]) && std::isnan(v[1]) && std::isnan(v[2]);
}

double norm(const Direction& v) { return oracle::vector(v).norm(); }
double dot(const Direction& a, const Direction& b) {
  return oracle::vector(a).dot(oracle::vector(b));
}

// The contract, in exact arithmetic.
void expect_contract(const Tensor<double>& t) {
  const oracle::RationalInvariants exact = oracle::rational_invariants(t);
  const Eigenvectors e = eigenvectors(t);
  ASSERT_EQ(e.all_real, exact.d >= 0);
  const Tensor<mpq_class> a = oracle::rational_deviator(t);
  const std::array<mpq_class, 3> l = oracle::real_eigenvalues(t);
  const bool is_zero = oracle::sum_of_squares(a) == 0;
  const int dimension = oracle::repeating_dimension(t);
  for (int k = 0; k < 3; ++k) {
    if (!e.all_real && k > 0) {
      ASSERT_TRUE(is_none(e.vectors[k]));
      ASSERT_EQ(e.dimensions[k], 0);
      continue;
    }
    const bool repeats =
        dimension > 0 && ((k > 0 && l[k] == l[k - 1]) || (k < 2 && l[k] == l[k + 1]));
    ASSERT_EQ(e.dimensions[k], repeats ? dimension : 1);
    ASSERT_NEAR(norm(e.vectors[k]), 1, 1e-15);
    ASSERT_EQ(with_fixed_sign(e.vectors[k]), e.vectors[k]);
    if (is_zero) continue;
    ASSERT_LE(oracle::relative_residual(a, e.vectors[k], l[k]),
              dimension > 0 ? kExactResidual : kResidual);
  }
  for (int k = 0; k < 2 && e.all_real; ++k) {
    if (l[k] != l[k + 1] || dimension == 0) continue;
    if (dimension == 1) {
      ASSERT_EQ(e.vectors[k], e.vectors[k + 1]);
    }
    if (dimension == 3 || (dimension == 2 && exact.p != 0) || (dimension == 2 && k == 0)) {
      ASSERT_NEAR(dot(e.vectors[k], e.vectors[k + 1]), 0, 1e-15);
    }
  }
}

TEST(Eigenvectors, ContractInExactArithmetic) {
  Random random(1);
  for (int n = 0; n < 6000; ++n) {
    const Tensor<double> t = oracle::tensor_of_any_kind(random, n);
    ASSERT_NO_FATAL_FAILURE(expect_contract(t)) << n;
    if (n % 4 == 0) {
      for (const int k : {-1040, -300, 300, 990}) {
        ASSERT_NO_FATAL_FAILURE(expect_contract(oracle::scaled(t, k))) << n << ' ' << k;
      }
    }
  }
}

TEST(Eigenvectors, TinyDeviatorUnderAHugeTrace) {
  for (const double mean : {1.0, 1e300}) {
    for (const double size : {0x1p-1074, 1e-310, 1e-200}) {
      ASSERT_NO_FATAL_FAILURE(expect_contract({mean, size, 0, size, mean, 0, 0, 0, mean}));
      const Eigenvectors e = eigenvectors({mean, size, 0, size, mean, 0, 0, 0, mean});
      EXPECT_LT(sine(e.vectors[0], {1, 1, 0}), 1e-15);
      EXPECT_LT(sine(e.vectors[1], {0, 0, 1}), 1e-15);
      EXPECT_LT(sine(e.vectors[2], {1, -1, 0}), 1e-15);
    }
  }
}

// Eigen's vectors are as good as its backward error over the separation.
TEST(Eigenvectors, AgreeWithEigen) {
  Random random(2);
  int real = 0;
  for (int n = 0; n < 5000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const Eigen::EigenSolver<Eigen::Matrix3d> solver(oracle::matrix(t));
    std::array<int, 3> order = {0, 1, 2};
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      return solver.eigenvalues()[i].real() > solver.eigenvalues()[j].real();
    });
    const Eigenvectors e = eigenvectors(t);
    const Eigenvalues l = eigenvalues(t);
    if (!e.all_real) {
      std::stable_partition(order.begin(), order.end(),
                            [&](int i) { return solver.eigenvalues()[i].imag() == 0; });
    }
    real += static_cast<int>(e.all_real);
    for (int k = 0; k < (e.all_real ? 3 : 1); ++k) {
      const Eigen::Vector3d v = solver.eigenvectors().col(order[k]).real();
      ASSERT_LE(sine(e.vectors[k], {v[0], v[1], v[2]}), 1e-12 / oracle::separation(t, l.real[k]));
    }
  }
  EXPECT_GT(real, 500);
  EXPECT_LT(real, 4500);
}

TEST(Eigenvectors, SymmetricTensorsHaveOrthogonalOnes) {
  Random random(3);
  for (int n = 0; n < 3000; ++n) {
    Tensor<double> t = oracle::degenerate_tensor(random, oracle::Kind::Symmetric);
    if (n % 2 == 0) {  // eigenvalues that agree to within a few roundings
      const Tensor<double> r = oracle::random_rotation(random);
      t = oracle::rotated(r, {1 + std::ldexp(n % 5, -52), 0, 0, 0, 1, 0, 0, 0, -2});
      t[3] = t[1];
      t[6] = t[2];
      t[7] = t[5];
    }
    const Eigenvectors e = eigenvectors(t);
    ASSERT_TRUE(e.all_real);
    if (repeating_eigenspace_dimension(t) == 3) continue;
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(dot(e.vectors[k], e.vectors[(k + 1) % 3]), 0, 1e-14);
    }
    ASSERT_NO_FATAL_FAILURE(expect_contract(t));
  }
}

// T^T has the left eigenvectors: orthogonal to the right ones of the other eigenvalues. -T has the
// same vectors in reverse order; 2^k T the same bits; R T R^T turns them.
TEST(Eigenvectors, Laws) {
  Random random(4);
  for (int n = 0; n < 2000; ++n) {
    const Tensor<double> t = oracle::double_tensor(random);
    const Eigenvectors e = eigenvectors(t);
    const Eigenvalues l = eigenvalues(t);
    const Eigenvectors left = eigenvectors(oracle::transposed(t));
    const Eigenvectors negated = eigenvectors(oracle::negated(t));
    const Tensor<double> r = oracle::random_rotation(random);
    const Eigenvectors turned = eigenvectors(oracle::rotated(r, t));
    ASSERT_EQ(eigenvectors(oracle::scaled(t, 700)).vectors[0], e.vectors[0]);
    ASSERT_EQ(eigenvectors(oracle::scaled(t, -700)).vectors[0], e.vectors[0]);
    const int count = e.all_real ? 3 : 1;
    for (int i = 0; i < count; ++i) {
      const double tolerance = 1e-11 / oracle::separation(t, l.real[i]);
      ASSERT_LE(sine(negated.vectors[count - 1 - i], e.vectors[i]), tolerance);
      if (turned.all_real == e.all_real) {
        ASSERT_LE(sine(turned.vectors[i], oracle::rotated(r, e.vectors[i])), tolerance);
      }
      for (int j = 0; j < count; ++j) {
        if (i == j) continue;
        ASSERT_LE(std::fabs(dot(e.vectors[i], left.vectors[j])),
                  tolerance + 1e-11 / oracle::separation(t, l.real[j]));
      }
    }
  }
}

TEST(Eigenvectors, KnownOnes) {
  // A Jordan block of eigenvalue -1 under 2: (1, 0, 0) and twice (0, 1, 0).
  const Eigenvectors jordan = eigenvectors({2, 0, 0, 0, -1, 1, 0, 0, -1});
  EXPECT_EQ(jordan.vectors[0], (Direction{1, 0, 0}));
  EXPECT_EQ(jordan.vectors[1], (Direction{0, 1, 0}));
  EXPECT_EQ(jordan.dimensions, (std::array{1, 1, 1}));
  // A node whose eigenspace is orthogonal to (1, 1, 1): I - x n^T with x = (3, 0, 0).
  const Eigenvectors node = eigenvectors({-2, -3, -3, 0, 1, 0, 0, 0, 1});
  EXPECT_EQ(node.dimensions, (std::array{2, 2, 1}));
  for (const int k : {0, 1}) EXPECT_NEAR(dot(node.vectors[k], {1, 1, 1}), 0, 1e-15);
  EXPECT_EQ(node.vectors[2], (Direction{1, 0, 0}));
  // x y^T with x = (1, 1, 0), y = (1, -1, 0): the directions of x and of x cross y.
  const Eigenvectors flat = eigenvectors({1, -1, 0, 1, -1, 0, 0, 0, 0});
  EXPECT_EQ(flat.dimensions, (std::array{2, 2, 2}));
  EXPECT_LT(sine(flat.vectors[0], {1, 1, 0}), 1e-15);
  EXPECT_EQ(flat.vectors[1], (Direction{0, 0, 1}));
  EXPECT_EQ(flat.vectors[2], (Direction{0, 0, 1}));
  const Eigenvectors identity = eigenvectors({3, 0, 0, 0, 3, 0, 0, 0, 3});
  EXPECT_EQ(identity.dimensions, (std::array{3, 3, 3}));
  EXPECT_EQ(identity.vectors[1], (Direction{0, 1, 0}));
  EXPECT_EQ(eigenvectors({0, 2, 0, -1, 0, 0, 0, 0, 5}).vectors[0], (Direction{0, 0, 1}));
}

TEST(Eigenvectors, SignRule) {
  EXPECT_EQ(with_fixed_sign({-0.6, 0.8, 0}), (Direction{-0.6, 0.8, 0}));
  EXPECT_EQ(with_fixed_sign({0.6, -0.8, 0}), (Direction{-0.6, 0.8, 0}));
  EXPECT_EQ(with_fixed_sign({-0.7, std::nextafter(0.7, 1), 0}),
            (Direction{0.7, -std::nextafter(0.7, 1), 0}));
  EXPECT_FALSE(std::signbit(with_fixed_sign({-1, 0.0, -0.0})[1]));
}

}  // namespace
}  // namespace triplex

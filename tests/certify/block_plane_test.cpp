// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Planes where the tensor is exactly block triangular: what is claimed on them and beside them is
// held against exact signs of D.
#include "triplex/certify/block_plane.hpp"

#include <gtest/gtest.h>

#include <random>

#include "triplex/certify/node.hpp"

namespace triplex {
namespace {

constexpr int kAxis = 2;
enum class Kind { Column, Row, Both };

void make_block(Tensor<double>& t, Kind kind) {
  if (kind != Kind::Row) t[2] = t[5] = 0;
  if (kind != Kind::Column) t[6] = t[7] = 0;
}

/// A tet whose first three tensors are block triangular along z.
TensorField random_tet(std::mt19937_64& random, Kind kind, double spread) {
  std::normal_distribution<double> normal;
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  Tensor<double> base;
  for (double& x : base) x = normal(random);
  base[0] = base[8] + spread * normal(random);  // an eigenvalue near that of the axis
  base[1] = 0;
  if (kind != Kind::Row) base[2] = base[5] = 0;
  if (kind != Kind::Column) base[6] = base[7] = 0;
  for (int i = 0; i < 4; ++i) {
    Tensor<double> t = base;
    for (double& x : t) x += spread * normal(random);
    if (i < 3) make_block(t, kind);
    field.tensors.push_back(t);
  }
  return field;
}

/// The sign of D at a combination of vertices with integer weights.
Sign sign_of_d(const RefinableField& field, const std::array<VertexId, 4>& v,
               const std::array<int, 4>& weights) {
  Tensor<Exact> a;
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor<Exact> t = field.exact(v[i]);
    for (std::size_t k = 0; k < 9; ++k) a[k] = a[k] + Exact(weights[i]) * t[k];
  }
  const auto f = forms_of<Exact, 1>({a});
  return -sign(Exact(2) * f.p[0] * f.p[0] * f.p[0] + Exact(3) * f.q[0] * f.q[0]);
}

/// The vertices of the first three tensors, then the last: by position.
std::array<VertexId, 4> in_order(const RefinableField& field) {
  const auto vertex = field.vertices_of_input();
  return {vertex[0], vertex[1], vertex[2], vertex[3]};
}

TEST(BlockPlane, FindsTheAxisOfItsVerticesOnly) {
  std::mt19937_64 random(7);
  for (const Kind kind : {Kind::Column, Kind::Row, Kind::Both}) {
    const TensorField input = random_tet(random, kind, 0.5);
    const RefinableField field(input);
    const auto v = in_order(field);
    EXPECT_EQ(Simplex<3>(field, {v[0], v[1], v[2]}).block_axis(), kAxis);
    EXPECT_EQ(Simplex<2>(field, {v[0], v[3]}).block_axis(), -1);
    const unsigned column = 1u << kAxis, row = 8u << kAxis;
    EXPECT_EQ(field.zero_couplings(v[1]), kind == Kind::Column ? column
                                          : kind == Kind::Row  ? row
                                                               : column | row);
    EXPECT_EQ(field.zero_couplings(v[3]), 0u);
  }
}

TEST(BlockPlane, ACertifiedEdgeIsCrossedAtMostOnce) {
  std::mt19937_64 random(20261122);
  SignStages stages;
  int certified = 0, crossed = 0, refused = 0;
  for (int n = 0; n < 3000; ++n) {
    const TensorField input = random_tet(random, static_cast<Kind>(n % 3), n % 2 == 0 ? 2 : 0.2);
    const RefinableField field(input);
    const auto v = in_order(field);
    const bool claimed = certifies_block(Simplex<2>(field, {v[0], v[1]}), stages);
    int changes = 0;
    Sign last = Sign::Zero;
    constexpr int kSteps = 64;
    for (int k = 0; k <= kSteps; ++k) {
      const Sign s = sign_of_d(field, v, {kSteps - k, k, 0, 0});
      if (s == Sign::Zero) continue;
      changes += last != Sign::Zero && s != last;
      last = s;
    }
    if (claimed) {
      EXPECT_LE(changes, 1) << n;
    }
    (claimed ? certified : refused) += 1;
    crossed += claimed && changes == 1;
  }
  EXPECT_GT(certified, 1500);
  EXPECT_GT(crossed, 200);
  EXPECT_GT(refused, 50);
}

/// disc(M) = 4 (x^2 + y^2 - r^2) around a point inside: real at all three corners.
TEST(BlockPlane, ARegionInsideAFaceIsNotOverlooked) {
  TensorField input;
  input.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  const double r = 0.125;
  for (const Point& at : input.mesh.points) {
    const double x = at[0] - 0.375, y = at[1] - 0.375;
    input.tensors.push_back({x, y - r, 0, y + r, -x, 0, 0, 0, 5});
  }
  const RefinableField field(input);
  const auto v = in_order(field);
  SignStages stages;
  EXPECT_EQ(sign_of_d(field, v, {1, 0, 0, 0}), Sign::Positive);
  EXPECT_EQ(sign_of_d(field, v, {2, 3, 3, 0}), Sign::Negative);
  EXPECT_FALSE(certifies_block(Simplex<3>(field, {v[0], v[1], v[2]}), stages));
}

TEST(BlockPlane, BesideIsRealWhereClaimed) {
  std::mt19937_64 random(31);
  SignStages stages;
  int certified = 0, refused = 0;
  for (int n = 0; n < 3000; ++n) {
    const TensorField input = random_tet(random, static_cast<Kind>(n % 3), 0.05);
    const RefinableField field(input);
    const auto v = in_order(field);
    auto sorted = v;
    std::ranges::sort(sorted);
    if (!certifies_real_off_block(Simplex<4>(field, sorted), stages)) {
      refused += 1;
      continue;
    }
    certified += 1;
    for (int k = 0; k < 60; ++k) {
      const auto weight = [&] { return static_cast<int>(random() % 9); };
      const std::array<int, 4> w = {weight(), weight(), weight(), 1 + weight() % 4};
      EXPECT_EQ(sign_of_d(field, v, w), Sign::Positive) << n;
    }
  }
  EXPECT_GT(certified, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace triplex

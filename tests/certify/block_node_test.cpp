// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/block_node.hpp"

#include <gtest/gtest.h>

#include "../oracle/one_tet.hpp"
#include "../oracle/random_tensors.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {
namespace {

constexpr std::array kFace = {VertexId(0), VertexId(1), VertexId(2)};

/// Integer tensors on a face, block triangular along z, with a node where all vertices weigh the
/// same: the middle tensor is a node, and the three add up to three times it.
TensorField with_node_in_face(oracle::Random& random, bool column) {
  std::array<Tensor<double>, 4> t;
  const double l = oracle::integer(random, 4), x = oracle::integer(random, 4);
  // M - l I = u v^T; the coupling is a multiple of v^T (of u).
  const double u0 = oracle::integer(random, 3) + 4, u1 = oracle::integer(random, 3);
  const double v0 = oracle::integer(random, 3), v1 = oracle::integer(random, 3) + 4;
  Tensor<double> node = {l + u0 * v0, u0 * v1, 0, u1 * v0, l + u1 * v1, 0, 0, 0, l};
  if (column) {
    node[6] = x * v0, node[7] = x * v1;
  } else {
    node[2] = x * u0, node[5] = x * u1;
  }
  Tensor<double> rest;
  for (std::size_t k = 0; k < 9; ++k) rest[k] = 3 * node[k];
  for (std::size_t i = 0; i < 4; ++i) {
    t[i] = oracle::integer_tensor(random, 9);
    if (i == 3) continue;
    if (column) t[i][2] = t[i][5] = 0;
    if (!column) t[i][6] = t[i][7] = 0;
    if (i == 2) t[i] = rest;
    for (std::size_t k = 0; k < 9; ++k) rest[k] -= t[i][k];
  }
  return oracle::on_one_tet(t);
}

TEST(BlockNode, IsNeverExcluded) {
  oracle::Random random(11);
  SignStages stages;
  int nodes = 0;
  for (int n = 0; n < 2000; ++n) {
    const TensorField input = with_node_in_face(random, n % 2 == 0);
    const RefinableField field(input);
    Tensor<Exact> sum;
    for (const VertexId v : kFace) {
      const Tensor<Exact> a = field.exact(v);
      for (std::size_t k = 0; k < 9; ++k) sum[k] = sum[k] + a[k];
    }
    if (!is_node(sum)) continue;  // the third eigenvalue agrees as well
    ++nodes;
    const Simplex<3> face(field, kFace);
    ASSERT_GE(face.block_axis(), 0);
    EXPECT_FALSE(excludes_block_node(face, face.block_axis(), stages));
  }
  EXPECT_GT(nodes, 1500);
}

TEST(BlockNode, IsExcludedOnMostFacesWithoutOne) {
  oracle::Random random(12);
  SignStages stages;
  int excluded = 0;
  for (int n = 0; n < 1000; ++n) {
    const Tensor<double> centre = oracle::double_tensor(random);
    std::array<Tensor<double>, 4> t;
    for (auto& a : t) {
      a = oracle::double_tensor(random);
      for (std::size_t k = 0; k < 9; ++k) a[k] = centre[k] + 0.1 * a[k];
      a[2] = a[5] = 0;
    }
    const TensorField input = oracle::on_one_tet(t);
    const RefinableField field(input);
    const Simplex<3> face(field, kFace);
    excluded += excludes_block_node(face, face.block_axis(), stages);
  }
  EXPECT_GT(excluded, 800);
}

/// As on the axis of the Lorenz system: along an edge both couplings vanish and chi is linear.
TEST(BlockNode, RationalOnesAreFoundExactly) {
  oracle::Random random(13);
  int found = 0;
  for (int n = 0; n < 300; ++n) {
    const double s = oracle::integer(random, 9) + 10.5, e = oracle::double_tensor(random)[0];
    std::array<Tensor<double>, 4> t;
    for (std::size_t i = 0; i < 4; ++i) {
      const double x = i < 2 ? 0 : oracle::integer(random, 5);
      t[i] = {-s, s, 0, 20 * oracle::double_tensor(random)[0], -1, -x, x, x, e};
    }
    const TensorField input = oracle::on_one_tet(t);
    const RefinableField field(input);
    const auto check = [&](const auto& nodes, std::span<const VertexId> vertices) {
      for (const auto& w : nodes) {
        ++found;
        Tensor<Exact> sum;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
          EXPECT_EQ(sign(w[i]), Sign::Positive);
          const Tensor<Exact> a = field.exact(vertices[i]);
          for (std::size_t k = 0; k < 9; ++k) sum[k] = sum[k] + w[i] * a[k];
        }
        EXPECT_TRUE(is_node(sum));
      }
    };
    const std::array edge = {VertexId(0), VertexId(1)};
    check(rational_block_nodes(Simplex<2>(field, edge)), edge);
    const std::array face = {VertexId(0), VertexId(2), VertexId(3)};
    check(rational_block_nodes(Simplex<3>(field, face)), face);
  }
  EXPECT_GT(found, 60);
}

}  // namespace
}  // namespace triplex

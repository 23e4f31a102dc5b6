// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/block_node.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

/// What is known of a node before it is looked for on faces: near the given place, and near the
/// face of the first three vertices. `eigenvalue` is that of the scaled, tripled deviator.
IsolatedNode near_the_face(const std::array<double, 3>& weights, double eigenvalue) {
  const auto around = [](double x, double by) { return Range{x - by, x + by}; };
  IsolatedNode node;
  node.first = around(weights[0], 0x1p-40);
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = k < 2 ? weights[k + 1] : 0;
    node.box[k] = around(x, 0x1p-40);
    node.domain[k] = around(x, 0x1p-10);
  }
  node.box[3] = around(eigenvalue, 0x1p-40);
  node.domain[3] = around(eigenvalue, 0x1p-10);
  return node;
}

/// In the face, and in its plane beyond one of its edges, which is no place in the tet.
TEST(BlockNode, IsProvenToLieInsideTheFaceOnly) {
  oracle::Random random(14);
  int inside = 0, nodes = 0;
  for (int n = 0; n < 400; ++n) {
    const bool column = n % 2 == 0, beyond = n % 4 < 2;
    TensorField input = with_node_in_face(random, column);
    // The middle tensor weighs as before, now with a third corner that has the weight -1/5.
    if (beyond)
      for (std::size_t k = 0; k < 9; ++k) {
        const double sum = input.tensors[0][k] + input.tensors[1][k] + input.tensors[2][k];
        input.tensors[2][k] = 3 * input.tensors[0][k] + 3 * input.tensors[1][k] - 5 * (sum / 3);
      }
    const RefinableField field(input);
    const std::array<double, 3> weights =
        beyond ? std::array{0.6, 0.6, -0.2} : std::array{1 / 3.0, 1 / 3.0, 1 / 3.0};
    Tensor<double> there{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 9; ++k) there[k] += weights[i] * input.tensors[i][k];
    const double eigenvalue =
        std::ldexp(2 * there[8] - there[0] - there[4], field.scale_exponent());
    if (std::fabs(eigenvalue) < 0x1p-8) continue;
    ++nodes;
    const auto face = block_face_of(field, {kFace[0], kFace[1], kFace[2], VertexId(3)},
                                    near_the_face(weights, eigenvalue));
    if (beyond) {
      EXPECT_FALSE(face.has_value());
    } else if (face) {
      EXPECT_EQ(*face, kFace);
      ++inside;
    }
  }
  EXPECT_GT(inside, nodes / 4);
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

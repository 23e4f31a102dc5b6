// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificates around a node that has become a vertex, held against sampling along its rays.
#include "triplex/certify/star.hpp"

#include <gtest/gtest.h>

#include "../oracle/block_fields.hpp"
#include "triplex/certify/block_plane.hpp"
#include "triplex/certify/nappe.hpp"

namespace triplex {
namespace {

using test::OneTet;
using test::Random;
using test::uniform;
using test::Wide;

/// A tet with a node inside that is a vertex, number 4, known up to about rounding.
struct Star {
  Star(const std::array<Eigen::Matrix3d, 4>& tensors, const test::Weights& where)
      : tet(tensors), node(tet.field().add_node(OneTet::kVertices, where, 1e-14)), at(where) {}

  const RefinableField& field() { return tet.field(); }
  OneTet tet;
  VertexId node;
  test::Weights at;
};

/// The signs of D seen on a simplex with the node at corner 0, at many points, also close to the
/// node but not so close that its own rounding counts.
template <std::size_t N>
std::array<bool, 3> signs_off_node(Star& star, const std::array<VertexId, N>& others,
                                   Random& random, int samples) {
  std::array<bool, 3> seen{};
  for (int n = 0; n < samples; ++n) {
    const auto any = test::random_weights(random, N);
    const double radius = std::exp2(-uniform(random, 0, 12));
    std::array<Wide, 4> w;
    for (std::size_t i = 0; i < 4; ++i) w[i] = static_cast<Wide>((1 - radius) * star.at[i]);
    for (std::size_t i = 0; i < N; ++i) w[index(others[i])] += static_cast<Wide>(radius * any[i]);
    seen[1 + test::sign_of(test::discriminant(star.field(), OneTet::kVertices, w))] = true;
  }
  return seen;
}

template <std::size_t N>
bool only_node(Star& star, const std::array<VertexId, N>& others, SignStages& stages) {
  std::array<VertexId, N + 1> v;
  std::copy(others.begin(), others.end(), v.begin());
  v[N] = star.node;
  return certifies_only_node(Simplex<N + 1>(star.field(), v), stages);
}

constexpr std::array<VertexId, 4> V = OneTet::kVertices;
constexpr test::Weights kNode = {0.3, 0.2, 0.1, 0.4};

TEST(OnlyNode, LeavesOneSignElsewhere) {
  Random random(1);
  SignStages stages;
  std::array<int, 4> certified{}, refused{};
  for (int n = 0; n < 300; ++n) {
    Star star(test::planted_node(random, kNode, std::exp2(-1.0 - n % 8)), kNode);
    const auto check = [&](const auto& others) {
      constexpr std::size_t kOthers = std::tuple_size_v<std::remove_cvref_t<decltype(others)>>;
      const bool yes = only_node(star, others, stages);
      const auto seen = signs_off_node(star, others, random, 100);
      if (yes) {
        EXPECT_FALSE(seen[0] && seen[2]) << n;
      }
      ++(yes ? certified : refused)[kOthers];
    };
    check(std::array{V[0]});
    check(std::array{V[1]});
    check(std::array{V[0], V[1]});
    check(std::array{V[2], V[3]});
    check(std::array{V[0], V[1], V[2]});
  }
  EXPECT_GT(certified[1], 500);
  EXPECT_GT(refused[1], 0);
  for (const std::size_t k : {2u, 3u}) {
    EXPECT_GT(certified[k], k == 2 ? 100 : 3);
    EXPECT_GT(refused[k], 50);
  }
}

/// Where a tet is ready and its edges and faces at the node are certified, every ray keeps one
/// sign, and on the faces at the node the surface is one arc to the opposite edge or nothing, as
/// the signs at its ends say.
/// All of an edge between nodes of one eigenplane is degenerate: no sign of T + eps B says
/// otherwise.
TEST(OnlyNode, AnEdgeOfNodesIsRefused) {
  TensorField input;
  input.mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  input.tensors = {{1, 0, 0, 0, 1, 0, 0, 0, -2},
                   {2, 0, 0, 0, 2, 0, 0, 0, -4},
                   {1, 2, 0, 0, 3, 1, 1, 0, 1},
                   {0, 1, 1, 2, 0, 1, 0, 3, 1}};
  RefinableField field(input);
  const auto vertex = field.vertices_of_input();
  for (const int v : {0, 1}) field.declare_node(vertex[v]);
  SignStages stages;
  const Simplex<2> edge(field, {std::min(vertex[0], vertex[1]), std::max(vertex[0], vertex[1])});
  EXPECT_FALSE(certifies_only_node(edge, stages));
  ASSERT_GE(edge.block_axis(), 0);
  EXPECT_FALSE(certifies_block(edge, stages));
}

TEST(Star, EdgesAndFacesAtTheNodeAreFixed) {
  Random random(2);
  SignStages stages;
  int ready = 0, mixed_faces = 0, parts = 0;
  for (int n = 0; n < 200; ++n) {
    Star star(test::planted_node(random, kNode, std::exp2(-2.0 - n % 8)), kNode);
    if (!is_ready_for_star(star.tet.cell(), stages)) continue;
    if (!has_certified_spokes(star.tet.cell(), star.node, stages)) continue;
    ++ready;
    std::array<int, 4> sign{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto seen = signs_off_node(star, std::array{V[i]}, random, 100);
      EXPECT_NE(seen[0], seen[2]);
      sign[i] = seen[2] ? 1 : -1;
    }
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        const auto seen = signs_off_node(star, std::array{V[i], V[j]}, random, 300);
        if (sign[i] == sign[j]) {
          // The ends agree: nothing but the node, or else the opposite edge is crossed twice, which
          // its own certificate excludes.
          continue;
        }
        ++mixed_faces;
        EXPECT_TRUE(seen[0] && seen[2]);
        // Along segments between the two edges at the node the sign changes once.
        for (int m = 0; m < 40; ++m) {
          const double radius = std::exp2(-uniform(random, 0, 10));
          int changes = 0, last = 0;
          for (int k = 0; k <= 50; ++k) {
            std::array<Wide, 4> w;
            for (std::size_t c = 0; c < 4; ++c) w[c] = static_cast<Wide>((1 - radius) * star.at[c]);
            w[i] += static_cast<Wide>(radius * (50 - k) / 50);
            w[j] += static_cast<Wide>(radius * k / 50);
            const int now = test::sign_of(test::discriminant(star.field(), V, w));
            changes += now != 0 && last != 0 && now != last;
            if (now != 0) last = now;
          }
          EXPECT_EQ(changes % 2, 1);
        }
      }
    for (std::size_t i = 0; i < 4; ++i) {
      auto v = V;
      v[i] = star.node;
      parts += certifies_nappes(Simplex<4>(star.field(), v), stages);
    }
  }
  EXPECT_GT(ready, 60);
  EXPECT_GT(mixed_faces, 60);
  EXPECT_GT(parts, 4 * ready * 9 / 10);  // mostly the parts of a ready tet are certified
}

/// Not ready: the neutral surface is in the tet as well.
TEST(IsReadyForStar, RefusesWhatElseIsThere) {
  Random random(3);
  SignStages stages;
  int ready_ones = 0;
  for (int n = 0; n < 50; ++n) {
    auto tensors = test::planted_node(random, kNode, std::exp2(-5));
    Star star(tensors, kNode);
    if (!is_ready_for_star(star.tet.cell(), stages)) continue;
    ++ready_ones;
    // One corner across the neutral surface.
    tensors[0] = -tensors[0];
    Star across(tensors, kNode);
    EXPECT_FALSE(is_ready_for_star(across.tet.cell(), stages));
  }
  EXPECT_GT(ready_ones, 10);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a pencil certificate claims is held against dense sampling along the segments of a pencil.
#include "triplex/certify/pencil.hpp"

#include <gtest/gtest.h>

#include "../oracle/block_fields.hpp"
#include "triplex/certify/exclusion.hpp"
#include "triplex/certify/graph.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {
namespace {

using test::OneTet;
using test::Random;
using test::uniform;
using test::Wide;

constexpr int kSegments = 150, kSamples = 48;

/// p, q or D of the deviator at a point, up to a positive factor, like `test::discriminant`.
Wide value_of(Sheet::Kind kind, const RefinableField& field, std::span<const VertexId> vertices,
              std::span<const Wide> weights) {
  if (kind == Sheet::Kind::Curved) return test::discriminant(field, vertices, weights);
  Tensor<Wide> a{};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t k = 0; k < 9; ++k)
      a[k] += weights[i] * static_cast<Wide>(field.approximate(vertices[i]).a[k]);
  return kind == Sheet::Kind::Balanced ? minus_trace_of_product(a, a)
                                       : double_dot(mixed_cofactor(a, a), a);
}

/// The most changes of sign of D, or p or q, along sampled segments from one side of a split to the
/// other.
template <int N>
int most_changes(const Simplex<N>& simplex, unsigned side, Random& random, Sheet::Kind kind) {
  int most = 0;
  for (int n = 0; n < kSegments; ++n) {
    std::array<double, N> ends{};
    std::array<double, 2> sum{};
    for (int i = 0; i < N; ++i)
      sum[side >> i & 1u] += ends[i] = -std::log(uniform(random, 1e-12, 1));
    int changes = 0, last = 0;
    for (int k = 0; k <= kSamples; ++k) {
      const double t = k / double(kSamples);
      std::array<Wide, N> w;
      for (int i = 0; i < N; ++i)
        w[i] = static_cast<Wide>((side >> i & 1u ? t : 1 - t) * ends[i] / sum[side >> i & 1u]);
      const int now = test::sign_of(value_of(kind, simplex.field(), simplex.vertices(), w));
      changes += now != 0 && last != 0 && now != last;
      if (now != 0) last = now;
    }
    most = std::max(most, changes);
  }
  return most;
}
/// Over all splits, the fewest.
template <int N>
int changes_of_best_split(const Simplex<N>& simplex, Random& random,
                          Sheet::Kind kind = Sheet::Kind::Curved) {
  int best = 100;
  for (unsigned side = 1; side < (1u << (N - 1)) && best > 1; ++side)
    best = std::min(best, most_changes(simplex, side, random, kind));
  return best;
}

class PencilTest : public testing::Test {
 protected:
  bool certified(const auto& simplex, Sheet::Kind kind = Sheet::Kind::Curved) {
    return certifies_pencil(simplex, Sheet{.kind = kind}, stages_);
  }
  SignStages stages_;
};

std::array<Eigen::Matrix3d, 4> random_tensors(Random& random, double spread) {
  const Eigen::Matrix3d base = test::random_matrix(random);
  std::array<Eigen::Matrix3d, 4> t;
  for (auto& m : t) m = base + spread * test::random_matrix(random);
  return t;
}

TEST_F(PencilTest, CertifiedPencilsMeetTheSurfaceOnce) {
  Random random(1);
  int tets = 0, faces = 0, crossed = 0;
  for (int n = 0; n < 600; ++n) {
    OneTet tet(random_tensors(random, std::exp2(-static_cast<double>(n % 5))));
    const Simplex<4> cell = tet.cell();
    if (uniform_sign_of_discriminant(cell, ModeMap{}, stages_) != Sign::Zero) continue;
    if (certified(cell)) {
      ++tets;
      const int changes = changes_of_best_split(cell, random);
      EXPECT_LE(changes, 1) << n;
      crossed += changes == 1;
    }
    const Simplex<3> face(cell, {0, 1, 2});
    if (certified(face)) {
      ++faces;
      EXPECT_LE(changes_of_best_split(face, random), 1) << n;
    }
  }
  EXPECT_GT(tets, 50);
  EXPECT_GT(faces, 50);
  EXPECT_GT(crossed, 50);
}

/// The sheets of p and q, few of which are no graphs.
TEST_F(PencilTest, CertifiedPencilsMeetFlatSheetsOnce) {
  Random random(5);
  for (const auto kind : {Sheet::Kind::Balanced, Sheet::Kind::Neutral}) {
    std::array<int, 2> crossed{};  // graphs, and others
    const auto check = [&](const auto& simplex, bool samples_graphs) {
      const bool graph = certifies_graph(simplex, Sheet{.kind = kind}, stages_);
      if (!certified(simplex, kind) || (graph && !samples_graphs)) return;
      const int changes = changes_of_best_split(simplex, random, kind);
      EXPECT_LE(changes, 1);
      crossed[graph ? 0 : 1] += changes == 1;
    };
    for (int n = 0; n < 400; ++n) {
      SCOPED_TRACE(n);
      OneTet tet(random_tensors(random, std::exp2(1 - static_cast<double>(n % 2))));
      const Simplex<4> cell = tet.cell();
      check(cell, n % 10 == 0);
      check(Simplex<3>(cell, {0, 1, 2}), n % 10 == 0);
    }
    EXPECT_GT(crossed[0], 5);
    EXPECT_GT(crossed[1], 20);
  }
}

/// A tube u^2 + v^2 = w^2 of constant w through a tet, (u, v) given at the corners.
std::array<Eigen::Matrix3d, 4> tube(Random& random, double radius,
                                    const std::array<std::array<double, 2>, 4>& uv) {
  const Eigen::Matrix3d basis = test::random_basis(random);
  std::array<Eigen::Matrix3d, 4> t;
  for (int i = 0; i < 4; ++i)
    t[i] = test::block_tensor({uv[i][0], uv[i][1], radius}, 1 + 0.02 * i, basis);
  return t;
}

/// What it is for: however thin a tube around an edge, one tet holds it; no graph does.
TEST_F(PencilTest, HoldsThinTubesAroundAnEdge) {
  Random random(2);
  const Sheet planar = FeatureTable().sheet(Feature::DegeneratePlanar);
  for (const double radius : {1e-2, 1e-3, 1e-5, 1e-7})
    for (int n = 0; n < 10; ++n) {
      OneTet tet(tube(random, radius, {{{0, 0}, {0, 0}, {0.3, 0.1}, {0.2, 0.4}}}));
      const Simplex<4> cell = tet.cell();
      EXPECT_TRUE(certified(cell)) << radius;
      EXPECT_FALSE(certifies_graph(cell, planar, stages_));
      EXPECT_TRUE(certified(Simplex<3>(cell, {0, 2, 3})));
      if (n == 0) {
        EXPECT_EQ(changes_of_best_split(cell, random), 1);
      }
    }
}

/// A tube that enters and leaves through faces is met twice by some segment of every pencil.
TEST_F(PencilTest, RefusesTubesThroughFaces) {
  Random random(3);
  for (const double radius : {0.05, 0.02}) {
    OneTet tet(tube(random, radius, {{{0.3, 0}, {-0.1, 0.3}, {-0.2, -0.3}, {0.03, 0.1}}}));
    EXPECT_GE(changes_of_best_split(tet.cell(), random), 2);
    EXPECT_FALSE(certified(tet.cell()));
    EXPECT_FALSE(certified(Simplex<3>(tet.cell(), {0, 1, 2})));
  }
}

/// A node inside is a double root on every segment through it; on a face too.
TEST_F(PencilTest, RefusesNodes) {
  Random random(4);
  for (int n = 0; n < 200; ++n) {
    const double spread = std::exp2(-static_cast<double>(n % 10));
    OneTet inside(test::planted_node(random, {0.3, 0.2, 0.1, 0.4}, spread));
    EXPECT_FALSE(certified(inside.cell()));
    OneTet on_face(test::planted_node(random, {0.3, 0.3, 0.4, 0}, spread));
    EXPECT_FALSE(certified(Simplex<3>(on_face.cell(), {0, 1, 2})));
  }
}

/// Inside a sphere |x| = a of small rotations the eigenvalues are real: a closed surface.
TEST_F(PencilTest, RefusesClosedSurfaces) {
  const std::array<std::array<double, 3>, 4> corners = {
      {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  for (const double a : {0.125, 0.01}) {
    std::array<Eigen::Matrix3d, 4> t;
    for (int i = 0; i < 4; ++i) {
      const auto [x, y, z] = corners[i];
      t[i] << 2 * a, -z, y, z, -a, -x, -y, x, -a;
    }
    OneTet tet(t);
    EXPECT_FALSE(certified(tet.cell()));
  }
}

}  // namespace
}  // namespace triplex

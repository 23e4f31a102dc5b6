// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Planes where the tensor is exactly block triangular: what is claimed on them and beside them is
// held against exact signs of D.
#include "triplex/certify/block_plane.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "triplex/certify/node.hpp"
#include "triplex/certify/pencil.hpp"

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

/// Changes of the exact sign of D along segments from a face to the opposite one, the sign on the
/// face given: the most of some.
int most_changes_from(const RefinableField& field, const std::array<VertexId, 4>& v, unsigned face,
                      Sign on_face, std::mt19937_64& random) {
  constexpr int kSegments = 20, kSteps = 24;
  int most = 0;
  for (int n = 0; n < kSegments; ++n) {
    std::array<int, 4> ends;
    std::array<int, 2> sum{};
    for (std::size_t i = 0; i < 4; ++i)
      sum[face >> i & 1u] += ends[i] = 1 + static_cast<int>(random() % 9);
    int changes = 0;
    Sign last = on_face;
    for (int k = 1; k <= kSteps; ++k) {
      std::array<int, 4> w;
      for (std::size_t i = 0; i < 4; ++i)
        w[i] = ends[i] * (face >> i & 1u ? (kSteps - k) * sum[0] : k * sum[1]);
      const Sign s = sign_of_d(field, v, w);
      changes += s != Sign::Zero && s != last;
      if (s != Sign::Zero) last = s;
    }
    most = std::max(most, changes);
  }
  return most;
}

/// The sign of disc(M) at the sum of the tensors of some vertices in the plane.
Sign sign_of_block(const RefinableField& field, const std::array<VertexId, 4>& v, unsigned face) {
  Tensor<Exact> a;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; (face >> i & 1u) && k < 9; ++k) a[k] = a[k] + field.exact(v[i])[k];
  return sign((a[0] - a[4]) * (a[0] - a[4]) + Exact(4) * a[1] * a[3]);
}

/// The fewest changes over the faces in the plane of the first three vertices.
int changes_of_best_face(const RefinableField& field, const std::array<VertexId, 4>& v,
                         std::mt19937_64& random) {
  int best = 100;
  for (unsigned face = 3; face < 8; ++face)
    if (std::popcount(face) > 1)
      best =
          std::min(best, most_changes_from(field, v, face, sign_of_block(field, v, face), random));
  return best;
}

/// Whether the eigenvalue of the axis passes one of the block between the vertices in the plane.
bool touches(const RefinableField& field, const std::array<VertexId, 4>& v) {
  int signs = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Tensor<Exact> a = field.exact(v[i]);
    const Sign s = sign((a[0] - a[8]) * (a[4] - a[8]) - a[1] * a[3]);
    signs |= s == Sign::Positive ? 1 : 2;
  }
  return signs == 3;
}

TEST(BlockPlane, PencilsFromThePlaneMeetTheSurfaceOnce) {
  std::mt19937_64 random(47);
  SignStages stages;
  int certified = 0, touching = 0, crossed = 0, refused = 0;
  for (int n = 0; n < 1500; ++n) {
    const double spread = std::exp2(-(n / 3 % 6));
    const TensorField input = random_tet(random, static_cast<Kind>(n % 3), spread);
    const RefinableField field(input);
    const auto v = in_order(field);
    auto sorted = v;
    std::ranges::sort(sorted);
    const Simplex<4> cell(field, sorted);
    if (!certifies_pencil_from_block(cell, stages)) {
      ++refused;
      continue;
    }
    ++certified;
    const bool only_so = touches(field, v) &&
                         !certifies_pencil(cell, Sheet{.kind = Sheet::Kind::Curved}, stages) &&
                         !certifies_real_off_block(cell, stages);
    touching += only_so;
    crossed += only_so && sign_of_d(field, v, {0, 0, 0, 1}) == Sign::Negative;
    EXPECT_LE(changes_of_best_face(field, v, random), 1) << n;
  }
  EXPECT_GT(certified, 300);
  EXPECT_GT(touching, 40);
  EXPECT_GT(crossed, 20);
  EXPECT_GT(refused, 300);
}

/// A free-slip wall z = 0 and, above it, D = (x^2 - 4 c z) times a square, with the coupling
/// c = coupling + slope y + lift z / size: where c > 0 the surface touches the wall along x = 0
/// from inside.
struct Wall {
  double size = 0.125, coupling = 1, slope = 0, lift = 0, offset = 0.25;
};
TensorField field_of(const Wall& wall) {
  TensorField input;
  input.mesh.points = {{-1, -1, 0}, {1, -1, 0}, {wall.offset, 1, 0}, {0, 0, 1}};
  input.mesh.tets = {{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  for (const Point& at : input.mesh.points) {
    const double x = wall.size * at[0], z = wall.size * at[2];
    input.tensors.push_back(
        {x, 0, -z, 0, 5, 0, wall.coupling + wall.slope * at[1] + wall.lift * at[2], 0.25, 0});
  }
  return input;
}
bool certified_on(const Wall& wall) {
  const TensorField input = field_of(wall);
  const RefinableField field(input);
  const auto v = in_order(field);
  auto sorted = v;
  std::ranges::sort(sorted);
  SignStages stages;
  EXPECT_FALSE(certifies_real_off_block(Simplex<4>(field, sorted), stages));
  const bool claimed = certifies_pencil_from_block(Simplex<4>(field, sorted), stages);
  if (claimed) {
    std::mt19937_64 random(5);
    EXPECT_LE(changes_of_best_face(field, v, random), 1);
  }
  return claimed;
}

TEST(BlockPlane, ASheetMayTouchTheWall) {
  EXPECT_TRUE(certified_on({}));
  EXPECT_TRUE(certified_on({.slope = 0.5}));
  EXPECT_FALSE(certified_on({.size = 32})) << "far beyond the scale of the coupling";
}

/// From the wall into the complex domain and out again: D changes sign twice, but its layers beyond
/// the first only once.
TEST(BlockPlane, TheSignOnTheWallCounts) {
  EXPECT_FALSE(certified_on({.size = 0x1p-5, .lift = -2}));
}

/// Where the coupling changes sign on the curve of touching there is a node: layers have no sign
/// there, but the quotient falls.
TEST(BlockPlane, ANodeOnTheWallMayBeAPointOfTheSheet) {
  EXPECT_TRUE(certified_on({.slope = 2})) << "all else is on one side";
  EXPECT_FALSE(certified_on({.coupling = -0.25, .slope = 2})) << "the apex is on the real side";
}

TEST(BlockPlane, AVertexOnTheCurveOfTouchingHasNoLabelOfTheField) {
  EXPECT_FALSE(certified_on({.offset = 0}));
}

}  // namespace
}  // namespace triplex

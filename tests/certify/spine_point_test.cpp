// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces whose triple degenerate point is known exactly: nilpotent combinations with dyadic weights.
#include "triplex/certify/spine_point.hpp"

#include <gtest/gtest.h>

#include "../oracle/random_tensors.hpp"
#include "triplex/certify/spine.hpp"

namespace triplex {
namespace {

using oracle::Random;

constexpr std::array<VertexId, 3> kFace = {VertexId(0), VertexId(1), VertexId(2)};

/// A tet whose first face has the tensors given.
TensorField field_with_face(const std::array<Tensor<double>, 3>& tensors) {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  field.mesh.tets = {{VertexId(0), VertexId(1), VertexId(3), VertexId(2)}};
  field.tensors = {tensors[0], tensors[1], tensors[2], {}};
  return field;
}

/// A nilpotent tensor of rank two with small integers, plus a multiple of the identity.
Tensor<double> triple_degenerate(Random& random) {
  Tensor<double> t = {0, 1, 0, 0, 0, 1, 0, 0, 0};
  t[2] = oracle::integer(random, 4);
  t = oracle::similar(random, t);
  const double shift = oracle::integer(random, 9);
  for (const std::size_t k : {0, 4, 8}) t[k] += shift;
  return t;
}

/// Tensors a_0 and a_1 near a triple degenerate one, n, and a_2 such that the sum of w_i a_i is n:
/// exact in doubles.
std::array<Tensor<double>, 3> face_through(Random& random, const Tensor<double>& n,
                                           const FacePoint& w) {
  std::array<Tensor<double>, 3> a;
  for (std::size_t k = 0; k < 9; ++k) {
    a[0][k] = n[k] + oracle::integer(random, 1000) / 65536;
    a[1][k] = n[k] + oracle::integer(random, 1000) / 65536;
    a[2][k] = n[k] - (w[0] * (a[0][k] - n[k]) + w[1] * (a[1][k] - n[k])) / w[2];
  }
  return a;
}

FacePoint turned(const FacePoint& w, std::size_t by) {
  return {w[(3 - by) % 3], w[(4 - by) % 3], w[(5 - by) % 3]};
}

struct Count {
  int enclosed = 0, tried = 0;
};

/// Encloses the point w in random faces through it, with the vertices in every cyclic order.
Count enclose_many(const FacePoint& w, double offset, int faces) {
  Random random(11);
  Count count;
  for (int n = 0; n < faces; ++n) {
    const Tensor<double> spine = triple_degenerate(random);
    const auto a = face_through(random, spine, w);
    for (std::size_t by = 0; by < 3; ++by) {
      const TensorField input =
          field_with_face({a[(3 - by) % 3], a[(4 - by) % 3], a[(5 - by) % 3]});
      const RefinableField field(input);
      const Simplex<3> face(field, kFace);
      const FacePoint truth = turned(w, by);
      SignStages stages;
      if (!certifies_injective(face, stages)) continue;
      ++count.tried;
      const auto box = enclose_spine_point(face, {truth[0] - offset, truth[1] + offset, truth[2]});
      if (!box) continue;
      ++count.enclosed;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE((*box)[i].contains(truth[i])) << "face " << n << ", coordinate " << i;
        EXPECT_LT((*box)[i].hi - (*box)[i].lo, 0x1p-44) << "face " << n;
      }
    }
  }
  return count;
}

TEST(EncloseSpinePoint, HoldsTheTruePointInsideTheFace) {
  for (const FacePoint& w : {FacePoint{0.25, 0.25, 0.5}, {0.125, 0.375, 0.5}}) {
    const Count count = enclose_many(w, 1e-9, 200);
    EXPECT_GT(count.tried, 100);
    EXPECT_EQ(count.enclosed, count.tried);
  }
}

TEST(EncloseSpinePoint, HoldsItOnEdgesAndVertices) {
  for (const FacePoint& w : {FacePoint{0.5, 0, 0.5}, {0, 0, 1}}) {
    const Count count = enclose_many(w, 1e-12, 200);
    EXPECT_GT(count.tried, 100);
    EXPECT_EQ(count.enclosed, count.tried);
  }
}

TEST(EncloseSpinePoint, ClaimsNothingOutside) {
  const Count count = enclose_many({0.625, -0.125, 0.5}, 0, 200);
  EXPECT_GT(count.tried, 100);
  EXPECT_EQ(count.enclosed, 0);
}

/// Two points of the curve on one face: neither may be called the only one.
TEST(EncloseSpinePoint, ClaimsNothingWhereThereAreTwo) {
  Random random(5);
  for (int n = 0; n < 200; ++n) {
    const Tensor<double> first = triple_degenerate(random), second = triple_degenerate(random);
    // w = (1/2, 1/4, 1/4) and (1/4, 1/2, 1/4).
    std::array<Tensor<double>, 3> a;
    for (std::size_t k = 0; k < 9; ++k) {
      a[0][k] = oracle::integer(random, 16);
      a[1][k] = a[0][k] - 4 * (first[k] - second[k]);
      a[2][k] = 4 * first[k] - 2 * a[0][k] - a[1][k];
    }
    const TensorField input = field_with_face(a);
    const RefinableField field(input);
    const Simplex<3> face(field, kFace);
    EXPECT_FALSE(enclose_spine_point(face, {0.5, 0.25, 0.25}));
    EXPECT_FALSE(enclose_spine_point(face, {0.25, 0.5, 0.25}));
  }
}

TEST(EncloseSpinePoint, ClaimsNothingWhereAllPointsAreTripleDegenerate) {
  const Tensor<double> n = {0, 1, 0, 0, 0, 0, 0, 0, 0};
  for (const auto& a : {std::array{Tensor<double>{}, Tensor<double>{}, Tensor<double>{}},
                        std::array{n, oracle::scaled(n, 1), oracle::negated(n)}}) {
    const TensorField input = field_with_face(a);
    const RefinableField field(input);
    EXPECT_FALSE(enclose_spine_point(Simplex<3>(field, kFace), {0.25, 0.25, 0.5}));
  }
}

TEST(EncloseSpinePoint, DoesNotDependOnTheScale) {
  Random random(3);
  const FacePoint w = {0.25, 0.25, 0.5};
  int compared = 0;
  for (int n = 0; n < 20; ++n) {
    const auto a = face_through(random, triple_degenerate(random), w);
    std::optional<FaceBox> first;
    for (const int exponent : {0, 300, -600}) {
      std::array<Tensor<double>, 3> scaled;
      for (std::size_t i = 0; i < 3; ++i) scaled[i] = oracle::scaled(a[i], exponent);
      TensorField input = field_with_face(scaled);
      input.tensors[3] = {1, 0, 0, 0, 0, 0, 0, 0, 0};  // sets the scale of the field
      const RefinableField field(input);
      const auto box = enclose_spine_point(Simplex<3>(field, kFace), w);
      if (exponent == 0) first = box;
      if (!first) continue;
      ASSERT_TRUE(box);
      EXPECT_EQ(*box, *first) << "2^" << exponent;
      ++compared;
    }
  }
  EXPECT_GT(compared, 30);
}

}  // namespace
}  // namespace triplex

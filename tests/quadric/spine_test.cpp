// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triple degenerate curve on edges, faces and in tets, on fields where it is planted: integer
// tensors that are nilpotent at chosen points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../../src/quadric/spine_free.hpp"
#include "../../src/quadric/spine_on_face.hpp"
#include "form_fields.hpp"
#include "triplex/tensor/invariants.hpp"

namespace triplex {
namespace {

using namespace test;
using detail::CutMeshFace;
using detail::FacePoint;
using detail::FaceSpine;

using Integers = Tensor<int>;

class Planting {
 public:
  explicit Planting(unsigned seed) : random_(seed) {}

  Integers tensor() {
    Integers t;
    for (std::size_t k = 0; k < 9; ++k) t[k] = pick_(random_);
    return t;
  }

  /// P J P^-1 with J = [[0,a,0],[0,0,b],[0,0,0]], a b != 0, and P a product of shears: of rank 2.
  Integers nilpotent() {
    Integers t{};
    t[1] = 1 + std::abs(pick_(random_));
    t[5] = 1 + std::abs(pick_(random_));
    for (int step = 0; step < 6; ++step) {
      const auto i = static_cast<std::size_t>(step % 3), j = (i + 1 + step / 3) % 3;
      const int s = shear_(random_);
      for (std::size_t k = 0; k < 3; ++k) t[3 * i + k] += s * t[3 * j + k];
      for (std::size_t k = 0; k < 3; ++k) t[3 * k + j] -= s * t[3 * k + i];
    }
    return t;
  }

 private:
  std::mt19937 random_;
  std::uniform_int_distribution<int> pick_{-9, 9}, shear_{-1, 1};
};

Tensor<double> to_double(const Integers& t) {
  Tensor<double> d;
  for (std::size_t k = 0; k < 9; ++k) d[k] = t[k];
  return d;
}

/// The sum of factors times tensors; exact.
Tensor<double> sum(const std::vector<std::pair<int, Integers>>& terms) {
  Integers t{};
  for (const auto& [factor, x] : terms)
    for (std::size_t k = 0; k < 9; ++k) t[k] += factor * x[k];
  return to_double(t);
}

CutMeshFace face_of(const TensorField& field, std::array<EdgeCut, 3>& edges,
                    std::array<std::array<Sign, 2>, 3>& signs) {
  CutMeshFace face;
  face.vertices = {kCorners[0], kCorners[1], kCorners[2]};
  for (std::size_t e = 0; e < 3; ++e) {
    const auto [v, w] = kFaceEdges[e];
    const std::array<VertexId, 2> ends = {kCorners[v], kCorners[w]};
    edges[e] = cut_edge(SimplexForm<2>({}, field, ends));
    signs[e] = detail::spine_signs(field, ends, edges[e]);
  }
  face.cut = cut_face(SimplexForm<3>({}, field, face.vertices), edges);
  return face;
}

/// |p| and |q| of the deviator of length 1 at a point of the face.
std::array<double, 2> invariants_at(const TensorField& field, const FacePoint& x) {
  Tensor<double> t{};
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t k = 0; k < 9; ++k) t[k] += x[v] * field.tensors[v][k];
  const double length = magnitude_approx(deviator_approx(t));
  return {std::fabs(minor_approx(t)) / std::pow(length, 2),
          std::fabs(det_approx(t)) / std::pow(length, 3)};
}

TEST(SpineOnEdge, IsFoundExactlyWhereItIsPlanted) {
  Planting planting(1);
  int asked = 0;
  for (int n = 0; n < 500; ++n) {
    TensorField field = one_tet(kAroundOrigin);
    const Integers first = planting.tensor(), middle = planting.nilpotent();
    field.tensors[0] = to_double(first);
    field.tensors[1] = sum({{2, middle}, {-1, first}});
    const EdgeCut edge = cut_edge(SimplexForm<2>({}, field, {kCorners[0], kCorners[1]}));
    if (edge.roots == 0) continue;  // p vanishes doubly
    ++asked;
    const auto signs = detail::spine_signs(field, {kCorners[0], kCorners[1]}, edge);
    int zeros = 0;
    for (int k = 0; k < edge.roots; ++k)
      if (signs[k] == Sign::Zero) {
        ++zeros;
        EXPECT_NEAR(edge.place[k], 0.5, 1e-12);
      }
    EXPECT_EQ(zeros, 1) << n;
  }
  EXPECT_GT(asked, 400);
}

/// At the points (2,1,1)/4, (1,2,1)/4, (1,1,2)/4 of the face the tensor is nilpotent.
TEST(SpineOnFace, HoldsThreePlantedPointsAndOnlyZeros) {
  constexpr std::array<FacePoint, 3> kPlanted = {
      {{0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}, {0.25, 0.25, 0.5}}};
  // Places are in doubles and claim nothing; other zeros are much farther away.
  constexpr double kDrawn = 1e-6;
  Planting planting(2);
  int known = 0, more = 0, asked = 0;
  for (int n = 0; n < 1000; ++n) {
    TensorField field = one_tet(kAroundOrigin);
    const std::array<Integers, 3> N = {planting.nilpotent(), planting.nilpotent(),
                                       planting.nilpotent()};
    for (std::size_t v = 0; v < 3; ++v)
      field.tensors[v] = sum({{3, N[v]}, {-1, N[(v + 1) % 3]}, {-1, N[(v + 2) % 3]}});
    std::array<EdgeCut, 3> edges;
    std::array<std::array<Sign, 2>, 3> signs;
    const CutMeshFace face = face_of(field, edges, signs);
    const auto has_zero = [&](std::size_t e) {
      return std::ranges::find(signs[e].begin(), signs[e].begin() + edges[e].roots, Sign::Zero) !=
             signs[e].begin() + edges[e].roots;
    };
    if (!face.cut.transverse || face.cut.oval || has_zero(0) || has_zero(1) || has_zero(2))
      continue;
    ++asked;
    const FaceSpine spine = detail::spine_on_face(field, face, edges, signs);
    if (!spine.known) continue;
    ++known;
    EXPECT_LE(spine.points.size(), 6u);  // Bezout
    more += spine.points.size() > 3;
    for (const FacePoint& x : kPlanted)
      EXPECT_TRUE(std::ranges::any_of(spine.points, [&](const detail::SpinePoint& point) {
        return std::fabs(point.x[0] - x[0]) + std::fabs(point.x[1] - x[1]) < kDrawn;
      })) << n;
    for (std::size_t k = 0; k < spine.points.size(); ++k) {
      const detail::SpinePoint& point = spine.points[k];
      const auto [p, q] = invariants_at(field, point.x);
      EXPECT_LT(p, kDrawn) << n;
      EXPECT_LT(q, kDrawn) << n;
      EXPECT_LT(point.arc, face.cut.arcs);
      EXPECT_GT(point.place, 0);
      EXPECT_LT(point.place, 1);
      if (k > 0 && spine.points[k - 1].arc == point.arc) {
        EXPECT_LT(spine.points[k - 1].place, point.place) << n;
      }
    }
  }
  EXPECT_GT(asked, 700);
  EXPECT_GT(known, asked * 9 / 10);
  EXPECT_GT(more, known / 2);  // points that were not planted are found too
}

TEST(SpineFree, NeverHoldsWhereTheCurveIsPlanted) {
  Planting planting(3);
  const IntervalRounding rounding;
  for (int n = 0; n < 2000; ++n) {
    TensorField field = one_tet(kAroundOrigin);
    const std::array<Integers, 3> T = {planting.tensor(), planting.tensor(), planting.tensor()};
    for (std::size_t v = 0; v < 3; ++v) field.tensors[v] = to_double(T[v]);
    field.tensors[3] = sum({{4, planting.nilpotent()}, {-1, T[0]}, {-1, T[1]}, {-1, T[2]}});
    EXPECT_FALSE(detail::is_free_of_spine(detail::forms_on<Interval>(field, kCorners))) << n;
  }
}

/// Of random tets in which the coefficients of q differ in sign, some have an L.
TEST(SpineFree, HoldsWhereTheSignOfQIsNotEnough) {
  Planting planting(4);
  const IntervalRounding rounding;
  int mixed = 0, free = 0;
  for (int n = 0; n < 2000; ++n) {
    TensorField field = one_tet(kAroundOrigin);
    for (std::size_t v = 0; v < 4; ++v) field.tensors[v] = to_double(planting.tensor());
    const auto forms = detail::forms_on<Interval>(field, kCorners);
    const auto is_positive = [](const Interval& x) { return x.inf() > 0; };
    const auto is_negative = [](const Interval& x) { return x.sup() < 0; };
    if (std::ranges::all_of(forms.q, is_positive) || std::ranges::all_of(forms.q, is_negative))
      continue;
    ++mixed;
    free += detail::is_free_of_spine(forms);
  }
  EXPECT_GT(free, mixed / 100);
}

}  // namespace
}  // namespace triplex

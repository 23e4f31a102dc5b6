// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/input_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "triplex/field/generators.hpp"
#include "triplex/field/orientation.hpp"

namespace triplex {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::array<VertexId, 4> tet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  return {VertexId{a}, VertexId{b}, VertexId{c}, VertexId{d}};
}

/// A field with tensors that differ from point to point; negative tets are turned around.
TensorField make_field(std::vector<Point> points, std::vector<std::array<VertexId, 4>> tets) {
  TensorField field;
  field.mesh.points = std::move(points);
  for (auto& t : tets) {
    const auto& x = field.mesh.points;
    if (orientation(x[index(t[0])], x[index(t[1])], x[index(t[2])], x[index(t[3])]) ==
        Sign::Negative) {
      std::swap(t[2], t[3]);
    }
  }
  field.mesh.tets = std::move(tets);
  for (std::size_t i = 0; i < field.mesh.points.size(); ++i) {
    field.tensors.push_back({1.0 * static_cast<double>(i), 2, 3, 4, 5, 6, 7, 8, 9});
  }
  return field;
}

/// Two tets on either side of the face 0, 1, 2.
TensorField two_tets() {
  return make_field({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                    {tet(0, 1, 2, 3), tet(0, 1, 2, 4)});
}

std::string message_of(const TensorField& field) {
  try {
    check_input(field);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

std::string message_of(TensorField field, const InputOptions& options) {
  try {
    check_input(field, options);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

// ---- what is accepted ----

TEST(InputCheck, AcceptsGoodMeshes) {
  EXPECT_EQ(message_of(two_tets()), "accepted");
  // Two tets with a common edge only, and with a common vertex only.
  EXPECT_EQ(
      message_of(make_field({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                            {tet(0, 1, 2, 3), tet(0, 1, 4, 5)})),
      "accepted");
  EXPECT_EQ(message_of(make_field(
                {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {-1, 0, 0}, {-1, 1, 0}, {-1, 0, 1}},
                {tet(0, 1, 2, 3), tet(0, 4, 5, 6)})),
            "accepted");
  // Two parts that do not touch, though their boxes do.
  EXPECT_EQ(
      message_of(make_field(
          {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {4, 4, 4}, {3, 4, 4}, {4, 3, 4}, {4, 4, 3}},
          {tet(0, 1, 2, 3), tet(4, 5, 6, 7)})),
      "accepted");
}

TEST(InputCheck, AcceptsUnusedPointsEvenWhereOthersAre) {
  TensorField field = two_tets();
  field.mesh.points.push_back({0, 0, 0});
  field.mesh.points.push_back({0.25, 0.25, 0});
  field.tensors.resize(7);
  EXPECT_EQ(message_of(field), "accepted");
  EXPECT_EQ(remove_unused_points(field), 2u);
  EXPECT_EQ(field.mesh.points, two_tets().mesh.points);
  EXPECT_EQ(field.tensors, two_tets().tensors);
}

TEST(InputCheck, AcceptsTinyAndHugeMeshes) {
  for (const double scale : {0x1p-1074, 0x1p-1040, 1e-300, 1e-200, 1e200, 1e300, 0x1p1023}) {
    TensorField field = two_tets();
    for (Point& x : field.mesh.points) {
      for (double& c : x) c *= scale;
    }
    EXPECT_EQ(message_of(field), "accepted") << scale;
    std::swap(field.mesh.tets[1][0], field.mesh.tets[1][1]);
    EXPECT_THAT(message_of(field), HasSubstr("cell 1 (points 1, 0")) << scale;
  }
}

TEST(InputCheck, RemovingUnusedPointsRenumbersTets) {
  TensorField field = two_tets();
  field.mesh.points.insert(field.mesh.points.begin(), Point{9, 9, 9});
  field.tensors.insert(field.tensors.begin(), Tensor<double>{});
  for (auto& t : field.mesh.tets) {
    for (VertexId& v : t) v = VertexId{static_cast<std::uint32_t>(index(v) + 1)};
  }
  EXPECT_EQ(remove_unused_points(field), 1u);
  EXPECT_EQ(field.mesh.tets, two_tets().mesh.tets);
  EXPECT_EQ(field.mesh.points, two_tets().mesh.points);
}

// ---- numbers and ids ----

TEST(InputCheck, RefusesEmptyMeshes) {
  EXPECT_THAT(message_of(TensorField{}), HasSubstr("no tets (0 points)"));
  TensorField field = two_tets();
  field.mesh.tets.clear();
  EXPECT_THAT(message_of(field), HasSubstr("no tets (5 points)"));
}

TEST(InputCheck, RefusesArraysOfOtherLength) {
  TensorField field = two_tets();
  field.tensors.pop_back();
  EXPECT_THAT(message_of(field), HasSubstr("4 tensors for 5 points"));
  field = two_tets();
  field.source_cells = {1, 2, 3};
  EXPECT_THAT(message_of(field), HasSubstr("3 source cell ids for 2 tets"));
}

TEST(InputCheck, RefusesNumbersThatAreNotFinite) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    TensorField field = two_tets();
    field.mesh.points[3][1] = bad;
    EXPECT_THAT(message_of(field), AllOf(HasSubstr("point 3 at (0, "), HasSubstr("not finite")));
    for (int component = 0; component < 9; ++component) {
      field = two_tets();
      field.tensors[2][component] = bad;
      EXPECT_THAT(message_of(field), AllOf(HasSubstr("point 2 at (0, 1, 0)"),
                                           HasSubstr("component " + std::to_string(component) +
                                                     " (row " + std::to_string(component / 3) +
                                                     ", column " + std::to_string(component % 3)),
                                           HasSubstr("must be finite")));
    }
  }
}

TEST(InputCheck, RefusesVertexIdsOutOfRange) {
  TensorField field = two_tets();
  field.mesh.tets[1][2] = VertexId{5};
  EXPECT_THAT(message_of(field), AllOf(HasSubstr("cell 1"), HasSubstr("refers to point 5"),
                                       HasSubstr("only 5 points")));
}

TEST(InputCheck, RefusesRepeatedVerticesInEveryPosition) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      TensorField field = two_tets();
      field.mesh.tets[1][i] = field.mesh.tets[1][j];
      EXPECT_THAT(message_of(field), AllOf(HasSubstr("cell 1"), HasSubstr("same point twice")));
    }
  }
}

TEST(InputCheck, NamesCellsByTheirIdInTheFile) {
  TensorField field = two_tets();
  field.source_cells = {17, 42};
  field.mesh.tets[1][2] = field.mesh.tets[1][1];
  EXPECT_THAT(message_of(field), HasSubstr("cell 42"));
}

// ---- coincident points ----

/// As `two_tets`, but the second tet has its own copies of the common points.
TensorField torn() {
  TensorField field = make_field(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}, {1, 0, 0}, {-0.0, 1, 0}},
      {tet(0, 1, 2, 3), tet(5, 6, 7, 4)});
  for (int i = 0; i < 3; ++i) field.tensors[5 + i] = field.tensors[i];
  return field;
}

TEST(InputCheck, RefusesCoincidentPointsAndMergesThemOnRequest) {
  EXPECT_THAT(message_of(torn()), AllOf(HasSubstr("point 5 at (0, 0, 0) coincides with point 0"),
                                        HasSubstr("--merge-points")));
  TensorField field = torn();
  const InputRepairs repairs = check_input(field, {.merge_points = true});
  EXPECT_EQ(repairs.merged_points, 3u);
  EXPECT_EQ(repairs.flipped_tets, 0u);
  EXPECT_EQ(message_of(field), "accepted");
  EXPECT_EQ(remove_unused_points(field), 3u);
  EXPECT_EQ(field.mesh.points, two_tets().mesh.points);
  EXPECT_EQ(field.mesh.tets[0], two_tets().mesh.tets[0]);
}

TEST(InputCheck, RefusesToMergeUnequalTensors) {
  TensorField field = torn();
  field.tensors[6][4] = 5 + 0x1p-50;
  field.tensors[5] = field.tensors[0];
  EXPECT_THAT(message_of(field, {.merge_points = true}),
              AllOf(HasSubstr("point 6"), HasSubstr("point 1"), HasSubstr("tensors differ"),
                    HasSubstr("component 4"), Not(HasSubstr("--merge-points"))));
}

TEST(InputCheck, MergingMayRevealDegenerateTets) {
  // A tet two of whose points coincide.
  TensorField field = two_tets();
  field.mesh.points[4] = field.mesh.points[0];
  field.tensors[4] = field.tensors[0];
  EXPECT_THAT(message_of(field), HasSubstr("coincides"));
  EXPECT_THAT(message_of(field, {.merge_points = true}), HasSubstr("same point twice"));
}

// ---- orientation ----

TEST(InputCheck, RefusesInvertedTetsAndTurnsThemOnRequest) {
  TensorField field = two_tets();
  std::swap(field.mesh.tets[1][0], field.mesh.tets[1][1]);
  EXPECT_THAT(message_of(field),
              AllOf(HasSubstr("cell 1"), HasSubstr("inverted"), HasSubstr("--fix-orientation")));
  const InputRepairs repairs = check_input(field, {.fix_orientation = true});
  EXPECT_EQ(repairs.flipped_tets, 1u);
  EXPECT_EQ(message_of(field), "accepted");
}

TEST(InputCheck, RefusesTetsWithoutVolume) {
  // Four points of a plane x + y + z = constant, all coordinates of about 50 bits.
  const double middle = 0.7, d = 0x1.23456789abcp-4, e = 0x1.357p-6;
  const double a = middle - d, b = middle + d;
  std::vector<Point> points{{a, a, b}, {a, b, a}, {b, a, a}, {a + e, b - 2 * e, a + e}};
  ASSERT_EQ(orientation(points[0], points[1], points[2], points[3]), Sign::Zero);
  const TensorField flat = make_field(points, {tet(0, 1, 2, 3)});
  EXPECT_THAT(message_of(flat), AllOf(HasSubstr("cell 0"), HasSubstr("no volume")));
  EXPECT_THAT(message_of(flat, {.fix_orientation = true}), HasSubstr("no volume"));
  // One unit in the last place away from the plane, either way.
  for (const double target : {-1.0, 2.0}) {
    points[3][0] = std::nextafter(a, target);
    TensorField thin = make_field(points, {tet(0, 1, 2, 3)});
    EXPECT_EQ(message_of(thin), "accepted");
    std::swap(thin.mesh.tets[0][0], thin.mesh.tets[0][1]);
    EXPECT_THAT(message_of(thin), HasSubstr("inverted"));
  }
}

// ---- faces ----

TEST(InputCheck, RefusesDuplicateTets) {
  TensorField field = two_tets();
  // An even permutation of the second tet.
  const auto t = field.mesh.tets[1];
  field.mesh.tets.push_back({t[1], t[2], t[0], t[3]});
  EXPECT_THAT(message_of(field), AllOf(HasSubstr("cell 2"), HasSubstr("same tet as cell 1")));
}

TEST(InputCheck, RefusesFacesOfThreeTets) {
  const TensorField field =
      make_field({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 2}},
                 {tet(0, 1, 2, 3), tet(0, 1, 2, 4), tet(0, 1, 2, 5)});
  EXPECT_THAT(message_of(field), AllOf(HasSubstr("face (points 0, 1, 2) belongs to 3 tets"),
                                       HasSubstr("cells 0, 1, 2")));
}

TEST(InputCheck, RefusesTetsOnTheSameSideOfAFace) {
  const TensorField field = make_field({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}},
                                       {tet(0, 1, 2, 3), tet(0, 1, 2, 4)});
  EXPECT_THAT(message_of(field),
              AllOf(HasSubstr("cells 0 and 1 overlap"), HasSubstr("face (points 0, 1, 2)")));
}

// ---- hanging nodes and overlaps of the boundary ----

TEST(InputCheck, RefusesAHangingNodeInAFace) {
  // Below, the face 0, 1, 2 is cut into three at point 4.
  const TensorField field =
      make_field({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 0}, {0, 0, -4}},
                 {tet(0, 1, 2, 3), tet(0, 1, 4, 5), tet(1, 2, 4, 5), tet(2, 0, 4, 5)});
  EXPECT_THAT(message_of(field), AllOf(HasSubstr("hanging node: point 4 at (1, 1, 0)"),
                                       HasSubstr("face (points 0, 1, 2) of cell 0")));
}

TEST(InputCheck, RefusesAHangingNodeOnEachEdge) {
  // One tet of a good mesh is bisected at an edge, its neighbours are not.
  const TensorField good = generate_noise({.n = 4});
  for (const std::size_t victim : {0u, 200u, 383u}) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        TensorField field = good;
        const auto t = field.mesh.tets[victim];
        Point middle;
        for (int k = 0; k < 3; ++k) {
          middle[k] = (field.mesh.points[index(t[i])][k] + field.mesh.points[index(t[j])][k]) / 2;
        }
        const VertexId v{static_cast<std::uint32_t>(field.mesh.points.size())};
        field.mesh.points.push_back(middle);
        field.tensors.push_back({});
        field.mesh.tets[victim][i] = v;
        auto other = t;
        other[j] = v;
        field.mesh.tets.push_back(other);
        EXPECT_THAT(message_of(field), HasSubstr("hanging node: point 125 at")) << victim << i << j;
      }
    }
  }
}

TEST(InputCheck, RefusesAFaceCutAlongTheOtherDiagonal) {
  // A pyramid above and one below a square, cut along different diagonals: no vertex hangs.
  const TensorField field =
      make_field({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
                 {tet(0, 1, 2, 4), tet(0, 2, 3, 4), tet(0, 1, 3, 5), tet(1, 2, 3, 5)});
  EXPECT_THAT(message_of(field), AllOf(HasSubstr("cross or overlap"), HasSubstr("of cell 0"),
                                       Not(HasSubstr("hanging"))));
  // The same in a plane that is parallel to no axis, and in one parallel to each.
  for (const auto& m : {std::array<double, 9>{3, 5, 7, 7, -2, 0, 0, 9, 3},
                        {0, 0, 1, 1, 0, 0, 0, 1, 0},
                        {0, 1, 0, 0, 0, 1, 1, 0, 0}}) {
    TensorField turned = field;
    for (Point& x : turned.mesh.points) {
      const auto [a, b, c] = x;
      for (int i = 0; i < 3; ++i) x[i] = m[3 * i] * a + m[3 * i + 1] * b + m[3 * i + 2] * c;
    }
    EXPECT_THAT(message_of(turned, {.fix_orientation = true}), HasSubstr("cross or overlap"));
  }
}

TEST(InputCheck, RefusesTetsThatInterpenetrate) {
  // No common vertex; an edge of one pierces a face of the other.
  EXPECT_THAT(message_of(make_field({{0, 0, 0},
                                     {4, 0, 0},
                                     {0, 4, 0},
                                     {0, 0, 4},
                                     {1, 1, -1},
                                     {1.25, 1, -1},
                                     {1, 1.25, -1},
                                     {1, 1, 1}},
                                    {tet(0, 1, 2, 3), tet(4, 5, 6, 7)})),
              HasSubstr("cross or overlap"));
  // One common vertex.
  EXPECT_THAT(message_of(make_field(
                  {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {3, 3, 1}, {3, 3.5, 1}, {3, 3, 1.5}},
                  {tet(0, 1, 2, 3), tet(0, 4, 5, 6)})),
              HasSubstr("cross or overlap"));
  // A common edge: faces in one plane, on the same side of it.
  EXPECT_THAT(
      message_of(make_field({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {4, 4, 0}, {2, 2, -4}},
                            {tet(0, 1, 2, 3), tet(0, 1, 4, 5)})),
      HasSubstr("cross or overlap"));
}

TEST(InputCheck, RefusesPartsThatTouch) {
  // The corner of one tet lies in a face of the other, on an edge of it.
  EXPECT_THAT(message_of(make_field({{0, 0, 0},
                                     {4, 0, 0},
                                     {0, 4, 0},
                                     {0, 0, 4},
                                     {1, 1, 0},
                                     {1, 1, -1},
                                     {2, 1, -1},
                                     {1, 2, -1}},
                                    {tet(0, 1, 2, 3), tet(4, 5, 6, 7)})),
              HasSubstr("hanging node: point 4"));
  EXPECT_THAT(message_of(make_field({{0, 0, 0},
                                     {4, 0, 0},
                                     {0, 4, 0},
                                     {0, 0, 4},
                                     {2, 0, 0},
                                     {2, -1, -1},
                                     {3, -1, -1},
                                     {2, -2, -1}},
                                    {tet(0, 1, 2, 3), tet(4, 5, 6, 7)})),
              HasSubstr("hanging node: point 4"));
  // Two edges cross in their interiors.
  EXPECT_THAT(message_of(make_field({{0, 0, 0},
                                     {4, 0, 0},
                                     {0, 4, 0},
                                     {0, 0, 4},
                                     {2, -1, 0},
                                     {2, 1, 0},
                                     {2, 0, -1},
                                     {3, 0, -2}},
                                    {tet(0, 1, 2, 3), tet(4, 5, 6, 7)})),
              HasSubstr("does not conform"));
}

TEST(InputCheck, NamesTheFirstFaultForAnyNumberOfThreads) {
  TensorField field = generate_noise({.n = 20});
  for (const std::size_t t : {47000u, 31000u, 12345u, 40000u}) {
    std::swap(field.mesh.tets[t][0], field.mesh.tets[t][1]);
  }
  TensorField torn_grid = generate_noise({.n = 20});
  for (const std::size_t t : {30000u, 20000u}) {  // remove a tet, put a flatter one in its place
    const VertexId v{static_cast<std::uint32_t>(torn_grid.mesh.points.size())};
    auto& tet_ids = torn_grid.mesh.tets[t];
    Point x{0, 0, 0};
    for (const VertexId w : tet_ids) {
      for (int k = 0; k < 3; ++k) x[k] += torn_grid.mesh.points[index(w)][k] / 4;
    }
    torn_grid.mesh.points.push_back(x);
    torn_grid.tensors.push_back({});
    auto second = tet_ids;
    second[0] = v;
    torn_grid.mesh.tets.push_back(second);
    torn_grid.mesh.tets.push_back(second);
  }
  std::string first;
  for (const std::size_t threads : {1u, 2u, 4u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_THAT(message_of(field), HasSubstr("cell 12345"));
    if (threads == 1) first = message_of(torn_grid);
    EXPECT_EQ(message_of(torn_grid), first);
  }
  EXPECT_NE(first, "accepted");
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/split_cell.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "triplex/field/input_check.hpp"
#include "triplex/field/orientation.hpp"

namespace triplex {
namespace {

/// A reference cell in VTK's order: a convex cell with planar faces, and its quadrilaterals.
struct Reference {
  CellShape shape;
  std::size_t tets;
  double six_volumes;
  std::vector<Point> corners;
  std::vector<std::array<int, 4>> quads;
  std::vector<std::array<int, 3>> triangles;
};

const std::vector<Reference>& references() {
  static const std::vector<Reference> cells = {
      {CellShape::Hexahedron,
       6,
       6,
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
       {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
       {}},
      {CellShape::Wedge,
       3,
       3,
       {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 0, 1}},
       {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
       {{0, 1, 2}, {3, 4, 5}}},
      {CellShape::Pyramid,
       2,
       2,
       {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
       {{0, 1, 2, 3}},
       {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}};
  return cells;
}

using Triangle = std::set<int>;

/// The triangles that the rule makes of the faces, for corners of the given ranks.
std::set<Triangle> expected_boundary(const Reference& cell, const std::vector<int>& rank) {
  std::set<Triangle> faces;
  for (const auto& t : cell.triangles) faces.insert({t[0], t[1], t[2]});
  for (const auto& q : cell.quads) {
    int k = 0;
    for (int i = 1; i < 4; ++i) {
      if (rank[q[i]] < rank[q[k]]) k = i;
    }
    faces.insert({q[k], q[(k + 1) % 4], q[(k + 2) % 4]});
    faces.insert({q[k], q[(k + 2) % 4], q[(k + 3) % 4]});
  }
  return faces;
}

/// The triangles that belong to one tet only; none may belong to more than two.
std::set<Triangle> boundary_of(const CellTets& tets) {
  std::map<Triangle, int> uses;
  for (const auto& t : tets) {
    for (int skip = 0; skip < 4; ++skip) {
      Triangle face;
      for (int i = 0; i < 4; ++i) {
        if (i != skip) face.insert(t[i]);
      }
      ++uses[face];
    }
  }
  std::set<Triangle> boundary;
  for (const auto& [face, count] : uses) {
    EXPECT_LE(count, 2);
    if (count == 1) boundary.insert(face);
  }
  return boundary;
}

double six_volumes(const Point& a, const Point& b, const Point& c, const Point& d) {
  double u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
         (u[0] * v[1] - u[1] * v[0]) * w[2];
}

TEST(SplitCell, EveryOrderOfTheCornersIsCutByTheRule) {
  for (const Reference& cell : references()) {
    std::vector<int> rank(corner_count(cell.shape));
    ASSERT_EQ(rank.size(), cell.corners.size());
    std::iota(rank.begin(), rank.end(), 0);
    do {
      std::vector<Point> ranked;
      for (const int r : rank) ranked.push_back({0, -1.0, static_cast<double>(r)});
      const CellTets tets = split_cell(cell.shape, ranked);
      ASSERT_EQ(tets.size(), cell.tets);
      ASSERT_EQ(boundary_of(tets), expected_boundary(cell, rank));
      double sum = 0;
      for (const auto& t : tets) {
        const auto& x = cell.corners;
        const double part = six_volumes(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
        ASSERT_GT(part, 0);
        sum += part;
      }
      ASSERT_EQ(sum, cell.six_volumes);
    } while (std::next_permutation(rank.begin(), rank.end()));
  }
}

/// The tets as sets of points.
std::set<std::set<Point>> geometry(CellShape shape, const std::vector<Point>& corners) {
  std::set<std::set<Point>> result;
  for (const auto& t : split_cell(shape, corners)) {
    result.insert({corners[t[0]], corners[t[1]], corners[t[2]], corners[t[3]]});
  }
  return result;
}

TEST(SplitCell, TheNumberingOfTheCornersDoesNotMatter) {
  // A quarter turn about the axis 0-4, and one about the axis through the sides x = const.
  const std::vector<int> turns[] = {{1, 2, 3, 0, 5, 6, 7, 4}, {4, 5, 1, 0, 7, 6, 2, 3}};
  std::vector<Point> corners = references()[0].corners;
  corners[6] = {1.25, 1.125, 1.0625};  // no two faces alike, none planar there
  corners[0] = {-0.125, 0.0625, 0.25};
  const auto expected = geometry(CellShape::Hexahedron, corners);
  for (int i = 0; i < 24; ++i) {
    for (const auto& turn : turns) {
      std::vector<Point> turned;
      for (const int c : turn) turned.push_back(corners[c]);
      corners = turned;
      EXPECT_EQ(geometry(CellShape::Hexahedron, corners), expected);
    }
  }
}

TEST(SplitCell, CoordinatesAreComparedInTheOrderXYZ) {
  std::vector<Point> corners = references()[2].corners;
  const auto apex_of = [&] { return (*split_cell(CellShape::Pyramid, corners).begin())[3]; };
  EXPECT_EQ(apex_of(), 0);
  corners[3][1] = -0.5;  // as low as corner 0 in x, lower in y
  EXPECT_EQ(apex_of(), 3);
  corners[4][0] = -1;
  EXPECT_EQ(apex_of(), 4);
}

// ---- what the input check says about split cells ----

TensorField field_of(const Reference& cell) {
  TensorField field;
  field.mesh.points = cell.corners;
  field.tensors.resize(cell.corners.size());
  for (const auto& t : split_cell(cell.shape, cell.corners)) {
    field.mesh.tets.push_back({VertexId{t[0]}, VertexId{t[1]}, VertexId{t[2]}, VertexId{t[3]}});
    field.source_cells.push_back(17);
  }
  return field;
}

std::string message_of(const TensorField& field) {
  try {
    check_input(field);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SplitCell, PassesTheInputCheckOrIsNamed) {
  using testing::AllOf;
  using testing::HasSubstr;
  for (const Reference& cell : references()) {
    EXPECT_EQ(message_of(field_of(cell)), "accepted");
    Reference mirrored = cell, flat = cell;
    for (Point& x : mirrored.corners) x[0] = -x[0];
    EXPECT_THAT(message_of(field_of(mirrored)),
                AllOf(HasSubstr("cell 17 (part with points "), HasSubstr("inverted"),
                      HasSubstr("--fix-orientation, or mesh again")));
    for (Point& x : flat.corners) x = {x[0] + 4 * x[2], x[1], 0};
    EXPECT_THAT(message_of(field_of(flat)),
                AllOf(HasSubstr("cell 17 (part with"), HasSubstr("no volume")));
  }
}

}  // namespace
}  // namespace triplex

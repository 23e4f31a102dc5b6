// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cells that are no tets.
#include <gmock/gmock.h>
#include <vtkCellType.h>
#include <vtkIdList.h>

#include <algorithm>
#include <set>

#include "reading.hpp"
#include "triplex/field/grid.hpp"
#include "vtk_files.hpp"

namespace triplex {
namespace {

using test::add_array;
using test::Cell;
using test::GridPointer;
using test::linear_tensor;
using test::make_grid;
using test::message_of;
using test::TemporaryDirectory;
using test::write_vtu;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

TensorField read(const GridPointer& grid, const ReadOptions& options = {}) {
  const TemporaryDirectory directory;
  if (grid->GetPointData()->GetArray("tensor") == nullptr) {
    add_array(*grid, "tensor", 9, linear_tensor);
  }
  write_vtu(directory / "a.vtu", *grid);
  return read_field(directory / "a.vtu", options);
}

std::string refusal(const GridPointer& grid, const ReadOptions& options = {}) {
  const TemporaryDirectory directory;
  if (grid->GetPointData()->GetArray("tensor") == nullptr) {
    add_array(*grid, "tensor", 9, linear_tensor);
  }
  write_vtu(directory / "a.vtu", *grid);
  return message_of(directory / "a.vtu", options);
}

const std::vector<Point> kCube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// A cube, a pyramid on its right, a tet on its top and a wedge below: all kinds share faces.
GridPointer mixed_mesh() {
  std::vector<Point> points = kCube;
  points.push_back({2, 0.5, 0.75});   // 8: apex right of the cube
  points.push_back({1.75, 0.25, 2});  // 9: tet on the pyramid's upper side
  points.push_back({0.25, 0.5, -1});  // 10, 11: edge of a wedge below the cube
  points.push_back({0.75, 0.5, -1.25});
  return make_grid(points, {{VTK_TETRA, {5, 8, 6, 9}},
                            {VTK_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7}},
                            {VTK_PYRAMID, {1, 2, 6, 5, 8}},
                            {VTK_WEDGE, {0, 3, 10, 1, 2, 11}}});
}

/// The tets as sets of points.
std::set<std::set<Point>> geometry(const TensorField& field) {
  std::set<std::set<Point>> tets;
  for (const auto& t : field.mesh.tets) {
    std::set<Point> corners;
    for (const VertexId v : t) corners.insert(field.mesh.points[index(v)]);
    tets.insert(corners);
  }
  return tets;
}

TEST(Cells, OfAllKindsAreSplitConformingly) {
  const TensorField field = read(mixed_mesh());  // the input check finds no gap, no overlap
  EXPECT_EQ(field.mesh.tets.size(), 1u + 6 + 2 + 3);
  EXPECT_THAT(field.source_cells, ElementsAre(0, 1, 1, 1, 1, 1, 1, 2, 2, 3, 3, 3));
  EXPECT_EQ(field.split.hexahedra, 1u);
  EXPECT_EQ(field.split.pyramids, 1u);
  EXPECT_EQ(field.split.wedges, 1u);
  EXPECT_EQ(field.split.total(), 3u);
}

TEST(Cells, ThatAreTetsCountAsNotSplit) {
  const TensorField field = read(make_grid(kCube, {{VTK_TETRA, {0, 1, 3, 4}}}));
  EXPECT_EQ(field.split.total(), 0u);
  EXPECT_TRUE(field.source_cells.empty());
}

TEST(Cells, RenumberingGivesTheSameTets) {
  const auto expected = geometry(read(mixed_mesh()));
  const GridPointer original = mixed_mesh();
  const vtkIdType count = original->GetNumberOfPoints();
  // Cells are listed backwards, points by another permutation, corners from another side.
  const auto renamed = [&](vtkIdType i) { return (5 * i + 3) % count; };
  ASSERT_EQ(count, 12);
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    original->GetPoint(i, points[static_cast<std::size_t>(renamed(i))].data());
  }
  const std::vector<Cell> cells = {{VTK_WEDGE, {2, 1, 11, 3, 0, 10}},
                                   {VTK_PYRAMID, {6, 5, 1, 2, 8}},
                                   {VTK_HEXAHEDRON, {5, 1, 0, 4, 6, 2, 3, 7}},
                                   {VTK_TETRA, {8, 6, 5, 9}}};
  std::vector<Cell> shuffled;
  for (Cell cell : cells) {
    for (vtkIdType& v : cell.points) v = renamed(v);
    shuffled.push_back(cell);
  }
  EXPECT_EQ(geometry(read(make_grid(points, shuffled))), expected);
}

/// n^3 cells of the unit cube, some cut into two wedges; `warp` moves the points.
GridPointer brick(int n, int type, bool wedges, double warp) {
  std::vector<Point> points;
  const auto id = [&](int i, int j, int k) { return vtkIdType{(k * (n + 1) + j) * (n + 1) + i}; };
  for (int k = 0; k <= n; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const double bump = warp * ((i * 7 + j * 5 + k * 3) % 4 - 1.5) / n;
        points.push_back({i * 1.0 / n + bump, j * 1.0 / n - bump / 2, k * 1.0 / n + bump * bump});
      }
    }
  }
  std::vector<Cell> cells;
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const vtkIdType v[8] = {
            id(i, j, k),     id(i + 1, j, k),     id(i + 1, j + 1, k),     id(i, j + 1, k),
            id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1)};
        if (wedges && i % 2 == 1) {  // cut along the edges 1-3 and 5-7
          cells.push_back({VTK_WEDGE, {v[0], v[3], v[1], v[4], v[7], v[5]}});
          cells.push_back({VTK_WEDGE, {v[1], v[3], v[2], v[5], v[7], v[6]}});
        } else if (type == VTK_VOXEL) {
          cells.push_back({type, {v[0], v[1], v[3], v[2], v[4], v[5], v[7], v[6]}});
        } else {
          cells.push_back({type, {v, v + 8}});
        }
      }
    }
  }
  return make_grid(points, cells);
}

TEST(Cells, WithFacesThatAreNotPlanarConform) {
  const TensorField field = read(brick(4, VTK_HEXAHEDRON, false, 0.1));
  EXPECT_EQ(field.mesh.tets.size(), 6u * 64);
  const TensorField mixed = read(brick(4, VTK_HEXAHEDRON, true, 0.1));
  EXPECT_EQ(mixed.mesh.tets.size(), 6u * 64);
  EXPECT_EQ(mixed.split.hexahedra, 32u);
  EXPECT_EQ(mixed.split.wedges, 64u);
}

TEST(Cells, VoxelsAreHexahedraInAnotherOrder) {
  const TensorField field = read(brick(3, VTK_VOXEL, false, 0));
  EXPECT_EQ(geometry(field), geometry(read(brick(3, VTK_HEXAHEDRON, false, 0))));
  EXPECT_EQ(field.split.hexahedra, 27u);
}

TEST(Cells, OfARegularGridGetKuhnsCut) {
  TensorField kuhn;
  kuhn.mesh = grid_mesh({.n = 4, .split = CellSplit::Six}, {});
  EXPECT_EQ(geometry(read(brick(4, VTK_VOXEL, false, 0))), geometry(kuhn));
}

TEST(Cells, MirroredAreTurnedAround) {
  const GridPointer hex = make_grid(kCube, {{VTK_HEXAHEDRON, {4, 5, 6, 7, 0, 1, 2, 3}}});
  EXPECT_THAT(refusal(hex), AllOf(HasSubstr("cell 0 (part with"), HasSubstr("inverted"),
                                  HasSubstr("--fix-orientation")));
  EXPECT_EQ(read(hex, {.fix_orientation = true}).mesh.tets.size(), 6u);
}

TEST(Cells, ThatAreFoldedOrFlatAreNamedByTheirIdInTheFile) {
  std::vector<Point> points = kCube;
  for (const Point& x : kCube) points.push_back({x[0] + 3, x[1], x[2]});
  const Cell good{VTK_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7}};
  const Cell other{VTK_HEXAHEDRON, {8, 9, 10, 11, 12, 13, 14, 15}};
  points[14] = {3.5, -0.5, 0.5};  // a corner pushed through the opposite side
  EXPECT_THAT(refusal(make_grid(points, {good, other})),
              AllOf(HasSubstr("cell 1 (part with points"), HasSubstr("inverted")));
  EXPECT_NE(refusal(make_grid(points, {good, other}), {.fix_orientation = true}), "accepted");
  for (std::size_t i = 8; i < 16; ++i)
    points[i] = {3 + 0.1 * static_cast<double>(i), points[i][1], 0};
  EXPECT_THAT(refusal(make_grid(points, {good, other})),
              AllOf(HasSubstr("cell 1 (part with"), HasSubstr("no volume")));
  const Cell collapsed{VTK_HEXAHEDRON, {0, 1, 1, 0, 4, 5, 6, 7}};
  EXPECT_THAT(refusal(make_grid(kCube, {collapsed})),
              AllOf(HasSubstr("cell 0 (part with points"), HasSubstr("same point twice")));
}

TEST(Cells, WithTheWrongNumberOfPointsAreRefused) {
  test::VtuText vtu;
  for (const auto& [type, name] :
       {std::pair{10, "tet"}, {11, "voxel"}, {12, "hexahedron"}, {13, "wedge"}, {14, "pyramid"}}) {
    vtu.types = {10, type};
    vtu.connectivity = {0, 1, 2, 3, 0, 2, 1};
    vtu.offsets = {4, 7};
    EXPECT_THAT(message_of(vtu), HasSubstr("cell 1 is a " + std::string(name) + " with 3 points"));
  }
  vtu.types = {10, 14};
  vtu.connectivity = {0, 1, 2, 3, 0, 2, 1, 4, 7};
  vtu.offsets = {4, 9};
  EXPECT_THAT(message_of(vtu), HasSubstr("cell 1 refers to point 7"));
}

TEST(Cells, OfOtherKindsAreRefused) {
  std::vector<Point> points = kCube;
  for (std::size_t i = 0; i < 12; ++i) points.push_back({0.5, 0.5, 2 + static_cast<double>(i)});
  const Cell tet{VTK_TETRA, {0, 1, 3, 4}};
  const auto consecutive = [](int n) {
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < n; ++i) ids.push_back(i);
    return ids;
  };
  for (const auto& [type, size, cure] : {std::tuple{VTK_TRIANGLE, 3, "Extract Cells By Type"},
                                         {VTK_QUAD, 4, "Extract Cells By Type"},
                                         {VTK_LINE, 2, "Extract Cells By Type"},
                                         {VTK_VERTEX, 1, "Extract Cells By Type"},
                                         {VTK_QUADRATIC_TRIANGLE, 6, "corners only"},
                                         {VTK_QUADRATIC_TETRA, 10, "corners only"},
                                         {VTK_QUADRATIC_HEXAHEDRON, 20, "corners only"},
                                         {VTK_LAGRANGE_TETRAHEDRON, 10, "corners only"},
                                         {VTK_PENTAGONAL_PRISM, 10, "Tetrahedralize"},
                                         {VTK_HEXAGONAL_PRISM, 12, "Tetrahedralize"}}) {
    EXPECT_THAT(refusal(make_grid(points, {tet, {type, consecutive(size)}})),
                AllOf(HasSubstr("cell 1 is no tet"), HasSubstr("type " + std::to_string(type)),
                      HasSubstr(cure)));
  }
  const GridPointer polyhedra = make_grid(points, {});
  const vtkIdType faces[] = {4, 3, 0, 1, 3, 3, 0, 1, 4, 3, 1, 3, 4, 3, 0, 3, 4};
  vtkNew<vtkIdList> stream;
  for (const vtkIdType i : faces) stream->InsertNextId(i);
  polyhedra->InsertNextCell(VTK_POLYHEDRON, stream);
  EXPECT_THAT(refusal(polyhedra), AllOf(HasSubstr("vtkPolyhedron"), HasSubstr("Tetrahedralize")));
  EXPECT_THAT(refusal(make_grid(kCube, {{VTK_TRIANGLE, {0, 1, 2}}, {VTK_TRIANGLE, {0, 2, 3}}})),
              HasSubstr("cell 0 is no tet"));
}

}  // namespace
}  // namespace triplex

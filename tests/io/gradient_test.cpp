// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tensors that are the gradient of a vector array.
#include <gmock/gmock.h>
#include <vtkCellType.h>
#include <vtkGradientFilter.h>

#include <cmath>
#include <limits>

#include "reading.hpp"
#include "triplex/field/generators.hpp"
#include "vtk_files.hpp"

namespace triplex {
namespace {

using test::add_array;
using test::Cell;
using test::GridPointer;
using test::make_grid;
using test::message_of;
using test::read_text;
using test::TemporaryDirectory;
using test::VtuText;
using test::write_content;
using test::write_vtu;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<double> linear(const Point& x) {
  return {2 * x[1], -x[0] + 0.5 * x[2], 3 * x[0] + 4 * x[1] - x[2]};
}
constexpr Tensor<double> kLinearGradient{0, 2, 0, -1, 0, 0.5, 3, 4, -1};

std::vector<double> curved(const Point& x) {
  return {std::sin(x[0]) * x[1], x[2] * x[2] - x[0], x[0] * x[1] * x[2]};
}

/// A jittered grid of tets.
GridPointer tets(int n) {
  const TetMesh mesh = grid_mesh({.n = n, .jitter = 0.2}, {});
  std::vector<Cell> cells;
  for (const auto& t : mesh.tets) {
    cells.push_back({VTK_TETRA, {}});
    for (const VertexId v : t) cells.back().points.push_back(static_cast<vtkIdType>(index(v)));
  }
  return make_grid(mesh.points, cells);
}

/// Two hexahedra that are no boxes, with a pyramid and a wedge at their sides.
GridPointer other_cells() {
  return make_grid({{0, 0, 0},
                    {1, 0, 0},
                    {1, 1.25, 0},
                    {0, 1, 0},
                    {0, 0, 1.125},
                    {1, 0, 1},
                    {1, 1, 1.5},
                    {0, 1, 1},
                    {2, 0.5, 0.75},
                    {0.25, 0.5, -1},
                    {0.75, 0.5, -1.25}},
                   {{VTK_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7}},
                    {VTK_PYRAMID, {1, 2, 6, 5, 8}},
                    {VTK_WEDGE, {0, 3, 9, 1, 2, 10}}});
}

TensorField read(const GridPointer& grid, const ReadOptions& options = {.gradient_of = "U"}) {
  const TemporaryDirectory directory;
  write_vtu(directory / "a.vtu", *grid);
  return read_field(directory / "a.vtu", options);
}

std::string refusal(const GridPointer& grid, const ReadOptions& options = {.gradient_of = "U"}) {
  const TemporaryDirectory directory;
  write_vtu(directory / "a.vtu", *grid);
  return message_of(directory / "a.vtu", options);
}

TEST(Gradient, OfALinearFieldIsItsMatrixRowByRow) {
  for (const GridPointer& grid : {tets(3), other_cells()}) {
    add_array(*grid, "U", 3, linear);
    const TensorField field = read(grid);
    EXPECT_EQ(field.array_name, "gradient of U");
    for (const auto& t : field.tensors) {
      for (int i = 0; i < 9; ++i) EXPECT_NEAR(t[i], kLinearGradient[i], 1e-13);
    }
  }
}

TEST(Gradient, IsThatOfVtkBitForBit) {
  for (const GridPointer& grid : {tets(4), other_cells()}) {
    add_array(*grid, "U", 3, curved);
    const TensorField field = read(grid);
    vtkNew<vtkGradientFilter> filter;
    filter->SetInputData(grid);
    filter->SetInputScalars(vtkDataObject::FIELD_ASSOCIATION_POINTS, "U");
    filter->Update();
    auto* expected =
        vtkDataSet::SafeDownCast(filter->GetOutput())->GetPointData()->GetArray("Gradients");
    ASSERT_NE(expected, nullptr);
    ASSERT_EQ(static_cast<std::size_t>(expected->GetNumberOfTuples()), field.tensors.size());
    for (std::size_t i = 0; i < field.tensors.size(); ++i) {
      Tensor<double> t;
      expected->GetTuple(static_cast<vtkIdType>(i), t.data());
      EXPECT_EQ(field.tensors[i], t) << i;
    }
  }
}

TEST(Gradient, IsTransposedOnDemand) {
  const GridPointer grid = tets(2);
  add_array(*grid, "U", 3, curved);
  const TensorField field = read(grid);
  const TensorField transposed = read(grid, {.gradient_of = "U", .transpose = true});
  for (std::size_t i = 0; i < field.tensors.size(); ++i) {
    for (int k = 0; k < 9; ++k) {
      EXPECT_EQ(field.tensors[i][k], transposed.tensors[i][3 * (k % 3) + k / 3]);
    }
  }
}

TEST(Gradient, OfFloatsIsComputedInDoubles) {
  const GridPointer floats = tets(2), doubles = tets(2);
  const auto rounded = [](const Point& x) {
    std::vector<double> u = curved(x);
    for (double& value : u) value = static_cast<double>(static_cast<float>(value));
    return u;
  };
  add_array<vtkFloatArray>(*floats, "U", 3, rounded);
  add_array(*doubles, "U", 3, rounded);
  EXPECT_EQ(read(floats).tensors, read(doubles).tensors);
}

TEST(Gradient, IsTakenWhereTensorsAreStoredToo) {
  const GridPointer grid = tets(2);
  add_array(*grid, "U", 3, linear);
  add_array(*grid, "tensor", 9, test::linear_tensor);
  EXPECT_EQ(read(grid, {}).array_name, "tensor");
  EXPECT_EQ(read(grid).array_name, "gradient of U");
}

TEST(Gradient, LeavesOutPointsWithoutCells) {
  VtuText vtu;
  vtu.points.insert(vtu.points.end(), {9, 9, 9});
  vtu.point_data = {{"U", 3, std::vector<double>(18, 1), "Float64"}};
  vtu.point_data[0].values[17] = 7;
  const TensorField field = read_text(vtu, {.gradient_of = "U"});
  EXPECT_EQ(field.mesh.points.size(), 5u);
  for (const auto& t : field.tensors) EXPECT_EQ(t, Tensor<double>{});
}

TEST(Gradient, DoesNotSeeGhostCells) {
  VtuText vtu;
  vtu.point_data = {{"U", 3, std::vector<double>(15), "Float64"}};
  vtu.point_data[0].values[3] = 1;   // du/dx at point 1
  vtu.point_data[0].values[14] = 5;  // of the ghost's own point
  vtu.cell_data = {{"vtkGhostType", 1, {0, 1}, "UInt8"}};
  const TensorField field = read_text(vtu, {.gradient_of = "U"});
  ASSERT_EQ(field.tensors.size(), 4u);
  for (const auto& t : field.tensors) EXPECT_EQ(t, (Tensor<double>{1, 0, 0, 0, 0, 0, 0, 0, 0}));
}

/// `VtuText` cut into its two tets, as pieces with the vectors `curved`.
class GradientOfPieces : public testing::Test {
 protected:
  static void set_vectors(VtuText& vtu) {
    vtu.point_data = {{"U", 3, {}, "Float64"}};
    for (std::size_t i = 0; i < vtu.points.size(); i += 3) {
      const auto u = curved({vtu.points[i], vtu.points[i + 1], vtu.points[i + 2]});
      vtu.point_data[0].values.insert(vtu.point_data[0].values.end(), u.begin(), u.end());
    }
  }
  GradientOfPieces() {
    set_vectors(whole_);
    first_.points.resize(12);
    first_.connectivity = {0, 1, 2, 3};
    second_.points = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
    second_.connectivity = {2, 3, 0, 1};
    for (VtuText* piece : {&first_, &second_}) {
      piece->offsets = {4};
      piece->types = {10};
      set_vectors(*piece);
    }
  }
  std::filesystem::path write() {
    write_content(directory_ / "p0.vtu", first_.text());
    write_content(directory_ / "p1.vtu", second_.text());
    std::string text = test::pvtu_text({"p0.vtu", "p1.vtu"}, false);
    const std::string old = "Name=\"tensor\" NumberOfComponents=\"9\"";
    write_content(directory_ / "all.pvtu",
                  text.replace(text.find(old), old.size(), "Name=\"U\" NumberOfComponents=\"3\""));
    return directory_ / "all.pvtu";
  }

  TemporaryDirectory directory_;
  VtuText whole_, first_, second_;
};

TEST_F(GradientOfPieces, IsThatOfTheWhole) {
  const TensorField whole = read_text(whole_, {.gradient_of = "U"});
  EXPECT_TRUE(test::same_bits(read_field(write(), {.gradient_of = "U"}), whole));
}

TEST_F(GradientOfPieces, CountsRepeatedCellsOnce) {
  first_.connectivity = {0, 1, 2, 3, 0, 1, 2, 3};  // another copy of its cell, unflagged
  first_.offsets = {4, 8};
  first_.types = {10, 10};
  const TensorField whole = read_text(whole_, {.gradient_of = "U"});
  EXPECT_TRUE(test::same_bits(read_field(write(), {.gradient_of = "U"}), whole));
}

TEST_F(GradientOfPieces, NeedsEqualVectors) {
  second_.point_data[0].values[7] += 0x1p-40;
  EXPECT_THAT(message_of(write(), {.gradient_of = "U"}),
              AllOf(HasSubstr("the pieces disagree: points 0 and 6 both lie at (0, 0, 0)"),
                    HasSubstr("vectors differ")));
}

TEST_F(GradientOfPieces, JoinsMergedPointsFirst) {
  VtuText vtu = whole_;  // the second tet has points of its own
  for (const int old : {0, 2, 1}) {
    for (int k = 0; k < 3; ++k) {
      vtu.points.push_back(vtu.points[3 * old + k]);
      vtu.point_data[0].values.push_back(vtu.point_data[0].values[3 * old + k]);
    }
  }
  vtu.connectivity = {0, 1, 2, 3, 5, 6, 7, 4};
  EXPECT_THAT(message_of(vtu, {.gradient_of = "U"}), HasSubstr("coincides with point"));
  const TensorField whole = read_text(whole_, {.gradient_of = "U"});
  EXPECT_TRUE(test::same_bits(read_text(vtu, {.gradient_of = "U", .merge_points = true}), whole));
}

// ---- what is refused ----

TEST(Gradient, NeedsAVectorArray) {
  VtuText vtu;
  const ReadOptions options{.gradient_of = "U"};
  EXPECT_THAT(message_of(vtu, options), AllOf(HasSubstr("there is no point array U"),
                                              HasSubstr("no point arrays with 3 components")));
  vtu.point_data.push_back({"velocity", 3, std::vector<double>(15), "Float64"});
  vtu.point_data.push_back({"displacement", 3, std::vector<double>(15), "Float32"});
  EXPECT_THAT(message_of(vtu, options),
              AllOf(HasSubstr("no point array U"), HasSubstr("velocity, displacement"),
                    Not(HasSubstr("tensor"))));
  vtu.point_data.push_back({"U", 1, std::vector<double>(5), "Float64"});
  EXPECT_THAT(message_of(vtu, options),
              AllOf(HasSubstr("U has 1 component, but --gradient-of needs 3"),
                    HasSubstr("velocity, displacement")));
  EXPECT_THAT(message_of(vtu, {.gradient_of = "tensor"}), HasSubstr("tensor has 9 components"));
  vtu.cell_data = {{"W", 3, std::vector<double>(6), "Float64"}};
  EXPECT_THAT(message_of(vtu, {.gradient_of = "W"}),
              AllOf(HasSubstr("W is cell data"), HasSubstr("Cell Data to Point Data")));
  EXPECT_THAT(message_of(vtu, {.tensor_name = "tensor", .gradient_of = "velocity"}),
              AllOf(HasSubstr("--tensor"), HasSubstr("--gradient-of"), HasSubstr("leave one out")));
  EXPECT_THAT(message_of(vtu, {.gradient_of = "velocity", .symmetric_order = "xx,yy,zz,xy,yz,xz"}),
              HasSubstr("leave one out"));
  EXPECT_THAT(message_of(vtu, {.tensor_name = "velocity"}),
              AllOf(HasSubstr("has 3 components"), HasSubstr("--gradient-of")));
  vtu.point_data.erase(vtu.point_data.begin());
  EXPECT_THAT(message_of(vtu),
              AllOf(HasSubstr("no point array has 9 components"), HasSubstr("--gradient-of")));
}

TEST(Gradient, NeedsFiniteNumbers) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const GridPointer grid = tets(2);
  add_array(*grid, "U", 3, linear);
  auto& values = *grid->GetPointData()->GetArray("U");
  for (const double bad : {kInfinity, std::nan("")}) {
    values.SetComponent(5, 1, bad);
    EXPECT_THAT(refusal(grid), AllOf(HasSubstr("the vector U of point 5 at ("),
                                     HasSubstr("component 1 = "), HasSubstr("finite")));
  }
  values.SetComponent(5, 1, 1.7e308);
  values.SetComponent(0, 1, -1.7e308);
  EXPECT_THAT(refusal(grid), AllOf(HasSubstr("the gradient of U at point "), HasSubstr("finite")));
  values.SetComponent(5, 1, 0);
  values.SetComponent(0, 1, 0);
  grid->GetPoints()->SetPoint(3, 0, std::nan(""), 0);
  EXPECT_THAT(refusal(grid), AllOf(HasSubstr("point 3 at ("), HasSubstr("coordinate")));
}

TEST(Gradient, NamesDegenerateCells) {
  const auto refused = [](const std::vector<Point>& points, const Cell& bad) {
    const GridPointer grid = make_grid(points, {{VTK_TETRA, {0, 1, 2, 3}}, bad});
    add_array(*grid, "U", 3, linear);
    return refusal(grid);
  };
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},   {0, 0, 1},
                                     {5, 0, 0}, {6, 0, 0}, {5.5, 1, 0}, {5.25, 0.25, 0}};
  EXPECT_THAT(refused(points, {VTK_TETRA, {4, 5, 6, 7}}),
              AllOf(HasSubstr("cell 1 "), HasSubstr("no volume")));
  EXPECT_THAT(refused(points, {VTK_TETRA, {4, 5, 6, 6}}),
              AllOf(HasSubstr("cell 1 "), HasSubstr("no volume")));
  EXPECT_THAT(refused(points, {VTK_PYRAMID, {4, 5, 6, 7, 6}}),
              AllOf(HasSubstr("cell 1 "), HasSubstr("no volume")));
}

}  // namespace
}  // namespace triplex

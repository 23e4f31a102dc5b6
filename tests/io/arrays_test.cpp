// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Symmetric tensors, transposes, and types of numbers.
#include <gmock/gmock.h>
#include <vtkCellType.h>

#include <algorithm>
#include <limits>

#include "reading.hpp"
#include "vtk_files.hpp"

namespace triplex {
namespace {

using test::message_of;
using test::read_text;
using test::VtuText;
using testing::AllOf;
using testing::HasSubstr;

/// A field with tensors of six components 6 i + k.
VtuText symmetric() {
  VtuText vtu;
  vtu.point_data = {{"stress", 6, {}, "Float64"}};
  for (int i = 0; i < 30; ++i) vtu.point_data[0].values.push_back(0.1 * i);
  return vtu;
}

constexpr const char* kVtkOrder = "xx,yy,zz,xy,yz,xz";
constexpr const char* kFoamOrder = "xx,xy,xz,yy,yz,zz";

TEST(SymmetricTensors, FollowTheOrderGiven) {
  const VtuText vtu = symmetric();
  const auto expect = [&](const char* order, const std::array<int, 9>& component) {
    const TensorField field = read_text(vtu, {.symmetric_order = order});
    ASSERT_EQ(field.tensors.size(), 5u);
    for (std::size_t p = 0; p < 5; ++p) {
      for (std::size_t k = 0; k < 9; ++k) {
        EXPECT_EQ(field.tensors[p][k],
                  vtu.point_data[0].values[6 * p + static_cast<std::size_t>(component[k])])
            << order;
      }
    }
  };
  expect(kVtkOrder, {0, 3, 5, 3, 1, 4, 5, 4, 2});
  expect(kFoamOrder, {0, 1, 2, 1, 3, 4, 2, 4, 5});
  expect("zz,yx,xz,yy,xx,zy", {4, 1, 2, 1, 3, 5, 2, 5, 0});
}

TEST(SymmetricTensors, AreSymmetricBitForBitAlsoAsFloatsAndTransposed) {
  VtuText vtu = symmetric();
  vtu.point_data[0].type = "Float32";
  const TensorField field = read_text(vtu, {.symmetric_order = kVtkOrder});
  EXPECT_EQ(field.tensors[0][1], static_cast<double>(static_cast<float>(0.1 * 3)));
  for (const auto& t : field.tensors) {
    EXPECT_TRUE(t[1] == t[3] && t[2] == t[6] && t[5] == t[7]);
  }
  EXPECT_EQ(read_text(vtu, {.transpose = true, .symmetric_order = kVtkOrder}).tensors,
            field.tensors);
}

TEST(SymmetricTensors, NeedTheOrder) {
  VtuText vtu = symmetric();
  const auto cure = AllOf(HasSubstr(std::string("--symmetric-order ") + kVtkOrder + " (VTK"),
                          HasSubstr(std::string(kFoamOrder) + " (OpenFOAM)"));
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("stress (6)"), cure));
  EXPECT_THAT(message_of(vtu, {.tensor_name = "stress"}),
              AllOf(HasSubstr("stress has 6 components"), cure));
  for (const char* order :
       {"xx", "xx,yy,zz,xy,yz", "xx,yy,zz,xy,yz,yx", "xx,yy,zz,xy,yz,xz,xx", "xx yy zz xy yz xz",
        "xx,yy,zz,xy,yz,xw", "xx,yy,zz,xy,yz,", ",xx,yy,zz,xy,yz,xz", "vtk", ","}) {
    EXPECT_THAT(message_of(vtu, {.symmetric_order = order}),
                AllOf(HasSubstr("is no order"), HasSubstr("each of xx, yy, zz, xy, yz, xz once")))
        << order;
  }
}

TEST(SymmetricTensors, AreChosenAmongArraysOfSixComponents) {
  VtuText vtu = symmetric();
  vtu.point_data.push_back({"tensor", 9, VtuText::tensors(5), "Float64"});
  const ReadOptions options{.symmetric_order = kVtkOrder};
  EXPECT_EQ(read_text(vtu).array_name, "tensor");
  EXPECT_EQ(read_text(vtu, options).array_name, "stress");
  EXPECT_THAT(message_of(vtu, {.tensor_name = "tensor", .symmetric_order = kVtkOrder}),
              AllOf(HasSubstr("tensor has 9 components"), HasSubstr("leave it out")));
  vtu.point_data.push_back({"strain", 6, std::vector<double>(30), "Float64"});
  EXPECT_THAT(message_of(vtu, options),
              AllOf(HasSubstr("several point arrays have 6 components: stress, strain"),
                    HasSubstr("--tensor")));
  EXPECT_EQ(read_text(vtu, {.tensor_name = "strain", .symmetric_order = kVtkOrder}).array_name,
            "strain");
  vtu.point_data = {{"tensor", 9, VtuText::tensors(5), "Float64"}};
  EXPECT_THAT(message_of(vtu, options),
              AllOf(HasSubstr("no point array has 6 components"), HasSubstr("tensor (9)")));
}

TEST(Transpose, SwapsRowsAndColumnsBitForBit) {
  const TensorField field = read_text({}), transposed = read_text({}, {.transpose = true});
  for (std::size_t i = 0; i < field.tensors.size(); ++i) {
    for (int k = 0; k < 9; ++k) {
      EXPECT_EQ(field.tensors[i][k], transposed.tensors[i][3 * (k % 3) + k / 3]);
    }
  }
  EXPECT_EQ(field.mesh.points, transposed.mesh.points);
}

TEST(Numbers, FloatsAreTakenOverExactly) {
  const auto grid = test::make_grid({{0, 0, 0}, {0.1, 0, 0}, {0, 0.7, 0}, {0, 0, 1e-30}},
                                    {{VTK_TETRA, {0, 1, 2, 3}}}, VTK_FLOAT);
  test::add_array<vtkFloatArray>(*grid, "tensor", 9, [](const Point&) {
    return std::vector<double>{0.1, 1e38, -1e-45, 1.0 / 3, -0.0, 5, 6, 7, 16777217};
  });
  const test::TemporaryDirectory directory;
  for (const char* name : {"a.vtu", "a.vtk"}) {
    if (std::string(name) == "a.vtu") {
      test::write_vtu(directory / name, *grid);
    } else {
      test::write_vtk(directory / name, *grid, true);
    }
    const TensorField field = read_field(directory / name);
    EXPECT_EQ(field.mesh.points[1][0], static_cast<double>(0.1f));
    EXPECT_EQ(field.mesh.points[2][1], static_cast<double>(0.7f));
    EXPECT_EQ(field.mesh.points[3][2], static_cast<double>(1e-30f));
    const Tensor<double> expected{0.1f, 1e38f, -1e-45f, 1.0f / 3, -0.0f, 5, 6, 7, 16777216};
    for (const auto& t : field.tensors) EXPECT_EQ(t, expected);
  }
}

TEST(Numbers, IntegersAreExactOrRefused) {
  VtuText vtu;
  for (const char* type : {"Int8", "Int16", "Int32", "UInt8", "UInt32"}) {
    vtu.point_data = {{"tensor", 9, std::vector<double>(45, 7), type}};
    EXPECT_EQ(read_text(vtu).tensors[4][8], 7) << type;
  }
  vtu.point_data = {{"tensor", 9, std::vector<double>(45, 4294967295.0), "UInt32"}};
  EXPECT_EQ(read_text(vtu).tensors[4][8], 4294967295.0);
  for (const char* type : {"Int64", "UInt64"}) {
    vtu.point_data = {{"tensor", 9, std::vector<double>(45, 7), type}};
    EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("is of type"), HasSubstr("Float64"))) << type;
    vtu.point_data = {{"U", 3, std::vector<double>(15, 7), type}};
    EXPECT_THAT(message_of(vtu, {.gradient_of = "U"}), HasSubstr("is of type")) << type;
  }
}

TEST(Numbers, MustBeFinite) {
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const auto grid =
        test::make_grid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{VTK_TETRA, {0, 1, 2, 3}}});
    test::add_array(*grid, "tensor", 9, test::linear_tensor);
    test::add_array(*grid, "stress", 6, [](const Point&) { return std::vector<double>(6, 1); });
    grid->GetPointData()->GetArray("tensor")->SetComponent(2, 5, bad);
    grid->GetPointData()->GetArray("stress")->SetComponent(2, 4, bad);
    const test::TemporaryDirectory directory;
    test::write_vtu(directory / "a.vtu", *grid);
    EXPECT_THAT(message_of(directory / "a.vtu"),
                AllOf(HasSubstr("the tensor of point 2 at (0, 1, 0)"), HasSubstr("component 5"),
                      HasSubstr("finite")));
    EXPECT_THAT(message_of(directory / "a.vtu", {.symmetric_order = kVtkOrder}),
                AllOf(HasSubstr("point 2"), HasSubstr("row 1, column 2")));
  }
}

}  // namespace
}  // namespace triplex

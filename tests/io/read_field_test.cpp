// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reading.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/write_field.hpp"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
/// VTK's legacy reader loses memory when a file ends too early.
using AllowLeaks = __lsan::ScopedDisabler;
#else
struct AllowLeaks {};
#endif

namespace triplex {
namespace {

using test::file_content;
using test::message_of;
using test::read_text;
using test::same_bits;
using test::TemporaryDirectory;
using test::VtuText;
using test::write_content;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// ---- what is read ----

TEST(ReadField, ReadsText) {
  const TensorField field = read_text({});
  ASSERT_EQ(field.mesh.tets.size(), 2u);
  EXPECT_EQ(field.mesh.tets[1], (std::array{VertexId{0}, VertexId{2}, VertexId{1}, VertexId{4}}));
  EXPECT_EQ(field.mesh.points[4], (Point{0, 0, -1}));
  const VtuText vtu;
  for (int i = 0; i < 45; ++i) EXPECT_EQ(field.tensors[i / 9][i % 9], vtu.point_data[0].values[i]);
  EXPECT_EQ(field.array_name, "tensor");
  EXPECT_TRUE(field.source_cells.empty());
}

TEST(ReadField, ReadsFloatsExactly) {
  VtuText vtu;
  vtu.point_type = "Float32";
  vtu.points[3] = static_cast<double>(0.1f);
  vtu.point_data[0].type = "Float32";
  vtu.point_data[0].values[7] = static_cast<double>(0.7f);
  const TensorField field = read_text(vtu);
  EXPECT_EQ(field.mesh.points[1][0], static_cast<double>(0.1f));
  EXPECT_EQ(field.tensors[0][7], static_cast<double>(0.7f));
}

TEST(ReadField, RoundTripsBitForBit) {
  const TemporaryDirectory directory;
  TensorField field = generate_noise({.n = 7, .jitter = 0.15});
  field.tensors[3] = {-0.0, 0x1p-1074, 0x1.fffffffffffffp1023, 1e-300, 0.1, -0.1, 1.0 / 3, 0, 1};
  field.array_name = "a name with <signs> & \"marks\"";
  for (const char* name : {"a.vtu", "a.vtk"}) {
    write_field(directory / name, field);
    const TensorField back = read_field(directory / name);
    EXPECT_TRUE(same_bits(field, back)) << name;
    EXPECT_EQ(back.array_name, field.array_name);
    const std::string bytes = file_content(directory / name);
    write_field(directory / name, back);
    EXPECT_EQ(file_content(directory / name), bytes) << name;
    EXPECT_THAT(bytes, Not(HasSubstr("AppendedData")));
  }
}

TEST(ReadField, ReadsTheFilesInData) {
  const std::filesystem::path data = TRIPLEX_DATA_DIR;
  int files = 0;
  for (const auto& [name, tets, points] : {std::tuple{"channel.vtu", 16047u, 3592u},
                                           {"channel_laminar.vtu", 10194u, 2451u},
                                           {"convection.vtu", 15972u, 3312u},
                                           {"rayleigh_benard.vtu", 15972u, 3312u},
                                           {"twist_030.vtu", 12000u, 2541u},
                                           {"twist_100.vtu", 12000u, 2541u},
                                           {"twist_cube_54deg.vtu", 16464u, 3375u}}) {
    const TensorField field = read_field(data / name, {.tensor_name = "tensor"});
    EXPECT_EQ(field.mesh.tets.size(), tets) << name;
    EXPECT_EQ(field.mesh.points.size(), points) << name;
    ++files;
  }
  EXPECT_EQ(std::count_if(std::filesystem::directory_iterator(data), {},
                          [](const auto& entry) { return entry.path().extension() == ".vtu"; }),
            files);
}

TEST(ReadField, ReportsRepairs) {
  VtuText vtu;
  std::swap(vtu.connectivity[0], vtu.connectivity[1]);
  vtu.points.insert(vtu.points.end(), {0, 0, 0});
  const auto tensors = VtuText::tensors(5);
  vtu.point_data[0].values.insert(vtu.point_data[0].values.end(), tensors.begin(),
                                  tensors.begin() + 9);
  vtu.connectivity[4] = 5;
  const TemporaryDirectory directory;
  write_content(directory / "field.vtu", vtu.text());
  EXPECT_THAT(message_of(directory / "field.vtu"), HasSubstr("--merge-points"));
  EXPECT_THAT(message_of(directory / "field.vtu", {.merge_points = true}),
              AllOf(HasSubstr("cell 0"), HasSubstr("--fix-orientation")));
  InputRepairs repairs;
  read_field(directory / "field.vtu", {.merge_points = true, .fix_orientation = true}, &repairs);
  EXPECT_EQ(repairs.merged_points, 1u);
  EXPECT_EQ(repairs.flipped_tets, 1u);
}

TEST(ReadField, SkipsGhostCellsAndKeepsCellIds) {
  VtuText vtu;
  // A duplicate of cell 1 before it, flagged.
  vtu.connectivity = {0, 1, 2, 3, 0, 2, 1, 4, 0, 2, 1, 4};
  vtu.offsets = {4, 8, 12};
  vtu.types = {10, 10, 10};
  EXPECT_THAT(message_of(vtu), HasSubstr("cell 2 (points 0, 2, 1, 4) is the same tet as cell 1"));
  for (const double flag : {1.0, 32.0}) {
    vtu.cell_data = {{"vtkGhostType", 1, {0, flag, 0}, "UInt8"}};
    const TensorField field = read_text(vtu);
    EXPECT_EQ(field.mesh.tets.size(), 2u);
    EXPECT_EQ(field.source_cells, (std::vector<std::int64_t>{0, 2}));
  }
  // Cells of another type do not matter if they are skipped.
  vtu.types[1] = 9;
  EXPECT_EQ(message_of(vtu), "accepted");
}

TEST(ReadField, ChoosesTheTensorArray) {
  VtuText vtu;
  vtu.point_data.insert(vtu.point_data.begin(),
                        {"velocity", 3, std::vector<double>(15), "Float64"});
  EXPECT_EQ(message_of(vtu), "accepted");
  vtu.point_data.push_back({"stress", 9, VtuText::tensors(5), "Float64"});
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("tensor, stress;"), HasSubstr("--tensor"),
                                     Not(HasSubstr("velocity"))));
  EXPECT_EQ(read_text(vtu, {.tensor_name = "stress"}).array_name, "stress");
}

// ---- arrays that do not fit ----

TEST(ReadField, RefusesUnsuitableArrays) {
  VtuText vtu;
  EXPECT_THAT(message_of(vtu, {.tensor_name = "stress"}),
              AllOf(HasSubstr("no point array stress"), HasSubstr("tensor (9)")));
  vtu.point_data[0] = {"tensor", 6, std::vector<double>(30), "Float64"};
  EXPECT_THAT(message_of(vtu),
              AllOf(HasSubstr("no point array has 9 components"), HasSubstr("tensor (6)")));
  EXPECT_THAT(message_of(vtu, {.tensor_name = "tensor"}), HasSubstr("has 6 components"));
  vtu.cell_data = {{"tensor", 9, VtuText::tensors(2), "Float64"}};
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("cell data"), HasSubstr("Cell Data to Point Data")));
  vtu.point_data.clear();
  EXPECT_THAT(message_of(vtu, {.tensor_name = "tensor"}),
              HasSubstr("the array tensor is cell data"));
  vtu.cell_data.clear();
  EXPECT_THAT(message_of(vtu), HasSubstr("there are no point arrays"));
  vtu.point_data = {{"tensor", 9, std::vector<double>(45), "Int64"}};
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("tensor is of type"), HasSubstr("Float64")));
}

TEST(ReadField, RefusesTensorsThatAreNotFinite) {
  const TemporaryDirectory directory;
  TensorField field = generate_noise({.n = 2});
  field.tensors[9][5] = HUGE_VAL;
  write_field(directory / "a.vtu", field);
  EXPECT_THAT(message_of(directory / "a.vtu"),
              AllOf(HasSubstr("point 9"), HasSubstr("component 5")));
}

// ---- cells that do not fit ----

TEST(ReadField, RefusesOtherCells) {
  VtuText vtu;
  vtu.types[1] = 9;
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("cell 1 is no tet"), HasSubstr("type 9 (vtkQuad)"),
                                     HasSubstr("Extract Cells By Type")));
  vtu.types[1] = 24;
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("vtkQuadraticTetra"), HasSubstr("linear tets")));
  vtu.types[1] = 200;
  EXPECT_THAT(message_of(vtu), HasSubstr("type 200"));
}

TEST(ReadField, RefusesBadConnectivity) {
  VtuText vtu;
  vtu.connectivity[6] = 5;
  EXPECT_THAT(message_of(vtu), AllOf(HasSubstr("cell 1 refers to point 5"), HasSubstr("5 points")));
  vtu.connectivity[6] = -1;
  EXPECT_THAT(message_of(vtu), HasSubstr("cell 1 refers to point -1"));
  vtu.connectivity[6] = (1ll << 32) + 1;  // must not wrap to point 1
  EXPECT_THAT(message_of(vtu), HasSubstr("cell 1 refers to point 4294967297"));
  vtu = {};
  vtu.offsets[0] = 3;
  EXPECT_THAT(message_of(vtu), HasSubstr("tet with 3 points"));
  vtu.offsets = {4, 12};
  EXPECT_THAT(message_of(vtu), Not(HasSubstr("accepted")));
  vtu.offsets = {8, 4};
  EXPECT_THAT(message_of(vtu), Not(HasSubstr("accepted")));
}

TEST(ReadField, RefusesEmptyMeshes) {
  VtuText vtu;
  vtu.connectivity.clear();
  vtu.offsets.clear();
  vtu.types.clear();
  EXPECT_THAT(message_of(vtu), HasSubstr("no tets (5 points, 0 cells)"));
}

TEST(ReadField, PrefixesTheFileToWhatTheCheckFinds) {
  VtuText vtu;
  std::swap(vtu.connectivity[4], vtu.connectivity[5]);
  EXPECT_THAT(message_of(vtu), HasSubstr("field.vtu: cell 1 (points 2, 0, 1, 4)"));
}

// ---- files that cannot be read ----

TEST(ReadField, RefusesWhatIsNoFile) {
  const TemporaryDirectory directory;
  EXPECT_THAT(message_of(directory / "no.vtu"), HasSubstr("no such file"));
  std::filesystem::create_directory(directory / "d.vtu");
  EXPECT_THAT(message_of(directory / "d.vtu"), HasSubstr("directory"));
  write_content(directory / "empty.vtu", "");
  EXPECT_THAT(message_of(directory / "empty.vtu"), HasSubstr("empty"));
  write_content(directory / "field.stl", "solid");
  EXPECT_THAT(message_of(directory / "field.stl"),
              AllOf(HasSubstr("unknown kind"), HasSubstr(".pvtu")));
  if (::geteuid() != 0) {  // root may read anything
    write_content(directory / "secret.vtu", VtuText{}.text());
    std::filesystem::permissions(directory / "secret.vtu", std::filesystem::perms::none);
    EXPECT_THAT(message_of(directory / "secret.vtu"), HasSubstr("permissions"));
  }
}

TEST(ReadField, RefusesGarbage) {
  const TemporaryDirectory directory;
  std::string garbage;
  for (int i = 0; i < 5000; ++i) garbage += static_cast<char>(i * 7919 >> 3);
  std::string image =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" "
      "version=\"1.0\"><ImageData/></VTKFile>\n";
  const std::string polydata =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 0 double\n";
  for (const char* name : {"a.vtu", "a.pvtu", "a.vtk"}) {
    for (const auto& content : {garbage, image, polydata, std::string("\n"),
                                std::string("<VTKFile"), std::string(100, '\0')}) {
      write_content(directory / name, content);
      EXPECT_THAT(message_of(directory / name), HasSubstr("this is no "));
    }
  }
}

/// Every prefix of a file must be refused, but for those that lack only the end of the XML.
void refuse_prefixes(const std::filesystem::path& good, int cuts) {
  [[maybe_unused]] const AllowLeaks allow_leaks;
  const TemporaryDirectory directory;
  const auto file = directory / ("cut" + good.extension().string());
  const std::string content = file_content(good);
  for (int i = 0; i < cuts; ++i) {
    const std::size_t size = (content.size() - 40) * static_cast<std::size_t>(i) / (cuts - 1);
    write_content(file, content.substr(0, size));
    EXPECT_NE(message_of(file, {.tensor_name = "tensor"}), "accepted") << good << " " << size;
  }
}

TEST(ReadField, RefusesTruncatedFiles) {
  const TemporaryDirectory directory;
  const TensorField field = generate_noise({.n = 4});
  for (const char* name : {"a.vtu", "a.vtk"}) {
    write_field(directory / name, field);
    refuse_prefixes(directory / name, 150);
  }
  write_content(directory / "text.vtu", VtuText{}.text());
  refuse_prefixes(directory / "text.vtu", 150);
  refuse_prefixes(std::filesystem::path(TRIPLEX_DATA_DIR) / "twist_100.vtu", 12);
}

// ---- legacy ----

TEST(ReadField, ReadsLegacyText) {
  const TemporaryDirectory directory;
  std::string text =
      "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
      "0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\n"
      "VECTORS u float\n0 0 0 0 0 0 0 0 0 0 0 0\n";
  for (const char* name : {"first", "second"}) {
    text += std::string("TENSORS ") + name + " double\n";
    for (int i = 0; i < 36; ++i) text += std::to_string(i) + (name[0] == 's' ? ".5 " : " ");
    text += "\n";
  }
  write_content(directory / "a.vtk", text);
  EXPECT_THAT(message_of(directory / "a.vtk"), HasSubstr("first, second"));
  for (const auto& [name, shift] : {std::pair{"first", 0.0}, {"second", 0.5}}) {
    const TensorField field = read_field(directory / "a.vtk", {.tensor_name = name});
    for (int i = 0; i < 36; ++i) EXPECT_EQ(field.tensors[i / 9][i % 9], i + shift);
  }
}

}  // namespace
}  // namespace triplex

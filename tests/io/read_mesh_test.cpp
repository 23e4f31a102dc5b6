// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "sample_mesh.hpp"
#include "temporary_directory.hpp"
#include "triplex/io/write_mesh.hpp"

namespace triplex {
namespace {

using test::TemporaryDirectory;
using test::write_content;
using testing::HasSubstr;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Segments = std::vector<std::array<std::uint32_t, 2>>;

/// Two triangles and a segment, with numbers that only a faithful reader keeps.
FeatureMesh sample() {
  FeatureMesh mesh = test::surface();
  mesh.points[3][1] = 1e99;
  mesh.segments = {{0, 3}};
  mesh.source_cell.insert(mesh.source_cell.begin(), 5);
  mesh.certified.insert(mesh.certified.begin(), 1);
  return mesh;
}

FeatureMesh read_text(const std::string& name, const std::string& content,
                      const MeshReadOptions& options = {}, MeshRepairs* repairs = nullptr) {
  const TemporaryDirectory directory;
  write_content(directory / name, content);
  return read_mesh(directory / name, options, repairs);
}

/// The message with which a file is refused: one line that begins with the file, and nothing may be
/// printed.
std::string message_of(const std::filesystem::path& file) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::string message = "accepted";
  try {
    read_mesh(file);
  } catch (const BadInput& error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (message == "accepted") return message;
  EXPECT_THAT(message, testing::StartsWith(file.string() + ": "));
  EXPECT_THAT(message, testing::Not(HasSubstr("\n")));
  return message.substr(std::min(message.size(), file.string().size() + 2));
}
std::string message_of(const std::string& name, const std::string& content) {
  const TemporaryDirectory directory;
  write_content(directory / name, content);
  return message_of(directory / name);
}

const std::string kTetrahedronObj =
    "# a comment\nv 0 0 0\nv 1 0 0\nv 0.1 1 0\nv 0 0 +1e-3 1.0\nvt 0 0\n"
    "f 1 3 2\nf 1/1 2/1/1 4//1\r\nf -3 -2 -1\nf 3 1 4\nl 1 2 3\n";

TEST(ReadMesh, Obj) {
  const FeatureMesh mesh = read_text("mesh.obj", kTetrahedronObj);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0.1, 1, 0}, {0, 0, 1e-3}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  EXPECT_EQ(mesh.segments, (Segments{{0, 1}, {1, 2}}));
  EXPECT_TRUE(mesh.certified.empty());
}

const std::string kPlyHeader =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty double x\n"
    "property float y\nproperty double z\nproperty uchar red\nelement face 1\n"
    "property list uchar int vertex_indices\nelement edge 1\nproperty int vertex1\n"
    "property int vertex2\nend_header\n";

TEST(ReadMesh, PlyAsText) {
  const FeatureMesh mesh =
      read_text("mesh.ply", kPlyHeader + "0 0 0 255\n1 0 0 0\n0.1 1 0 7\n3 0 1 2\n2 0\n");
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0.1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(mesh.segments, (Segments{{2, 0}}));
}

TEST(ReadMesh, PlyOfTheOtherByteOrder) {
  std::string content =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\n"
      "property short z\nelement face 1\nproperty list uint8 uint32 vertex_index\nend_header\n";
  const auto append = [&](auto value) {
    std::array<char, sizeof(value)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(value));
    if (std::endian::native == std::endian::little) std::ranges::reverse(bytes);
    content.append(bytes.data(), bytes.size());
  };
  for (const std::int16_t z : {-2, 0, 300}) {
    append(0.1 * z);
    append(0.25f);
    append(z);
  }
  append(std::uint8_t{3});
  for (const std::uint32_t v : {2u, 0u, 1u}) append(v);
  const FeatureMesh mesh = read_text("mesh.ply", content);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{-0.2, 0.25, -2}, {0, 0.25, 0}, {30, 0.25, 300}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{2, 0, 1}}));
}

TEST(ReadMesh, PolygonsAndStripsAreCut) {
  // A quadrilateral that is not convex at its second corner: only one diagonal is inside.
  const FeatureMesh mesh =
      read_text("mesh.vtk",
                "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\nPOINTS 9 double\n"
                "0 0 0 1 0.9 0 2 0 0 1 3 0\n0 0 1 1 0 1 0 1 1 1 1 1 0 2 1\n"
                "POLYGONS 1 5\n4 0 1 2 3\nTRIANGLE_STRIPS 1 6\n5 4 5 6 7 8\nLINES 1 4\n3 0 1 2\n");
  EXPECT_EQ(mesh.segments, (Segments{{0, 1}, {1, 2}}));
  ASSERT_EQ(mesh.triangles.size(), 5u);
  for (std::size_t t = 0; t < 2; ++t) {  // both have the diagonal from 1 to 3
    EXPECT_THAT(mesh.triangles[t], testing::Contains(1u));
    EXPECT_THAT(mesh.triangles[t], testing::Contains(3u));
  }
  EXPECT_EQ(mesh.triangles[2], (std::array<std::uint32_t, 3>{4, 5, 6}));
  EXPECT_EQ(mesh.triangles[3], (std::array<std::uint32_t, 3>{6, 5, 7}));
  EXPECT_EQ(mesh.triangles[4], (std::array<std::uint32_t, 3>{6, 7, 8}));
}

TEST(ReadMesh, WhatTriplexWrote) {
  const FeatureMesh mesh = sample();
  const TemporaryDirectory directory;
  for (const MeshFormat format : {MeshFormat::Vtp, MeshFormat::Ply, MeshFormat::Obj}) {
    const auto file = directory / ("mesh." + std::string(name_of(format)));
    write_mesh(file, format, mesh, Feature::NeutralReal);
    const FeatureMesh read = read_mesh(file);
    EXPECT_EQ(read.points, mesh.points) << file;
    EXPECT_EQ(read.triangles, mesh.triangles) << file;
    EXPECT_EQ(read.segments, mesh.segments) << file;
    if (format != MeshFormat::Obj) {
      EXPECT_EQ(read.certified, mesh.certified) << file;
    }
    if (format == MeshFormat::Vtp) {
      EXPECT_EQ(read.source_cell, mesh.source_cell) << file;
    }
  }
}

TEST(ReadMesh, SegmentsKeepTheirCells) {
  FeatureMesh curve;
  curve.points = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {5, 5, 5}, {6, 5, 5}};
  curve.segments = {{0, 1}, {1, 2}, {3, 4}};
  curve.source_cell = {7, 8, 9};
  curve.certified = {1, 1, 0};
  curve.p = curve.q = curve.mode = std::vector<double>(5);
  const TemporaryDirectory directory;
  write_mesh(directory / "curve.vtp", MeshFormat::Vtp, curve, Feature::TripleCurve);
  const FeatureMesh read = read_mesh(directory / "curve.vtp");
  EXPECT_EQ(read.segments, curve.segments);
  EXPECT_EQ(read.source_cell, curve.source_cell);
  EXPECT_EQ(read.certified, curve.certified);
}

TEST(ReadMesh, StlPointsAreMerged) {
  FeatureMesh mesh = sample();
  mesh.points[2][1] = 0.7;
  mesh.points[3][1] = 1e30;
  mesh.segments.clear();
  const std::size_t triangles = mesh.triangles.size();
  mesh.source_cell.assign(triangles, 0);
  mesh.certified.assign(triangles, 1);
  const TemporaryDirectory directory;
  write_mesh(directory / "mesh.stl", MeshFormat::Stl, mesh, Feature::NeutralReal);
  MeshRepairs repairs;
  const FeatureMesh read = read_mesh(directory / "mesh.stl", {}, &repairs);
  ASSERT_EQ(read.triangles.size(), triangles);
  EXPECT_EQ(repairs.merged_points, 3 * triangles - read.points.size());
  for (std::size_t t = 0; t < triangles; ++t)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(read.points[read.triangles[t][i]][k],
                  static_cast<float>(mesh.points[mesh.triangles[t][i]][k]));
  mesh.triangles.clear();
  mesh.source_cell.clear();
  mesh.certified.clear();
  write_mesh(directory / "empty.stl", MeshFormat::Stl, mesh, Feature::NeutralReal);
  EXPECT_TRUE(read_mesh(directory / "empty.stl").triangles.empty());
}

TEST(ReadMesh, StlAsText) {
  const std::string text =
      "solid a b\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
      "   vertex 0.1 1e0 0\n  endloop\n endfacet\n facet normal 0 0 1\n  outer loop\n"
      "   vertex 1 0 0\n   vertex 1 1 0\n   vertex 0.1 1 0\n  endloop\n endfacet\nendsolid a\n";
  const FeatureMesh mesh = read_text("mesh.stl", text);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0.1, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_THAT(message_of("a.stl", text.substr(0, 180)), HasSubstr("ends before"));
  EXPECT_THAT(message_of("a.stl", "solid\nvertex 0 0\n"), HasSubstr("line 2"));
}

TEST(ReadMesh, MergesOnRequestAndLeavesOutWhatCollapses) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -0 0 0\nv 1 0 0\nv 5 5 5\nf 1 2 3\nf 4 5 6\nf 1 4 3\nl 2 5\n";
  MeshRepairs repairs;
  EXPECT_EQ(read_text("mesh.obj", text, {}, &repairs).points.size(), 6u);
  EXPECT_EQ(repairs.merged_points + repairs.dropped_cells, 0u);
  const FeatureMesh mesh = read_text("mesh.obj", text, {.merge_points = true}, &repairs);
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(mesh.segments, Segments{});
  EXPECT_EQ(repairs.merged_points, 2u);
  EXPECT_EQ(repairs.dropped_cells, 2u);
  EXPECT_EQ(read_text("mesh.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2\n", {}, &repairs).triangles.size(),
            0u);
  EXPECT_EQ(repairs.dropped_cells, 1u);
}

TEST(ReadMesh, NamesWhatIsWrongWithTheFile) {
  const TemporaryDirectory directory;
  EXPECT_THAT(message_of(directory / "none.ply"), HasSubstr("no such file"));
  EXPECT_THAT(message_of("mesh.off", "OFF\n"), HasSubstr("unknown kind of file"));
  for (const char* const name : {"a.vtp", "a.vtk", "a.ply", "a.obj", "a.stl"}) {
    EXPECT_THAT(message_of(name, ""), HasSubstr("the file is empty")) << name;
    if (std::string_view(name) != "a.obj") {
      EXPECT_NE(message_of(name, "no mesh at all\n"), "accepted") << name;
    }
  }
  EXPECT_THAT(message_of("a.vtk",
                         "# vtk DataFile Version 3.0\nx\nASCII\n"
                         "DATASET UNSTRUCTURED_GRID\nPOINTS 0 double\n"),
              HasSubstr("polygonal data"));
}

TEST(ReadMesh, NamesWhatIsWrongWithTheMesh) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_THAT(message_of("a.obj", points + "f 1 2 4\n"), HasSubstr("polygon 0 uses point 3"));
  EXPECT_THAT(message_of("a.obj", points + "f 1 2 0\n"), HasSubstr("line 4: there is no point 0"));
  EXPECT_THAT(message_of("a.obj", points + "f 1 2 -4\n"), HasSubstr("there is no point -4"));
  EXPECT_THAT(message_of("a.obj", points + "f 1 2\n"), HasSubstr("polygon 0 has 2 points"));
  EXPECT_THAT(message_of("a.obj", points + "l 1\n"), HasSubstr("line 0 has 1 points"));
  EXPECT_THAT(message_of("a.obj", "v 0 0\n"), HasSubstr("line 1: '' is not a number"));
  EXPECT_THAT(message_of("a.obj", "v 0 0 x\n"), HasSubstr("'x' is not a number"));
  for (const char* const bad : {"nan", "inf", "-inf", "1e101"})
    EXPECT_THAT(message_of("a.obj", points + "v 0 0 " + bad + "\n"),
                HasSubstr("point 3 has the coordinate"));
  const std::string vertices = "0 0 0 1\n1 0 0 1\n0 1 0 1\n";
  EXPECT_THAT(message_of("a.ply", kPlyHeader + vertices + "3 0 1 9\n2 0\n"),
              HasSubstr("polygon 0 uses point 9"));
  EXPECT_THAT(message_of("a.ply", kPlyHeader + vertices + "3 0 1 -1\n2 0\n"),
              HasSubstr("uses point -1"));
  EXPECT_THAT(message_of("a.ply", kPlyHeader + vertices + "3 0 1 1e300\n2 0\n"),
              HasSubstr("uses point 1e+300"));
  EXPECT_THAT(message_of("a.ply", kPlyHeader + vertices + "3 0 1 2\n2\n"),
              HasSubstr("'vertex2' of edge 0"));
  EXPECT_THAT(message_of("a.ply", kPlyHeader + "0 0 zero 1\n"), HasSubstr("'z' of vertex 0 of 3"));
  EXPECT_THAT(message_of("a.ply",
                         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                         "property float y\nend_header\n0 0\n"),
              HasSubstr("no 'z'"));
  EXPECT_THAT(message_of("a.ply", "ply\nformat ascii 2.0\nelement vertex x\nend_header\n"),
              HasSubstr("element vertex x"));
}

TEST(ReadMesh, EveryTruncationIsRefusedOrWhole) {
  const FeatureMesh mesh = sample();
  const TemporaryDirectory directory;
  for (const MeshFormat format : {MeshFormat::Vtp, MeshFormat::Ply, MeshFormat::Stl}) {
    const std::size_t tail = format == MeshFormat::Vtp ? 40 : 0;
    const std::string name = "mesh." + std::string(name_of(format));
    write_mesh(directory / name, format, mesh, Feature::NeutralReal);
    const std::string whole = test::file_content(directory / name);
    // Not the last bytes of .vtp, which are closing tags and line ends.
    for (std::size_t size = 1; size + tail < whole.size(); size += 1 + whole.size() / 60)
      EXPECT_NE(message_of(name, whole.substr(0, size)), "accepted") << name << ' ' << size;
  }
}

}  // namespace
}  // namespace triplex

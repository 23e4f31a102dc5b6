// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/read_points.hpp"

#include <gmock/gmock.h>

#include "temporary_directory.hpp"
#include "triplex/io/read_vectors.hpp"
#include "triplex/io/write_lines.hpp"
#include "vtk_files.hpp"

namespace triplex {
namespace {

using test::TemporaryDirectory;
using test::write_content;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

template <class Read>
std::string message_of(const std::filesystem::path& file, const Read& read) {
  try {
    read(file);
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), StartsWith(file.string() + ": "));
    return error.what();
  }
  return "accepted";
}

TEST(ReadPoints, FromText) {
  const TemporaryDirectory directory;
  write_content(directory / "a.txt", "# seeds\n1 2 3\n\n -0.5,1e-3 , +4 # one more\r\n7\t8 9");
  EXPECT_THAT(read_points(directory / "a.txt"),
              ElementsAre(Point{1, 2, 3}, Point{-0.5, 1e-3, 4}, Point{7, 8, 9}));
}

TEST(ReadPoints, FromMeshes) {
  const TemporaryDirectory directory;
  write_lines(directory / "a.vtp", {{{1, 2, 3}, {4, 5, 0.1}}, {{0, 1}}, {}, {}});
  EXPECT_THAT(read_points(directory / "a.vtp"), ElementsAre(Point{1, 2, 3}, Point{4, 5, 0.1}));
  const auto grid = test::make_grid({{0, 0, 1}, {0, 1, 0}}, {{VTK_VERTEX, {0}}});
  test::write_vtu(directory / "b.vtu", *grid);
  test::write_vtk(directory / "c.vtk", *grid, true);
  for (const char* name : {"b.vtu", "c.vtk"})
    EXPECT_THAT(read_points(directory / name), ElementsAre(Point{0, 0, 1}, Point{0, 1, 0}));
  write_content(directory / "d.vtk",
                "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 double\n1 2 3\n");
  EXPECT_THAT(read_points(directory / "d.vtk"), ElementsAre(Point{1, 2, 3}));
}

TEST(ReadPoints, RefusesWhatIsNone) {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::string& text) {
    write_content(directory / "a.txt", text);
    return message_of(directory / "a.txt", [](const auto& file) { read_points(file); });
  };
  EXPECT_THAT(refused("1 2 3\n4 5\n"), AllOf(HasSubstr("line 2"), HasSubstr("2 numbers")));
  EXPECT_THAT(refused("1 2 3 4\n"), HasSubstr("4 numbers"));
  EXPECT_THAT(refused("1 x 3\n"), AllOf(HasSubstr("line 1"), HasSubstr("'x'")));
  EXPECT_THAT(refused("1 2 nan\n"), HasSubstr("not finite"));
  EXPECT_THAT(refused("# none\n"), HasSubstr("no points"));
  EXPECT_THAT(refused(""), HasSubstr("empty"));
  EXPECT_THAT(message_of(directory / "b.txt", [](const auto& file) { read_points(file); }),
              HasSubstr("no such file"));
}

/// A tet and a hexahedron's worth of vectors u = (x, 2 y, 3 z).
test::GridPointer flow_grid(const std::vector<test::Cell>& cells) {
  auto grid = test::make_grid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}}, cells);
  test::add_array(*grid, "u", 3, [](const Point& x) {
    return std::vector<double>{x[0], 2 * x[1], 3 * x[2]};
  });
  return grid;
}

TEST(ReadVectors, TakesMeshAndVectors) {
  const TemporaryDirectory directory;
  test::write_vtu(directory / "a.vtu", *flow_grid({{VTK_TETRA, {0, 1, 2, 3}}}));
  const VectorField field = read_vectors(directory / "a.vtu", "u");
  EXPECT_EQ(field.array_name, "u");
  ASSERT_EQ(field.mesh.tets.size(), 1u);
  EXPECT_THAT(field.vectors,
              ElementsAre(Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 2, 0}, Point{0, 0, 3}));
}

TEST(ReadVectors, ChecksTheMesh) {
  const TemporaryDirectory directory;
  test::write_vtu(directory / "a.vtu", *flow_grid({{VTK_TETRA, {0, 2, 1, 3}}}));
  const auto message = [&](const char* name) {
    return message_of(directory / "a.vtu", [&](const auto& file) { read_vectors(file, name); });
  };
  EXPECT_THAT(message("u"), HasSubstr("--fix-orientation"));
  EXPECT_THAT(message("w"), AllOf(HasSubstr("no point array w"), HasSubstr("u")));
  const test::GridPointer grid = flow_grid({{VTK_TETRA, {0, 1, 2, 3}}});
  test::add_array(*grid, "s", 1, [](const Point& x) { return std::vector<double>{x[0]}; });
  test::write_vtu(directory / "b.vtu", *grid);
  EXPECT_THAT(message_of(directory / "b.vtu", [](const auto& file) { read_vectors(file, "s"); }),
              HasSubstr("s has 1 component, but a vector has 3"));
  EXPECT_EQ(read_vectors(directory / "a.vtu", "u", {.merge_points = false, .fix_orientation = true})
                .vectors.size(),
            4u);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file in each format that is accepted, and one of each kind that is refused.
#include <gmock/gmock.h>
#include <vtkCellType.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>

#include "reading.hpp"
#include "vtk_files.hpp"

namespace triplex {
namespace {

namespace fs = std::filesystem;
using test::Encoding;
using test::file_content;
using test::GridPointer;
using test::message_of;
using test::same_bits;
using test::TemporaryDirectory;
using test::write_content;
using testing::AllOf;
using testing::HasSubstr;

GridPointer two_tets(int precision = VTK_DOUBLE) {
  const auto grid =
      test::make_grid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1.0 / 3}},
                      {{VTK_TETRA, {0, 1, 2, 3}}, {VTK_TETRA, {0, 2, 1, 4}}}, precision);
  test::add_array(*grid, "tensor", 9, test::linear_tensor);
  return grid;
}

TEST(Formats, GiveTheSameFieldBitForBit) {
  const TemporaryDirectory directory;
  const GridPointer grid = two_tets();
  test::write_vtu(directory / "inline.vtu", *grid);
  test::write_vtu(directory / "compressed.vtu", *grid, Encoding::Compressed);
  test::write_vtu(directory / "ascii.vtu", *grid, Encoding::Ascii);
  test::write_vtu(directory / "raw.vtu", *grid, Encoding::AppendedRaw);
  test::write_vtu(directory / "base64.vtu", *grid, Encoding::AppendedBase64);
  test::write_vtk(directory / "binary.vtk", *grid, true);
  write_content(directory / "all.pvtu", test::pvtu_text({"ascii.vtu"}, false));
  fs::copy_file(directory / "inline.vtu", directory / "UPPER.VTU");
  EXPECT_THAT(file_content(directory / "inline.vtu"), HasSubstr("format=\"binary\""));
  EXPECT_THAT(file_content(directory / "compressed.vtu"), HasSubstr("vtkZLibDataCompressor"));
  EXPECT_THAT(file_content(directory / "raw.vtu"), HasSubstr("encoding=\"raw\""));
  const TensorField field = read_field(directory / "inline.vtu");
  ASSERT_EQ(field.mesh.tets.size(), 2u);
  EXPECT_EQ(field.mesh.points[4][2], -1.0 / 3);
  for (const char* name : {"compressed.vtu", "ascii.vtu", "raw.vtu", "base64.vtu", "binary.vtk",
                           "all.pvtu", "UPPER.VTU"}) {
    EXPECT_TRUE(same_bits(read_field(directory / name), field)) << name;
  }
}

TEST(Formats, LegacyTextHasTheNumbersThatItsDigitsSay) {
  const TemporaryDirectory directory;
  test::write_vtk(directory / "a.vtk", *two_tets(), false);
  EXPECT_THAT(file_content(directory / "a.vtk"), HasSubstr("ASCII"));
  const TensorField field = read_field(directory / "a.vtk");
  EXPECT_EQ(field.mesh.tets.size(), 2u);
  EXPECT_NEAR(field.mesh.points[4][2], -1.0 / 3, 1e-6);  // VTK writes few digits
  EXPECT_EQ(field.tensors[0][0], -4);
}

TEST(Formats, LegacyFilesMayHaveTensorsOfSixComponents) {
  const TemporaryDirectory directory;
  const GridPointer grid = two_tets();
  grid->GetPointData()->RemoveArray("tensor");
  test::add_array(*grid, "stress", 6,
                  [](const Point& x) { return std::vector<double>{1, 2, 3, 4, 5, x[0]}; });
  for (const bool as_tensors : {false, true}) {
    if (as_tensors) grid->GetPointData()->SetActiveTensors("stress");
    test::write_vtk(directory / "a.vtk", *grid, true);
    const TensorField field =
        read_field(directory / "a.vtk", {.symmetric_order = "xx,yy,zz,xy,yz,xz"});
    EXPECT_EQ(field.tensors[1], (Tensor<double>{1, 4, 1, 4, 2, 5, 1, 5, 3}));
    EXPECT_THAT(message_of(directory / "a.vtk"), HasSubstr("--symmetric-order"));
  }
}

TEST(Formats, LegacyFilesMayHaveVectorsAndOtherCells) {
  const TemporaryDirectory directory;
  const auto grid = test::make_grid(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
      {{VTK_HEXAHEDRON, {0, 1, 2, 3, 4, 5, 6, 7}}});
  test::add_array(*grid, "U", 3, [](const Point& x) {
    return std::vector<double>{x[1], 2 * x[2], 4 * x[0]};
  });
  grid->GetPointData()->SetActiveVectors("U");
  for (const bool binary : {false, true}) {
    test::write_vtk(directory / "a.vtk", *grid, binary);
    const TensorField field = read_field(directory / "a.vtk", {.gradient_of = "U"});
    EXPECT_EQ(field.mesh.tets.size(), 6u);
    for (const auto& t : field.tensors) {
      const Tensor<double> expected{0, 1, 0, 0, 0, 2, 4, 0, 0};
      for (int i = 0; i < 9; ++i) EXPECT_NEAR(t[i], expected[i], 1e-14);
    }
  }
}

// ---- several pieces ----

/// The text of a .vtu file of several pieces, made from files of one.
std::string merged_text(const std::vector<fs::path>& files) {
  const auto piece_of = [](const std::string& text) {
    const std::size_t begin = text.find("<Piece"), end = text.find("</Piece>") + 8;
    return text.substr(begin, end - begin);
  };
  const std::string first = file_content(files.front());
  std::string text = first.substr(0, first.find("<Piece"));
  for (const auto& file : files) text += piece_of(file_content(file)) + "\n";
  return text + first.substr(first.find("</Piece>") + 8);
}

/// The cells from `begin` to `end` of a row along x, hexahedra and pairs of wedges in turns. Those
/// from `owned` on are flagged as ghosts, with their points.
GridPointer row_of_cells(int begin, int end, int owned) {
  std::vector<Point> points;
  for (int i = begin; i <= end; ++i) {
    for (int k = 0; k < 4; ++k) points.push_back({0.1 * i, 1.0 * (k % 2), 0.3 * (k / 2) * (i + 1)});
  }
  std::vector<test::Cell> cells;
  const auto ghost_cells = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghost_cells->SetName("vtkGhostType");
  for (int i = 0; i < end - begin; ++i) {
    const auto v = [&](int side, int k) { return vtkIdType{4 * (i + side) + k}; };
    if ((begin + i) % 2 == 0) {
      cells.push_back({VTK_HEXAHEDRON,
                       {v(0, 0), v(1, 0), v(1, 1), v(0, 1), v(0, 2), v(1, 2), v(1, 3), v(0, 3)}});
    } else {
      cells.push_back({VTK_WEDGE, {v(0, 0), v(1, 0), v(1, 2), v(0, 1), v(1, 1), v(1, 3)}});
      cells.push_back({VTK_WEDGE, {v(0, 0), v(1, 2), v(0, 2), v(0, 1), v(1, 3), v(0, 3)}});
    }
    while (ghost_cells->GetNumberOfValues() < static_cast<vtkIdType>(cells.size())) {
      ghost_cells->InsertNextValue(begin + i >= owned ? 1 : 0);
    }
  }
  const GridPointer grid = test::make_grid(points, cells);
  test::add_array(*grid, "tensor", 9, test::linear_tensor);
  test::add_array(*grid, "U", 3, [](const Point& x) {
    return std::vector<double>{x[1] * x[2], x[0] * x[0], x[2] - x[0]};
  });
  const auto ghost_points = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghost_points->SetName("vtkGhostType");
  for (int i = begin; i <= end; ++i) {
    for (int k = 0; k < 4; ++k) ghost_points->InsertNextValue(i > owned ? 1 : 0);
  }
  grid->GetPointData()->AddArray(ghost_points);
  grid->GetCellData()->AddArray(ghost_cells);
  return grid;
}

/// Writes a row of four whole, and as two pieces that meet in the middle; with `ghosts`, the first
/// piece holds a cell of the second as well.
class TwoPieces : public testing::Test {
 protected:
  void write(bool ghosts, double disturbance = 0) {
    test::write_vtu(directory_ / "whole.vtu", *row_of_cells(0, 4, 4));
    const GridPointer first = row_of_cells(0, ghosts ? 3 : 2, 2), second = row_of_cells(2, 4, 4);
    if (disturbance != 0) {
      auto& array = *second->GetPointData()->GetArray("tensor");
      array.SetComponent(1, 4, array.GetComponent(1, 4) + disturbance);
    }
    if (ghosts) {  // what ghosts hold does not matter
      for (vtkIdType i = 12; i < 16; ++i) {
        first->GetPointData()->GetArray("tensor")->SetComponent(i, 0, 1e300);
        first->GetPointData()->GetArray("U")->SetComponent(i, 0, 1e300);
      }
    }
    test::write_vtu(directory_ / "p0.vtu", *first);
    test::write_vtu(directory_ / "p1.vtu", *second);
    std::string text = test::pvtu_text({"p0.vtu", "p1.vtu"}, true);
    const std::string array = "<PDataArray type=\"Float64\" Name=\"tensor\"";
    text.insert(text.find(array),
                "<PDataArray type=\"Float64\" Name=\"U\" NumberOfComponents=\"3\"/>");
    write_content(directory_ / "all.pvtu", text);
    write_content(directory_ / "all.vtu",
                  merged_text({directory_ / "p0.vtu", directory_ / "p1.vtu"}));
  }
  TemporaryDirectory directory_;
};

TEST_F(TwoPieces, GiveTheWholeMesh) {
  for (const bool ghosts : {false, true}) {
    write(ghosts);
    for (const ReadOptions& options :
         {ReadOptions{.tensor_name = "tensor"}, ReadOptions{.gradient_of = "U"}}) {
      const TensorField whole = read_field(directory_ / "whole.vtu", options);
      EXPECT_EQ(whole.split.hexahedra, 2u);
      EXPECT_EQ(whole.split.wedges, 4u);
      EXPECT_EQ(whole.mesh.tets.size(), 24u);
      for (const char* name : {"all.pvtu", "all.vtu"}) {
        const TensorField field = read_field(directory_ / name, options);
        EXPECT_TRUE(same_bits(field, whole)) << name << " ghosts " << ghosts;
        EXPECT_EQ(field.split.total(), 6u);
        EXPECT_EQ(field.source_cells.back(), ghosts ? 6 : 5);
      }
    }
  }
}

TEST_F(TwoPieces, MustAgree) {
  for (const bool ghosts : {false, true}) {
    write(ghosts, 0x1p-30);
    for (const char* name : {"all.pvtu", "all.vtu"}) {
      EXPECT_THAT(message_of(directory_ / name),
                  AllOf(HasSubstr("the pieces disagree: points 9 and " +
                                  std::to_string(ghosts ? 17 : 13) + " both lie at (0.2, 1, 0)"),
                        HasSubstr("tensors differ"), HasSubstr("average them")));
    }
  }
}

TEST_F(TwoPieces, IdsInMessagesAreThoseOfTheFile) {
  write(true);
  const GridPointer second = row_of_cells(2, 4, 4);
  second->GetPointData()->GetArray("tensor")->SetComponent(10, 3, std::nan(""));
  test::write_vtu(directory_ / "p1.vtu", *second);
  EXPECT_THAT(message_of(directory_ / "all.pvtu"), HasSubstr("the tensor of point 26 at ("));
  second->GetPoints()->SetPoint(11, 0, 0, std::nan(""));
  test::write_vtu(directory_ / "p1.vtu", *second);
  EXPECT_THAT(message_of(directory_ / "all.pvtu"),
              AllOf(HasSubstr("point 27 at (0, 0, nan)"), HasSubstr("coordinate")));
}

// ---- refused ----

TEST(Formats, RefusesOtherKindsOfDataSets) {
  const TemporaryDirectory directory;
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkXMLPolyDataWriter> xml;
  xml->SetInputData(surface);
  xml->SetDataModeToAscii();
  vtkNew<vtkPolyDataWriter> legacy;
  legacy->SetInputData(surface);
  for (const char* name : {"a.vtu", "a.vtk", "a.vtp"}) {
    const auto file = directory / name;
    if (file.extension() == ".vtk") {
      legacy->SetFileName(file.c_str());
      legacy->Write();
      EXPECT_THAT(message_of(file), HasSubstr("no legacy .vtk file with an unstructured grid"));
    } else {
      xml->SetFileName(file.c_str());
      xml->Write();
      EXPECT_THAT(message_of(file), file.extension() == ".vtu" ? HasSubstr("this is no .vtu file")
                                                               : HasSubstr("unknown kind of file"));
    }
  }
}

TEST(Formats, RefusesEveryTruncation) {
  const TemporaryDirectory directory;
  const GridPointer grid = two_tets();
  for (const Encoding encoding : {Encoding::Ascii, Encoding::Inline, Encoding::Compressed,
                                  Encoding::AppendedRaw, Encoding::AppendedBase64}) {
    test::write_vtu(directory / "good.vtu", *grid, encoding);
    const std::string content = file_content(directory / "good.vtu");
    for (std::size_t size = 0; size + 60 < content.size(); size += 97) {
      write_content(directory / "cut.vtu", content.substr(0, size));
      EXPECT_NE(message_of(directory / "cut.vtu"), "accepted") << size;
    }
  }
}

TEST(Formats, RefusesMeshesOfTrianglesAndEmptyOnes) {
  const TemporaryDirectory directory;
  const GridPointer triangles =
      test::make_grid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VTK_TRIANGLE, {0, 1, 2}}});
  const GridPointer points = test::make_grid({{0, 0, 0}}, {});
  const GridPointer nothing = test::make_grid({}, {});
  for (const auto& [grid, words] : {std::pair{triangles, "cell 0 is no tet"},
                                    {points, "no tets (1 points, 0 cells)"},
                                    {nothing, "no tets (0 points, 0 cells)"}}) {
    test::add_array(*grid, "tensor", 9, test::linear_tensor);
    test::write_vtu(directory / "a.vtu", *grid);
    EXPECT_THAT(message_of(directory / "a.vtu"), HasSubstr(words));
    test::write_vtk(directory / "a.vtk", *grid, true);
    EXPECT_NE(message_of(directory / "a.vtk"), "accepted");
    EXPECT_NE(message_of(directory / "a.vtu", {.gradient_of = "U"}), "accepted");
  }
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_complex.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "temporary_directory.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {
namespace {

using test::TemporaryDirectory;

/// A triangle of a page and one of a level set, with a segment as the common side, and a node.
FeatureComplex make_complex(FeatureTable& table) {
  const Feature level = table.add_traceless();
  FeatureSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}};
  soup.segments = {{1, 0}};
  soup.features = {Feature::NeutralReal, level, Feature::TripleCurve};
  soup.source_cell = {std::int64_t{1} << 40, 6, 7};
  soup.certified = {1, 0, 1};
  soup.nodes = {2};
  return feature_complex(soup, table);
}

TEST(WriteComplex, RoundTripsEveryArray) {
  const TemporaryDirectory directory;
  FeatureTable table;
  const FeatureComplex complex = make_complex(table);
  write_complex(directory / "complex.vtu", complex, table);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((directory / "complex.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  ASSERT_EQ(grid.GetNumberOfPoints(), 4);
  ASSERT_EQ(complex.lines.size(), 5u);
  ASSERT_EQ(complex.corners.size(), 3u);
  ASSERT_EQ(grid.GetNumberOfCells(), 2 + 5 + 3);
  const auto value = [&](const char* name, vtkIdType cell) {
    return grid.GetCellData()->GetArray(name)->GetTuple1(cell);
  };
  EXPECT_EQ(grid.GetCellType(0), VTK_TRIANGLE);
  EXPECT_EQ(grid.GetCellType(2), VTK_LINE);
  EXPECT_EQ(grid.GetCellType(9), VTK_VERTEX);
  EXPECT_EQ(value("Kind", 0), 0);
  EXPECT_EQ(value("Kind", 1), 1);
  EXPECT_EQ(value("Feature", 0), 3);
  EXPECT_EQ(value("Feature", 1), 7);
  EXPECT_EQ(value("Feature", 2), 255);
  EXPECT_EQ(value("Features", 1), 128);
  EXPECT_EQ(value("DomainFront", 0), 3);
  EXPECT_EQ(value("DomainBack", 0), 2);
  EXPECT_EQ(value("DomainFront", 1), 7);
  EXPECT_EQ(value("DomainBack", 1), 6);
  EXPECT_EQ(value("DomainFront", 2), 255);
  EXPECT_EQ(value("Certified", 0), 1);
  EXPECT_EQ(value("Certified", 1), 0);
  EXPECT_EQ(value("SourceCellId", 0), 0x1p40);
  EXPECT_EQ(value("Patch", 1), 1);
  EXPECT_EQ(value("Patch", 2), -1);
  EXPECT_EQ(value("Curve", 1), -1);
  int segments = 0, nodes = 0;
  for (vtkIdType c = 2; c < 7; ++c) {
    EXPECT_GE(value("Curve", c), 0);
    EXPECT_LT(value("Curve", c), static_cast<double>(complex.curves.size()));
    if (value("Kind", c) != 2) continue;
    ++segments;
    EXPECT_EQ(value("SourceCellId", c), 7);
    EXPECT_EQ(value("Certified", c), 0) << "one triangle there is not";
    EXPECT_EQ(value("Features", c), 8 + 64 + 128);
  }
  EXPECT_EQ(segments, 1);
  for (vtkIdType c = 7; c < 10; ++c) {
    EXPECT_EQ(value("Corner", c), static_cast<double>(c - 7));
    nodes += value("Kind", c) == 6;
  }
  EXPECT_EQ(nodes, 1);
  EXPECT_THROW(write_complex("/dev/full", complex, table), IoError);
}

TEST(WriteComplex, Empty) {
  const TemporaryDirectory directory;
  write_complex(directory / "complex.vtu", {}, standard_features());
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((directory / "complex.vtu").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0);
}

TEST(WriteCrossings, RoundTripsEveryArray) {
  const TemporaryDirectory directory;
  CrossingCurves curves;
  curves.points = {{0, 0, 0}, {1, 0.1, 0}, {2, 0, 0}};
  curves.segments = {{0, 1}, {1, 2}};
  curves.features = {{Feature::NeutralReal, static_cast<Feature>(7)},
                     {Feature::BalancedLinear, static_cast<Feature>(8)}};
  curves.source_cells = {{4, 5}, {6, std::int64_t{1} << 40}};
  write_crossings(directory / "crossings.vtp", curves);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((directory / "crossings.vtp").c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  EXPECT_EQ(data.GetNumberOfLines(), 2);
  EXPECT_EQ(data.GetPoint(1)[1], 0.1);
  const auto value = [&](const char* name, vtkIdType cell) {
    return data.GetCellData()->GetArray(name)->GetTuple1(cell);
  };
  EXPECT_EQ(value("FeatureA", 0), 3);
  EXPECT_EQ(value("FeatureB", 0), 7);
  EXPECT_EQ(value("FeatureA", 1), 1);
  EXPECT_EQ(value("FeatureB", 1), 8);
  EXPECT_EQ(value("SourceCellA", 1), 6);
  EXPECT_EQ(value("SourceCellB", 1), 0x1p40);
}

}  // namespace
}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_polydata.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>
#include <limits>
#include <stdexcept>

#include "read_vtk.hpp"
#include "sample_mesh.hpp"
#include "temporary_directory.hpp"

namespace triplex {
namespace {

using test::file_content;
using test::surface;
using test::TemporaryDirectory;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

bool same_bits(vtkDataArray* array, const double* values, std::size_t size) {
  auto* doubles = vtkDoubleArray::SafeDownCast(array);
  return doubles != nullptr && doubles->GetNumberOfValues() == static_cast<vtkIdType>(size) &&
         (size == 0 || std::memcmp(doubles->GetPointer(0), values, size * sizeof(double)) == 0);
}

TEST(WritePolydata, RoundTripsBitForBit) {
  const TemporaryDirectory directory;
  const FeatureMesh mesh = surface();
  write_polydata(directory / "a.vtp", mesh, Feature::DegeneratePlanar);
  const auto data = test::read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  EXPECT_TRUE(same_bits(data->GetPoints()->GetData(), mesh.points[0].data(), 12));
  EXPECT_TRUE(same_bits(data->GetPointData()->GetArray("p"), mesh.p.data(), 4));
  EXPECT_TRUE(same_bits(data->GetPointData()->GetArray("q"), mesh.q.data(), 4));
  EXPECT_TRUE(same_bits(data->GetPointData()->GetArray("mode"), mesh.mode.data(), 4));
  ASSERT_EQ(data->GetNumberOfPolys(), 2);
  EXPECT_EQ(data->GetNumberOfLines(), 0);
  const auto ids = vtkSmartPointer<vtkIdList>::New();
  for (int c = 0; c < 2; ++c) {
    data->GetCellPoints(c, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), 3);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(ids->GetId(i), mesh.triangles[c][i]);
  }
  vtkCellData& cells = *data->GetCellData();
  ASSERT_TRUE(cells.HasArray("SourceCellId") && cells.HasArray("Feature") &&
              cells.HasArray("Certified"));
  EXPECT_EQ(cells.GetArray("SourceCellId")->GetDataTypeSize(), 8);
  EXPECT_EQ(cells.GetArray("SourceCellId")->GetTuple1(1), 0x1p40);
  EXPECT_EQ(cells.GetArray("Feature")->GetTuple1(0), 4);
  EXPECT_EQ(cells.GetArray("Feature")->GetTuple1(1), 4);
  EXPECT_EQ(cells.GetArray("Certified")->GetTuple1(0), 1);
  EXPECT_EQ(cells.GetArray("Certified")->GetTuple1(1), 0);
}

std::vector<vtkIdType> points_of_line(vtkPolyData& data, vtkIdType line) {
  const auto ids = vtkSmartPointer<vtkIdList>::New();
  data.GetCellPoints(line, ids);
  return {ids->begin(), ids->end()};
}

TEST(WritePolydata, JoinsSegmentsToPolylinesAndLoops) {
  const TemporaryDirectory directory;
  FeatureMesh mesh;
  mesh.points.resize(9);
  mesh.p = mesh.q = mesh.mode = std::vector<double>(9, 0.5);
  mesh.position_error = {1e-15, 0, 0, 0, 0, 0, 0, 0, std::numeric_limits<double>::infinity()};
  // A loop 0 1 2; an arc 3 4 5 6, of which the last part is not certified; an arc 7 8 in one cell.
  mesh.segments = {{5, 4}, {0, 1}, {2, 1}, {3, 4}, {0, 2}, {5, 6}, {8, 7}};
  mesh.source_cell = {10, 11, 12, 13, 14, 15, 16};
  mesh.certified = {1, 1, 1, 1, 1, 0, 1};
  write_polydata(directory / "a.vtp", mesh, Feature::TripleCurve);
  const auto data = test::read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  ASSERT_EQ(data->GetNumberOfLines(), 4);
  EXPECT_EQ(data->GetNumberOfPolys(), 0);
  EXPECT_THAT(points_of_line(*data, 0), testing::ElementsAre(3, 4, 5));
  EXPECT_THAT(points_of_line(*data, 1), testing::ElementsAre(5, 6));
  EXPECT_THAT(points_of_line(*data, 2), testing::ElementsAre(7, 8));
  EXPECT_THAT(points_of_line(*data, 3), testing::ElementsAre(0, 1, 2, 0));
  const auto cell_values = [&](const char* name) {
    std::vector<double> values;
    for (int c = 0; c < 4; ++c) values.push_back(data->GetCellData()->GetArray(name)->GetTuple1(c));
    return values;
  };
  EXPECT_THAT(cell_values("SourceCellId"), testing::ElementsAre(-1, 15, 16, -1));
  EXPECT_THAT(cell_values("Certified"), testing::ElementsAre(1, 0, 1, 1));
  EXPECT_THAT(cell_values("Feature"), testing::Each(6));
  auto* const sources = data->GetFieldData()->GetArray("SegmentSourceCellId");
  ASSERT_NE(sources, nullptr);
  std::vector<double> of_segments;
  for (int n = 0; n < 7; ++n) of_segments.push_back(sources->GetTuple1(n));
  EXPECT_THAT(of_segments, testing::ElementsAre(13, 10, 15, 16, 11, 12, 14));
  EXPECT_TRUE(
      same_bits(data->GetPointData()->GetArray("PositionError"), mesh.position_error.data(), 9));
}

TEST(WritePolydata, EmptyMeshesHaveAllArrays) {
  const TemporaryDirectory directory;
  write_polydata(directory / "a.vtp", {}, Feature::NeutralReal);
  const auto data = test::read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  EXPECT_EQ(data->GetNumberOfPoints(), 0);
  EXPECT_EQ(data->GetNumberOfCells(), 0);
  for (const char* name : {"mode", "p", "q"}) {
    EXPECT_TRUE(data->GetPointData()->HasArray(name)) << name;
  }
  for (const char* name : {"SourceCellId", "Feature", "Certified"}) {
    EXPECT_TRUE(data->GetCellData()->HasArray(name)) << name;
  }
}

TEST(WritePolydata, IsInlineAndDeterministic) {
  const TemporaryDirectory directory;
  write_polydata(directory / "a.vtp", surface(), Feature::NeutralReal);
  write_polydata(directory / "b.vtp", surface(), Feature::NeutralReal);
  const std::string bytes = file_content(directory / "a.vtp");
  EXPECT_EQ(bytes, file_content(directory / "b.vtp"));
  EXPECT_THAT(bytes, AllOf(HasSubstr("format=\"binary\""), Not(HasSubstr("AppendedData"))));
  EXPECT_EQ(directory.files(), 2u);
}

TEST(WritePolydata, RefusesArraysOfOtherLength) {
  const TemporaryDirectory directory;
  for (int i = 0; i < 5; ++i) {
    FeatureMesh mesh = surface();
    if (i == 0) mesh.p.pop_back();
    if (i == 1) mesh.q.pop_back();
    if (i == 2) mesh.mode.push_back(0);
    if (i == 3) mesh.source_cell.pop_back();
    if (i == 4) mesh.certified.push_back(1);
    EXPECT_THROW(write_polydata(directory / "a.vtp", mesh, Feature::NeutralReal),
                 std::invalid_argument);
  }
  EXPECT_EQ(directory.files(), 0u);
}

TEST(WritePolydata, ReportsAFullDisk) {
  EXPECT_THROW(write_polydata("/dev/full", surface(), Feature::NeutralReal), IoError);
}

/// The nodes are marked on degenerate surfaces, and only there.
TEST(WritePolydata, MarksNodes) {
  const TemporaryDirectory directory;
  FeatureMesh mesh = surface();
  mesh.nodes = {1, 3};
  for (const Feature f : {Feature::DegenerateLinear, Feature::DegeneratePlanar}) {
    write_polydata(directory / "a.vtp", mesh, f);
    const auto data = test::read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
    auto* const node = data->GetPointData()->GetArray("Node");
    ASSERT_NE(node, nullptr);
    EXPECT_EQ(node->GetDataTypeSize(), 1);
    for (vtkIdType v = 0; v < 4; ++v) EXPECT_EQ(node->GetTuple1(v), v % 2);
  }
  write_polydata(directory / "b.vtp", mesh, Feature::NeutralReal);
  const auto other = test::read_vtk<vtkXMLPolyDataReader>(directory / "b.vtp");
  EXPECT_FALSE(other->GetPointData()->HasArray("Node"));
}

}  // namespace
}  // namespace triplex

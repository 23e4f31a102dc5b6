// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_nodes.hpp"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "temporary_directory.hpp"

namespace triplex {
namespace {

using test::TemporaryDirectory;

TEST(WriteNodes, RoundTripsEveryArray) {
  const TemporaryDirectory directory;
  std::vector<Node> nodes(2);
  nodes[0].position = {0.1, -0.0, 1e300};
  nodes[0].enclosure = {Range{0, 0.2}, Range{-1, 1}, Range{1e299, 1e301}};
  nodes[0].eigenvalue = -1.0 / 3;
  nodes[0].eigenvalue_enclosure = {-0.5, -0.25};
  nodes[0].status = NodeStatus::Vertex;
  nodes[0].source_cell = std::int64_t{1} << 40;
  nodes[1].feature = Feature::DegeneratePlanar;
  write_nodes(directory / "nodes.vtp", nodes);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((directory / "nodes.vtp").c_str());
  reader->Update();
  vtkPolyData& data = *reader->GetOutput();
  ASSERT_EQ(data.GetNumberOfPoints(), 2);
  EXPECT_EQ(data.GetNumberOfVerts(), 2);
  const auto array = [&](const char* name) { return data.GetPointData()->GetArray(name); };
  for (int k = 0; k < 3; ++k) {
    const Range& range = nodes[0].enclosure[static_cast<std::size_t>(k)];
    EXPECT_EQ(data.GetPoint(0)[k], nodes[0].position[static_cast<std::size_t>(k)]);
    EXPECT_EQ(array("EnclosureLow")->GetComponent(0, k), range.lo);
    EXPECT_EQ(array("EnclosureHigh")->GetComponent(0, k), range.hi);
  }
  EXPECT_EQ(array("eigenvalue")->GetTuple1(0), -1.0 / 3);
  EXPECT_EQ(array("EigenvalueEnclosure")->GetComponent(0, 0), -0.5);
  EXPECT_EQ(array("EigenvalueEnclosure")->GetComponent(0, 1), -0.25);
  EXPECT_EQ(array("SourceCellId")->GetTuple1(0), 0x1p40);
  EXPECT_EQ(array("Feature")->GetTuple1(0), 2);
  EXPECT_EQ(array("Feature")->GetTuple1(1), 4);
  EXPECT_EQ(array("Status")->GetTuple1(0), 1);
  EXPECT_EQ(array("Status")->GetTuple1(1), 3);
  EXPECT_EQ(array("Proven")->GetTuple1(0), 1);
  EXPECT_EQ(array("Proven")->GetTuple1(1), 0);
}

TEST(WriteNodes, WritesAnEmptyFileAndReportsFullDisks) {
  const TemporaryDirectory directory;
  write_nodes(directory / "nodes.vtp", {});
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName((directory / "nodes.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_THROW(write_nodes("/dev/full", {}), IoError);
}

}  // namespace
}  // namespace triplex

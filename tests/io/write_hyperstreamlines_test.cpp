// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_hyperstreamlines.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "../trace/straight_curve.hpp"
#include "read_vtk.hpp"
#include "temporary_directory.hpp"
#include "triplex/io/write_lines.hpp"

namespace triplex {
namespace {

using test::block_tensor;
using test::crossing_curve;
using test::read_vtk;
using test::straight_curve;
using test::TemporaryDirectory;

/// Two curves: one through the degenerate surface, one that leaps after its second point, and a
/// third that is a point.
std::vector<Hyperstreamline> curves() {
  Hyperstreamline leaping =
      straight_curve({0, 0.2, 0.2, 0.4}, [](double) { return block_tensor(0.1); });
  leaping.leaps = {1};
  leaping.seed = 3;
  leaping.field = EigenvectorField::Medium;
  leaping.ends = {StemEnd::Domain, StemEnd::Length};
  leaping.points[3].tet = TetId{1};
  Hyperstreamline point = straight_curve({0}, [](double) { return block_tensor(0); });
  return {crossing_curve(), leaping, point};
}

TensorField two_cells() {
  TensorField field;
  field.source_cells = {7, 9};
  return field;
}

double value(vtkDataSetAttributes& data, const char* name, vtkIdType tuple, int component = 0) {
  vtkDataArray* const array = data.GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array == nullptr ? 0 : array->GetComponent(tuple, component);
}

TEST(WriteHyperstreamlines, PolylinesBetweenLeapsWithTheirArrays) {
  const TemporaryDirectory directory;
  write_hyperstreamlines(directory / "a.vtp", curves(), two_cells());
  const auto data = read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  ASSERT_EQ(data->GetNumberOfPoints(), 9);
  ASSERT_EQ(data->GetNumberOfLines(), 3);
  ASSERT_EQ(data->GetNumberOfVerts(), 1);
  const std::array<vtkIdType, 3> sizes = {4, 2, 2};
  const std::array<vtkIdType, 3> firsts = {0, 4, 6};
  for (vtkIdType c = 0; c < 3; ++c) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetLines()->GetCellAtId(c, size, ids);
    EXPECT_EQ(size, sizes[static_cast<std::size_t>(c)]);
    EXPECT_EQ(ids[0], firsts[static_cast<std::size_t>(c)]);
  }
  vtkCellData& cells = *data->GetCellData();  // the vertex first
  const std::array<double, 4> numbers = {2, 0, 1, 1}, follows = {0, 0, 2, 2};
  for (vtkIdType c = 0; c < 4; ++c) {
    EXPECT_EQ(value(cells, "Curve", c), numbers[static_cast<std::size_t>(c)]);
    EXPECT_EQ(value(cells, "Follows", c), follows[static_cast<std::size_t>(c)]);
  }
  EXPECT_EQ(value(cells, "EndBehind", 3), 1);
  EXPECT_EQ(value(cells, "EndAhead", 3), 4);
  vtkPointData& points = *data->GetPointData();
  EXPECT_EQ(value(points, "ArcLength", 0), -0.25);
  EXPECT_EQ(value(points, "Forward", 0, 0), 1);
  EXPECT_EQ(value(points, "Seed", 0), 1);
  EXPECT_EQ(value(points, "Seed", 4), 0);
  EXPECT_EQ(value(points, "Seed", 7), 1);
  EXPECT_EQ(value(points, "SourceCellId", 6), 7);
  EXPECT_EQ(value(points, "SourceCellId", 7), 9);
  EXPECT_EQ(value(points, "domain", 0), 2);
  EXPECT_EQ(value(points, "domain", 3), 1);
  EXPECT_EQ(value(points, "tensor", 0, 7), 0.25);
  EXPECT_NEAR(value(points, "eigenvalues", 0, 1), 0.5, 1e-11);
  EXPECT_TRUE(std::isnan(value(points, "eccentricity", 0)));
  EXPECT_NEAR(value(points, "eccentricity", 3), std::sqrt(0.75), 1e-11);
  EXPECT_NEAR(std::fabs(value(points, "dual-eigenvector-major", 3, 1)), 1, 1e-11);
}

TEST(WriteHyperstreamlines, EventsAsVertices) {
  const TemporaryDirectory directory;
  auto all = curves();
  all[1].events = {{2, 0.25, {0.25, 0, 0}, Feature::NeutralReal, 2, 3, true}};
  write_stem_events(directory / "a.vtp", all);
  const auto data = read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  vtkPointData& points = *data->GetPointData();
  const auto expect = [&](const char* name, double first, double second) {
    EXPECT_EQ(value(points, name, 0), first) << name;
    EXPECT_EQ(value(points, name, 1), second) << name;
  };
  expect("Feature", 2, 3);
  expect("DomainBefore", 2, 2);
  expect("DomainAfter", 1, 3);
  expect("DominantJumps", 0, 1);
  expect("Curve", 0, 1);
  expect("Segment", 1, 2);
  expect("Fraction", 0.5, 0.25);
  EXPECT_NEAR(value(points, "ArcLength", 0), 0, 1e-16);
  EXPECT_NEAR(value(points, "ArcLength", 1), 0.25, 1e-15);
}

TEST(WriteHyperstreamlines, ThePlantInColours) {
  const TemporaryDirectory directory;
  Plant plant;
  grow(crossing_curve(), augment(crossing_curve(), {.spacing = 0.1}),
       {.radius = 0.01, .thorn = 0.05, .leaf = 0.04}, 3, plant);
  write_plant(directory / "a.vtp", plant);
  const auto data = read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  ASSERT_EQ(static_cast<std::size_t>(data->GetNumberOfPoints()), plant.points.size());
  ASSERT_EQ(static_cast<std::size_t>(data->GetNumberOfPolys()), plant.part.size());
  vtkDataArray* const scalars = data->GetPointData()->GetScalars();
  ASSERT_NE(scalars, nullptr);
  EXPECT_STREQ(scalars->GetName(), "RGB");
  EXPECT_EQ(scalars->GetNumberOfComponents(), 3);
  EXPECT_EQ(scalars->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_NE(data->GetPointData()->GetNormals(), nullptr);
  for (std::size_t k = 0; k < plant.part.size(); k += 50) {
    const auto id = static_cast<vtkIdType>(k);
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    data->GetPolys()->GetCellAtId(id, size, corners);
    ASSERT_EQ(size, plant.ends[k + 1] - plant.ends[k]);
    EXPECT_EQ(corners[0], plant.corners[plant.ends[k]]);
    const auto corner = static_cast<std::size_t>(corners[0]);
    EXPECT_EQ(scalars->GetComponent(corners[0], 1), plant.rgb[corner][1]);
    vtkCellData& cells = *data->GetCellData();
    EXPECT_EQ(value(cells, "Part", id), static_cast<int>(plant.part[k]));
    EXPECT_EQ(value(cells, "Domain", id), plant.domain[k]);
    EXPECT_EQ(value(cells, "Eigenvector", id), plant.eigenvector[k]);
    EXPECT_EQ(value(cells, "Curve", id), 3);
  }
}

TEST(WriteHyperstreamlines, NothingIsAFileToo) {
  const TemporaryDirectory directory;
  write_hyperstreamlines(directory / "a.vtp", {}, two_cells());
  write_stem_events(directory / "b.vtp", {});
  write_plant(directory / "c.vtp", {});
  write_lines(directory / "d.vtp", {});
  for (const char* name : {"a.vtp", "b.vtp", "c.vtp", "d.vtp"})
    EXPECT_EQ(read_vtk<vtkXMLPolyDataReader>(directory / name)->GetNumberOfPoints(), 0);
}

TEST(WriteLines, ComeBack) {
  const TemporaryDirectory directory;
  const LineSet set{{{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}},
                    {{0, 2}, {2, 1, 0}},
                    {{"a", 1, {1, 2, 3}}, {"b", 2, {1, 2, 3, 4, 5, 6}}},
                    {{"n", {-1, 5}}}};
  write_lines(directory / "a.vtp", set);
  const auto data = read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  ASSERT_EQ(data->GetNumberOfLines(), 2);
  EXPECT_EQ(data->GetPoint(1)[0], 0.1);
  EXPECT_EQ(value(*data->GetPointData(), "b", 2, 1), 6);
  EXPECT_EQ(value(*data->GetCellData(), "n", 1), 5);
}

}  // namespace
}  // namespace triplex

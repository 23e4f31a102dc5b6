// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_domains.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "read_vtk.hpp"
#include "temporary_directory.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {
namespace {

using test::file_content;
using test::TemporaryDirectory;
using testing::HasSubstr;
using testing::Not;

DomainMesh mesh_of(const char* generator, int n) {
  GridOptions grid;
  grid.n = n;
  ExtractionOptions options;
  options.domains = true;
  options.max_bisections = 8;
  return extract(generator_named(generator)->generate(grid), options).domains;
}

/// Of the face stream that VTK keeps, fanned from the first point of each polygon.
double volume_in_file(vtkUnstructuredGrid& grid, vtkIdType cell) {
  vtkNew<vtkIdList> stream;
  grid.GetFaceStream(cell, stream);
  const auto point = [&](vtkIdType at) {
    Point x;
    grid.GetPoint(stream->GetId(at), x.data());
    return x;
  };
  const Point o = point(2);
  double sum = 0;
  vtkIdType at = 1;
  for (vtkIdType face = 0; face < stream->GetId(0); ++face) {
    const vtkIdType corners = stream->GetId(at);
    for (vtkIdType i = 2; i < corners; ++i) {
      const Point a = point(at + 1), b = point(at + i), c = point(at + i + 1);
      const auto d = [&](const Point& x, int k) { return x[k] - o[k]; };
      sum += d(a, 0) * (d(b, 1) * d(c, 2) - d(b, 2) * d(c, 1)) +
             d(a, 1) * (d(b, 2) * d(c, 0) - d(b, 0) * d(c, 2)) +
             d(a, 2) * (d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0));
    }
    at += corners + 1;
  }
  return sum / 6;
}

TEST(WriteDomains, RoundTripsBitForBit) {
  const TemporaryDirectory directory;
  const DomainMesh mesh = mesh_of("random-linear", 4);
  ASSERT_GT(mesh.tets.size(), 0u);
  ASSERT_GT(mesh.polyhedra(), 0u);
  write_domains(directory / "a.vtu", mesh);
  const auto grid = test::read_vtk<vtkXMLUnstructuredGridReader>(directory / "a.vtu");
  ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(mesh.cells()));
  ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    Point x;
    grid->GetPoint(static_cast<vtkIdType>(v), x.data());
    ASSERT_EQ(std::memcmp(x.data(), mesh.points[v].data(), sizeof(Point)), 0);
  }
  vtkCellData& arrays = *grid->GetCellData();
  for (const char* name : {"Domain", "SourceCellId", "Certified"})
    ASSERT_TRUE(arrays.HasArray(name)) << name;
  EXPECT_EQ(arrays.GetArray("Domain")->GetDataType(), VTK_UNSIGNED_CHAR);
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    const auto cell = static_cast<vtkIdType>(c);
    EXPECT_EQ(arrays.GetArray("Domain")->GetTuple1(cell), static_cast<double>(mesh.domain[c]));
    EXPECT_EQ(arrays.GetArray("SourceCellId")->GetTuple1(cell),
              static_cast<double>(mesh.source_cell[c]));
    EXPECT_EQ(arrays.GetArray("Certified")->GetTuple1(cell), mesh.certified[c]);
    if (c < mesh.tets.size()) {
      ASSERT_EQ(grid->GetCellType(cell), VTK_TETRA);
      EXPECT_GT(volume_approx(mesh, c), 0);
    } else {
      ASSERT_EQ(grid->GetCellType(cell), VTK_POLYHEDRON);
      EXPECT_EQ(volume_in_file(*grid, cell), volume_approx(mesh, c));
      EXPECT_GT(volume_in_file(*grid, cell), 0);
    }
  }
}

TEST(WriteDomains, WritesMeshesOfTetsOnlyAndEmptyOnes) {
  const TemporaryDirectory directory;
  DomainMesh mesh;
  write_domains(directory / "empty.vtu", mesh);
  EXPECT_EQ(
      test::read_vtk<vtkXMLUnstructuredGridReader>(directory / "empty.vtu")->GetNumberOfCells(), 0);
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.domain = {Domain::RealPlanar};
  mesh.source_cell = {std::int64_t{1} << 40};
  mesh.certified = {1};
  write_domains(directory / "tet.vtu", mesh);
  const auto grid = test::read_vtk<vtkXMLUnstructuredGridReader>(directory / "tet.vtu");
  ASSERT_EQ(grid->GetNumberOfCells(), 1);
  EXPECT_EQ(grid->GetCellType(0), VTK_TETRA);
  EXPECT_EQ(grid->GetCellData()->GetArray("Domain")->GetTuple1(0), 3);
  EXPECT_EQ(grid->GetCellData()->GetArray("SourceCellId")->GetTuple1(0), 0x1p40);
}

TEST(WriteDomains, IsInlineAndDeterministic) {
  const TemporaryDirectory directory;
  const DomainMesh mesh = mesh_of("noise", 3);
  write_domains(directory / "a.vtu", mesh);
  write_domains(directory / "b.vtu", mesh_of("noise", 3));
  const std::string bytes = file_content(directory / "a.vtu");
  EXPECT_EQ(bytes, file_content(directory / "b.vtu"));
  EXPECT_THAT(bytes, HasSubstr("format=\"binary\""));
  EXPECT_THAT(bytes, Not(HasSubstr("AppendedData")));
}

TEST(WriteDomains, RefusesArraysOfOtherLength) {
  const TemporaryDirectory directory;
  DomainMesh mesh;
  mesh.certified = {1};
  EXPECT_THROW(write_domains(directory / "a.vtu", mesh), std::invalid_argument);
  EXPECT_EQ(directory.files(), 0u);
}

TEST(WriteDomains, ReportsAFullDisk) {
  EXPECT_THROW(write_domains("/dev/full", mesh_of("noise", 2)), IoError);
}

}  // namespace
}  // namespace triplex

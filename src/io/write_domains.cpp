// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_domains.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIdTypeArray.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <stdexcept>

#include "vtk_output.hpp"

namespace triplex {
namespace {

void check(const DomainMesh& mesh) {
  const std::size_t cells = mesh.cells();
  if (mesh.domain.size() != cells || mesh.source_cell.size() != cells ||
      mesh.certified.size() != cells || mesh.first.back() != mesh.stream.size())
    throw std::invalid_argument("the arrays of the mesh of domains differ in length");
}

/// The points of every cell, each once.
vtkSmartPointer<vtkCellArray> points_of_cells(const DomainMesh& mesh) {
  const auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto points = vtkSmartPointer<vtkTypeInt64Array>::New();
  offsets->SetNumberOfValues(static_cast<vtkIdType>(mesh.cells()) + 1);
  points->Allocate(static_cast<vtkIdType>(4 * mesh.tets.size() + 8 * mesh.polyhedra()));
  vtkIdType cell = 0;
  offsets->SetValue(cell++, 0);
  for (const auto& tet : mesh.tets) {
    for (const std::uint32_t v : tet) points->InsertNextValue(v);
    offsets->SetValue(cell++, points->GetNumberOfValues());
  }
  std::vector<std::uint32_t> used;
  for (std::size_t n = 0; n < mesh.polyhedra(); ++n) {
    used.clear();
    mesh.for_each_polygon(n, [&](std::span<const std::uint32_t> corners) {
      used.insert(used.end(), corners.begin(), corners.end());
    });
    std::ranges::sort(used);
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t v : used) points->InsertNextValue(v);
    offsets->SetValue(cell++, points->GetNumberOfValues());
  }
  const auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, points);
  return result;
}

struct FaceStreams {
  vtkSmartPointer<vtkIdTypeArray> locations = vtkSmartPointer<vtkIdTypeArray>::New();  // -1: a tet
  vtkSmartPointer<vtkIdTypeArray> faces = vtkSmartPointer<vtkIdTypeArray>::New();
};
FaceStreams face_streams(const DomainMesh& mesh) {
  FaceStreams result;
  const auto tets = static_cast<vtkIdType>(mesh.tets.size());
  result.locations->SetNumberOfValues(static_cast<vtkIdType>(mesh.cells()));
  for (vtkIdType t = 0; t < tets; ++t) result.locations->SetValue(t, -1);
  result.faces->SetNumberOfValues(static_cast<vtkIdType>(mesh.stream.size() + mesh.polyhedra()));
  vtkIdType at = 0;
  for (std::size_t n = 0; n < mesh.polyhedra(); ++n) {
    const vtkIdType begin = at++;
    vtkIdType count = 0;
    result.locations->SetValue(tets + static_cast<vtkIdType>(n), begin);
    mesh.for_each_polygon(n, [&](std::span<const std::uint32_t> corners) {
      ++count;
      result.faces->SetValue(at++, static_cast<vtkIdType>(corners.size()));
      for (const std::uint32_t v : corners) result.faces->SetValue(at++, v);
    });
    result.faces->SetValue(begin, count);
  }
  return result;
}

vtkSmartPointer<vtkUnsignedCharArray> types_of_cells(const DomainMesh& mesh) {
  const auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
  types->SetNumberOfValues(static_cast<vtkIdType>(mesh.cells()));
  const auto tets = static_cast<vtkIdType>(mesh.tets.size());
  for (vtkIdType c = 0; c < types->GetNumberOfValues(); ++c)
    types->SetValue(c, c < tets ? VTK_TETRA : VTK_POLYHEDRON);
  return types;
}

}  // namespace

void write_domains(const std::filesystem::path& file, const DomainMesh& mesh) {
  check(mesh);
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(detail::to_vtk_points(mesh.points));
  const auto types = types_of_cells(mesh);
  if (mesh.polyhedra() > 0) {
    const FaceStreams streams = face_streams(mesh);
    grid->SetCells(types, points_of_cells(mesh), streams.locations, streams.faces);
  } else {
    grid->SetCells(types, points_of_cells(mesh));
  }
  static_assert(sizeof(Domain) == sizeof(std::uint8_t));
  vtkCellData& cells = *grid->GetCellData();
  cells.AddArray(detail::to_vtk_array(
      "Domain", reinterpret_cast<const std::uint8_t*>(mesh.domain.data()), mesh.domain.size()));
  cells.AddArray(
      detail::to_vtk_array("SourceCellId", mesh.source_cell.data(), mesh.source_cell.size()));
  cells.AddArray(detail::to_vtk_array("Certified", mesh.certified.data(), mesh.certified.size()));
  detail::write_xml(file, *vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), *grid);
}

}  // namespace triplex

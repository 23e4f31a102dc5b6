// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_field.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "vtk_output.hpp"

namespace triplex {
namespace {

/// VTK's writers put names into XML as they are.
std::string xml_escaped(const std::string& name) {
  std::string result;
  for (const char c : name) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

vtkSmartPointer<vtkUnstructuredGrid> to_vtk(const TensorField& field, const std::string& name,
                                            std::span<const Point> velocities) {
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(detail::to_vtk_points(field.mesh.points));
  const auto offsets = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto vertices = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto tets = static_cast<vtkIdType>(field.mesh.tets.size());
  offsets->SetNumberOfValues(tets + 1);
  vertices->SetNumberOfValues(4 * tets);
  for (vtkIdType t = 0; t < tets; ++t) {
    offsets->SetValue(t, 4 * t);
    for (int i = 0; i < 4; ++i) {
      vertices->SetValue(4 * t + i, static_cast<vtkTypeInt64>(
                                        index(field.mesh.tets[static_cast<std::size_t>(t)][i])));
    }
  }
  offsets->SetValue(tets, 4 * tets);
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, vertices);
  grid->SetCells(VTK_TETRA, cells);
  const double* values = field.tensors.empty() ? nullptr : field.tensors.front().data();
  grid->GetPointData()->AddArray(detail::to_vtk_array(name, values, field.tensors.size(), 9));
  if (!velocities.empty())
    grid->GetPointData()->AddArray(
        detail::to_vtk_array("velocity", velocities.front().data(), velocities.size(), 3));
  return grid;
}

}  // namespace

bool can_write_field(const std::filesystem::path& file) {
  return file.extension() == ".vtu" || file.extension() == ".vtk";
}

void write_field(const std::filesystem::path& file, const TensorField& field,
                 std::span<const Point> velocities) {
  if (!can_write_field(file)) {
    throw IoError(file.string() + ": cannot write: unknown kind of file; choose .vtu or .vtk");
  }
  const std::string name = field.array_name.empty() ? "tensor" : field.array_name;
  const bool xml = file.extension() == ".vtu";
  const auto grid = to_vtk(field, xml ? xml_escaped(name) : name, velocities);
  if (xml) {
    detail::write_xml(file, *vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), *grid);
  } else {
    detail::write_legacy(file, *vtkSmartPointer<vtkUnstructuredGridWriter>::New(), *grid);
  }
}

}  // namespace triplex

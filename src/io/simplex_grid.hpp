// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <filesystem>
#include <span>
#include <vector>

#include "vtk_output.hpp"

namespace triplex::detail {

/// An unstructured grid of simplices, cell by cell. It refers to points and arrays, which must
/// outlive it.
class SimplexGrid {
 public:
  explicit SimplexGrid(const std::vector<Point>& points) {
    grid_->SetPoints(to_vtk_points(points));
  }
  void add(std::span<const std::uint32_t> points) {
    constexpr std::array<unsigned char, 5> kTypes = {0, VTK_VERTEX, VTK_LINE, VTK_TRIANGLE,
                                                     VTK_TETRA};
    std::array<vtkIdType, 4> ids{};
    for (std::size_t i = 0; i < points.size(); ++i) ids[i] = points[i];
    cells_->InsertNextCell(static_cast<vtkIdType>(points.size()), ids.data());
    types_->InsertNextValue(kTypes[points.size()]);
  }
  /// Takes no copy: the values must last until `write`.
  template <class T>
  void add_array(const char* name, const std::vector<T>& values) {
    grid_->GetCellData()->AddArray(to_vtk_array(name, values.data(), values.size()));
  }
  template <class T>
  void add_array(const char* name, std::vector<T>&& values) = delete;
  void write(const std::filesystem::path& file) {
    grid_->SetCells(types_, cells_);
    write_xml(file, *vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New(), *grid_);
  }

 private:
  vtkSmartPointer<vtkUnstructuredGrid> grid_ = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> types_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

}  // namespace triplex::detail

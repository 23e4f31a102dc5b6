// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkCellArray.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <vector>

namespace triplex::detail {

/// Cells of any number of points.
inline vtkSmartPointer<vtkCellArray> to_vtk_lines(
    const std::vector<std::vector<std::uint32_t>>& lines) {
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const std::uint32_t point : line) cells->InsertCellPoint(point);
  }
  return cells;
}

/// One vertex cell per point.
inline vtkSmartPointer<vtkCellArray> to_vtk_vertices(std::size_t points) {
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t k = 0; k < points; ++k) {
    const auto id = static_cast<vtkIdType>(k);
    cells->InsertNextCell(1, &id);
  }
  return cells;
}

}  // namespace triplex::detail

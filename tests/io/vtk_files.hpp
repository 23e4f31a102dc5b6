// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex::test {

/// A mesh of arbitrary cells, to be written with VTK.
struct Cell {
  int type;
  std::vector<vtkIdType> points;
};

using GridPointer = vtkSmartPointer<vtkUnstructuredGrid>;

inline GridPointer make_grid(const std::vector<Point>& points, const std::vector<Cell>& cells,
                             int precision = VTK_DOUBLE) {
  const auto grid = GridPointer::New();
  vtkNew<vtkPoints> vertices;
  vertices->SetDataType(precision);
  for (const Point& x : points) vertices->InsertNextPoint(x.data());
  grid->SetPoints(vertices);
  for (const Cell& cell : cells) {
    grid->InsertNextCell(cell.type, static_cast<vtkIdType>(cell.points.size()), cell.points.data());
  }
  return grid;
}

/// Adds a point array; `value(x)` gives as many numbers as there are components.
template <class Array = vtkDoubleArray>
void add_array(vtkUnstructuredGrid& grid, const std::string& name, int components,
               const std::function<std::vector<double>(const Point&)>& value) {
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  for (vtkIdType i = 0; i < grid.GetNumberOfPoints(); ++i) {
    Point x;
    grid.GetPoint(i, x.data());
    array->InsertNextTuple(value(x).data());
  }
  grid.GetPointData()->AddArray(array);
}

/// Nine numbers that are linear in space, with dyadic coefficients.
inline std::vector<double> linear_tensor(const Point& x) {
  std::vector<double> t(9);
  for (int i = 0; i < 9; ++i) {
    t[static_cast<std::size_t>(i)] = i - 4 + 0.5 * x[0] * (i % 3) - 0.25 * x[1] * (i % 4) + x[2];
  }
  return t;
}

enum class Encoding { Ascii, Inline, Compressed, AppendedRaw, AppendedBase64 };

inline void write_vtu(const std::filesystem::path& file, vtkUnstructuredGrid& grid,
                      Encoding encoding = Encoding::Inline) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(&grid);
  if (encoding == Encoding::Ascii) writer->SetDataModeToAscii();
  if (encoding == Encoding::Inline || encoding == Encoding::Compressed) {
    writer->SetDataModeToBinary();
  }
  if (encoding == Encoding::AppendedRaw || encoding == Encoding::AppendedBase64) {
    writer->SetDataModeToAppended();
    writer->SetEncodeAppendedData(encoding == Encoding::AppendedBase64);
  }
  if (encoding != Encoding::Compressed) writer->SetCompressorTypeToNone();
  writer->Write();
}

inline void write_vtk(const std::filesystem::path& file, vtkUnstructuredGrid& grid, bool binary) {
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(&grid);
  if (binary) writer->SetFileTypeToBinary();
  writer->Write();
}

}  // namespace triplex::test

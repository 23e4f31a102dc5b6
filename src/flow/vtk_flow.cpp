// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_flow.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

namespace triplex::detail {

vtkSmartPointer<vtkUnstructuredGrid> flow_grid(const VectorField& field, double factor) {
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& x : field.mesh.points) points->InsertNextPoint(x.data());
  grid->SetPoints(points);
  vtkNew<vtkCellArray> cells;
  for (const auto& tet : field.mesh.tets) {
    cells->InsertNextCell(4);
    for (const VertexId v : tet) cells->InsertCellPoint(static_cast<vtkIdType>(index(v)));
  }
  grid->SetCells(VTK_TETRA, cells);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName(kVelocity);
  vectors->SetNumberOfComponents(3);
  for (const auto& [x, y, z] : field.vectors)
    vectors->InsertNextTuple3(factor * x, factor * y, factor * z);
  grid->GetPointData()->SetVectors(vectors);
  return grid;
}

LineSet take_lines(vtkPolyData& data) {
  LineSet set;
  set.points.resize(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t k = 0; k < set.points.size(); ++k)
    data.GetPoint(static_cast<vtkIdType>(k), set.points[k].data());
  vtkCellArray& lines = *data.GetLines();
  for (vtkIdType c = 0; c < lines.GetNumberOfCells(); ++c) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines.GetCellAtId(c, size, ids);
    set.lines.emplace_back(ids, ids + size);
  }
  return set;
}

PointValues take_point_values(vtkPolyData& data, const std::string& name, const std::string& as) {
  PointValues result{as, 1, {}};
  vtkDataArray* const array = data.GetPointData()->GetArray(name.c_str());
  if (array == nullptr) return result;
  result.components = array->GetNumberOfComponents();
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
    for (int i = 0; i < result.components; ++i) result.values.push_back(array->GetComponent(k, i));
  return result;
}

}  // namespace triplex::detail

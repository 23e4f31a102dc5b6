// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_grid.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "triplex/bernstein/forms.hpp"

namespace triplex {

double* values_of(vtkUnstructuredGrid& grid, const char* name) {
  return vtkDoubleArray::SafeDownCast(grid.GetPointData()->GetArray(name))->GetPointer(0);
}

double* add_values(vtkUnstructuredGrid& grid, const char* name) {
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  values->SetNumberOfTuples(grid.GetNumberOfPoints());
  grid.GetPointData()->AddArray(values);
  return values->GetPointer(0);
}

vtkSmartPointer<vtkUnstructuredGrid> contour_grid(const TensorField& field) {
  const auto count = static_cast<vtkIdType>(field.mesh.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType v = 0; v < count; ++v)
    points->SetPoint(v, field.mesh.points[static_cast<std::size_t>(v)].data());
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(field.mesh.tets.size()),
                       static_cast<vtkIdType>(4 * field.mesh.tets.size()));
  for (const auto& tet : field.mesh.tets) {
    std::array<vtkIdType, 4> ids;
    for (int i = 0; i < 4; ++i) ids[i] = static_cast<vtkIdType>(index(tet[i]));
    cells->InsertNextCell(4, ids.data());
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  for (const char* name : kInvariantArrays) add_values(*grid, name);
  return grid;
}

void sample_invariants(const TensorField& field, vtkUnstructuredGrid& grid) {
  double* p = values_of(grid, kMinorArray);
  double* q = values_of(grid, kDeterminantArray);
  double* d = values_of(grid, kDiscriminantArray);
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    const auto f = forms_of<double, 1>({triple_deviator(field.tensors[v])});
    p[v] = f.p[0];
    q[v] = f.q[0];
    d[v] = -(2 * p[v] * p[v] * p[v] + 3 * q[v] * q[v]);
  }
}

}  // namespace triplex

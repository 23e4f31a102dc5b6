// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_contours.hpp"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <array>
#include <chrono>

#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

constexpr std::array<const char*, 3> kArrays = {"minor", "determinant", "discriminant"};

double* values_of(vtkUnstructuredGrid& grid, const char* name) {
  return vtkDoubleArray::SafeDownCast(grid.GetPointData()->GetArray(name))->GetPointer(0);
}

}  // namespace

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
  for (const char* name : kArrays) {
    vtkNew<vtkDoubleArray> values;
    values->SetName(name);
    values->SetNumberOfTuples(count);
    grid->GetPointData()->AddArray(values);
  }
  return grid;
}

void sample_invariants(const TensorField& field, vtkUnstructuredGrid& grid) {
  double* p = values_of(grid, kArrays[0]);
  double* q = values_of(grid, kArrays[1]);
  double* d = values_of(grid, kArrays[2]);
  for (std::size_t v = 0; v < field.tensors.size(); ++v) {
    const auto f = forms_of<double, 1>({triple_deviator(field.tensors[v])});
    p[v] = f.p[0];
    q[v] = f.q[0];
    d[v] = -(2 * p[v] * p[v] * p[v] + 3 * q[v] * q[v]);
  }
}

ContourRun run_contours(vtkUnstructuredGrid& grid, const ContourOptions& options) {
  ContourRun result;
  for (const char* name : kArrays) {
    vtkNew<vtkContour3DLinearGrid> contour;
    contour->SetInputData(&grid);
    contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    contour->SetValue(0, 0.0);
    contour->SetMergePoints(options.merge_points);
    contour->SetInterpolateAttributes(false);
    contour->SetComputeNormals(false);
    contour->SetComputeScalars(false);
    contour->SetSequentialProcessing(options.sequential);
    const auto start = std::chrono::steady_clock::now();
    contour->Update();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    result.seconds += elapsed.count();
    auto* surface = vtkPolyData::SafeDownCast(contour->GetOutputDataObject(0));
    if (surface == nullptr) continue;
    result.triangles += static_cast<std::size_t>(surface->GetNumberOfPolys());
    result.points += static_cast<std::size_t>(surface->GetNumberOfPoints());
  }
  return result;
}

}  // namespace triplex

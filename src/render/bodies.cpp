// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bodies.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkClipPolyData.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSphereSource.h>
#include <vtkStripper.h>
#include <vtkTubeFilter.h>

#include <limits>

namespace triplex {
namespace {

constexpr double kCrease = 50;  // degrees: our choice; patches of a smooth surface meet at less

vtkSmartPointer<vtkPolyData> with_cells(vtkPolyData* mesh, vtkCellArray* vertices,
                                        vtkCellArray* lines, vtkCellArray* polygons) {
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(mesh->GetPoints());
  part->GetPointData()->ShallowCopy(mesh->GetPointData());
  if (vertices != nullptr) part->SetVerts(vertices);
  if (lines != nullptr) part->SetLines(lines);
  if (polygons != nullptr) part->SetPolys(polygons);
  return part;
}

// The active scalars of the cells from `first` on become those of `part`, which holds these cells.
void copy_cell_colors(vtkPolyData* mesh, vtkIdType first, vtkPolyData* part) {
  vtkDataArray* const all = mesh->GetCellData()->GetScalars();
  if (all == nullptr) return;
  auto some = vtkSmartPointer<vtkDataArray>::Take(all->NewInstance());
  some->SetName(all->GetName());
  some->SetNumberOfComponents(all->GetNumberOfComponents());
  const vtkIdType count = part->GetNumberOfCells();
  some->SetNumberOfTuples(count);
  if (count > 0) some->InsertTuples(0, count, first, all);
  part->GetCellData()->SetScalars(some);
}

}  // namespace

vtkSmartPointer<vtkPolyData> clipped(vtkPolyData* mesh, const Bounds& box) {
  vtkSmartPointer<vtkPolyData> rest = mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      double normal[3] = {0, 0, 0}, origin[3] = {0, 0, 0};
      normal[axis] = upper ? -1 : 1;
      origin[axis] = box[axis][upper ? 1 : 0];
      vtkNew<vtkPlane> plane;
      plane->SetNormal(normal);
      plane->SetOrigin(origin);
      vtkNew<vtkClipPolyData> clip;
      clip->SetInputData(rest);
      clip->SetClipFunction(plane);
      clip->Update();
      rest = clip->GetOutput();
    }
  }
  return rest;
}

vtkSmartPointer<vtkPolyData> smooth_surface(vtkPolyData* mesh) {
  auto surface = with_cells(mesh, nullptr, nullptr, mesh->GetPolys());
  copy_cell_colors(mesh, mesh->GetNumberOfVerts() + mesh->GetNumberOfLines(), surface);
  if (vtkDataArray* const normals = mesh->GetPointData()->GetArray("Normals");
      normals != nullptr && normals->GetNumberOfComponents() == 3) {
    surface->GetPointData()->SetNormals(normals);
    return surface;
  }
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(kCrease);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyData> tubes_around(vtkPolyData* mesh, double radius, bool join) {
  auto lines = with_cells(mesh, nullptr, mesh->GetLines(), nullptr);
  lines->GetPointData()->SetActiveNormals(nullptr);  // tubes make their own
  if (join) {
    vtkNew<vtkStripper> joined;
    joined->SetInputData(lines);
    joined->JoinContiguousSegmentsOn();
    joined->SetMaximumLength(std::numeric_limits<int>::max());
    joined->Update();
    lines = joined->GetOutput();
  } else {
    copy_cell_colors(mesh, mesh->GetNumberOfVerts(), lines);
  }
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(12);
  tubes->CappingOn();
  tubes->Update();
  return tubes->GetOutput();
}

vtkSmartPointer<vtkPolyData> spheres_around(vtkPolyData* mesh, double radius) {
  auto points = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> places;
  vtkDataArray* const colors = mesh->GetPointData()->GetScalars();
  vtkSmartPointer<vtkDataArray> kept;
  if (colors != nullptr) {
    kept = vtkSmartPointer<vtkDataArray>::Take(colors->NewInstance());
    kept->SetNumberOfComponents(colors->GetNumberOfComponents());
  }
  vtkCellArray* const cells = mesh->GetVerts();
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (cells->InitTraversal(); cells->GetNextCell(count, ids) != 0;) {
    for (vtkIdType k = 0; k < count; ++k) {
      places->InsertNextPoint(mesh->GetPoint(ids[k]));
      if (kept) kept->InsertNextTuple(ids[k], colors);
    }
  }
  points->SetPoints(places);
  if (kept) points->GetPointData()->SetScalars(kept);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(16);
  vtkNew<vtkGlyph3D> spheres;
  spheres->SetInputData(points);
  spheres->SetSourceConnection(ball->GetOutputPort());
  spheres->SetScaleModeToDataScalingOff();
  spheres->SetColorModeToColorByScalar();
  spheres->Update();
  return spheres->GetOutput();
}

}  // namespace triplex

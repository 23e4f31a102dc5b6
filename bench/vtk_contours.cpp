// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_contours.hpp"

#include <vtkContour3DLinearGrid.h>
#include <vtkDataObject.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <chrono>

#include "sampled_grid.hpp"

namespace triplex {

ContourRun run_contours(vtkUnstructuredGrid& grid, const ContourOptions& options) {
  ContourRun result;
  for (const char* name : kInvariantArrays) {
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

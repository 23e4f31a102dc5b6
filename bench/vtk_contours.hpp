// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Which variant of `vtkContour3DLinearGrid` is timed.
struct ContourOptions {
  bool merge_points = true;  ///< shared vertices, like an indexed mesh; off: a triangle soup
  bool sequential = true;
};

/// The mesh of a field as VTK's grid, with three arrays of doubles at the vertices: minor,
/// determinant and discriminant of the deviator, still to be filled.
vtkSmartPointer<vtkUnstructuredGrid> contour_grid(const TensorField& field);

/// Samples the three invariants at the vertices, in plain doubles.
void sample_invariants(const TensorField& field, vtkUnstructuredGrid& grid);

/// What one run of the three contours at zero made, and its seconds of wall time.
struct ContourRun {
  double seconds = 0;
  std::size_t triangles = 0, points = 0;
};
ContourRun run_contours(vtkUnstructuredGrid& grid, const ContourOptions& options);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkUnstructuredGrid.h>

#include <cstddef>

namespace triplex {

/// Which variant of `vtkContour3DLinearGrid` is timed.
struct ContourOptions {
  bool merge_points = true;  ///< shared vertices, like an indexed mesh; off: a triangle soup
  bool sequential = true;
};

/// What one run of the three contours at zero made, and its seconds of wall time.
struct ContourRun {
  double seconds = 0;
  std::size_t triangles = 0, points = 0;
};
/// The grid is one of `contour_grid`, its arrays filled.
ContourRun run_contours(vtkUnstructuredGrid& grid, const ContourOptions& options);

}  // namespace triplex

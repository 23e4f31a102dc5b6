// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "triplex/field/vector_field.hpp"
#include "triplex/io/write_lines.hpp"

class vtkPolyData;
class vtkUnstructuredGrid;

namespace triplex::detail {

/// The mesh with the vectors, times a factor, as the active point array `kVelocity`.
vtkSmartPointer<vtkUnstructuredGrid> flow_grid(const VectorField& field, double factor = 1);
inline constexpr const char* kVelocity = "velocity";

/// Points and polylines, without arrays.
LineSet take_lines(vtkPolyData& data);

/// A point array of `data`, or nothing if it has none of that name.
PointValues take_point_values(vtkPolyData& data, const std::string& name, const std::string& as);

}  // namespace triplex::detail

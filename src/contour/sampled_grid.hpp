// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <array>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Names of the arrays of `contour_grid`.
inline constexpr const char* kMinorArray = "minor";
inline constexpr const char* kDeterminantArray = "determinant";
inline constexpr const char* kDiscriminantArray = "discriminant";
inline constexpr std::array<const char*, 3> kInvariantArrays = {kMinorArray, kDeterminantArray,
                                                                kDiscriminantArray};

/// The mesh of a field as VTK's grid, with three arrays of doubles at the vertices: minor,
/// determinant and discriminant of the deviator, still to be filled.
vtkSmartPointer<vtkUnstructuredGrid> contour_grid(const TensorField& field);

/// Samples the three invariants at the vertices, in plain doubles, up to constant positive factors:
/// the forms P, Q and -(2 P^3 + 3 Q^2) of docs/notation.md.
void sample_invariants(const TensorField& field, vtkUnstructuredGrid& grid);

/// The values of an array of doubles of that name.
double* values_of(vtkUnstructuredGrid& grid, const char* name);

/// Adds such an array, of one value per vertex.
double* add_values(vtkUnstructuredGrid& grid, const char* name);

}  // namespace triplex

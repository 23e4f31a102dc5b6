// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "raw_field.hpp"
#include "triplex/io/read_field.hpp"

namespace triplex::detail {

struct LoadedGrid {
  vtkSmartPointer<vtkUnstructuredGrid> grid;
  bool pieces;  ///< it consists of pieces, with points of their own
};

/// Reads a .vtu, .pvtu or legacy .vtk file, by extension.
/// \throw BadInput, without the name of the file, if it cannot be read as an unstructured grid.
LoadedGrid load_grid(const std::filesystem::path& file);

inline constexpr int kTensorComponents = 9, kSymmetricComponents = 6, kVectorComponents = 3;

std::string name_of(vtkDataArray& array);

/// The point array that the options name, or the only one with as many components as they need: 9,
/// with `symmetric_order` 6, with `gradient_of` 3. \throw BadInput with the arrays there are.
vtkDataArray& choose_array(vtkUnstructuredGrid& grid, const ReadOptions& options);

/// The place in a row-major tensor, on or above the diagonal, of each of the six components that
/// "xx,yy,zz,xy,yz,xz" or the like lists. \throw BadInput.
std::array<int, 6> parse_symmetric_order(const std::string& order);

/// The flags of vtkGhostType for points or cells, or null. \pre size is their number.
const unsigned char* ghost_flags(vtkDataSetAttributes& data, vtkIdType size);

/// Takes the cells as tets: those that are none are split, ghosts are left out.
/// \pre field.mesh.points are those of the grid. \throw BadInput for other cells and bad ids.
void take_cells(vtkUnstructuredGrid& grid, TensorField& field);

/// Takes points, tets and values out of a grid. \throw BadInput also for unsuitable arrays.
RawField take_field(vtkUnstructuredGrid& grid, const ReadOptions& options);

/// Sets the tensors to the gradient of `raw.vectors` by VTK's gradient filter on the cells that
/// were taken. Points with equal coordinates and vectors are one for that purpose if `join`, and in
/// pieces, where cells count once. \throw BadInput where there is no gradient.
void take_gradients(vtkUnstructuredGrid& grid, RawField& raw, bool join);

}  // namespace triplex::detail

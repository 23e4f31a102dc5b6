// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// The extension in lower case, with the dot.
std::string lower_extension(const std::filesystem::path& file);

/// Reads a .vtu, .pvtu or legacy .vtk file, by extension.
/// \throw BadInput, without the name of the file, if it cannot be read as an unstructured grid.
vtkSmartPointer<vtkUnstructuredGrid> load_grid(const std::filesystem::path& file);

/// A field as it stands in a file: not checked beyond types, sizes and ranges of ids.
struct RawField {
  TensorField field;
  /// 1 for points that another piece owns. Empty if no point is flagged.
  std::vector<std::uint8_t> copies;
};

/// Takes tets and tensors out of a grid; ghost cells are left out. The array is chosen by name, or
/// it is the only one with nine components. \throw BadInput for other cells and unsuitable arrays.
RawField take_field(vtkUnstructuredGrid& grid, const std::string& tensor_name);

/// Makes one mesh of the pieces of a partitioned file: joins points with equal coordinates and
/// tensors, leaves out repeated cells and points without cells. \throw BadInput if tensors differ.
TensorField join_pieces(RawField raw);

}  // namespace triplex::detail

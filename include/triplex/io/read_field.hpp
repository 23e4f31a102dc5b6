// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/input_check.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

struct ReadOptions {
  /// Name of the point array with nine components. Empty: the only one there is.
  std::string tensor_name = {};
  /// Name of a point array with three components: the tensors are its gradient, d u_i / d x_j, as
  /// VTK's gradient filter computes it. Excludes `tensor_name` and `symmetric_order`.
  std::string gradient_of = {};
  /// Take the transposes of the tensors, as for a gradient stored as d u_j / d x_i.
  bool transpose = false;
  /// The tensors have six components, in this order: each of xx, yy, zz, xy, yz, xz once,
  /// separated by commas. Empty: they have nine.
  std::string symmetric_order = {};
  /// As in `InputOptions`.
  bool merge_points = false;
  bool fix_orientation = false;
};

/// Reads a tensor field from a .vtu, .pvtu or legacy .vtk file (docs/formats.md) and
/// checks it with `check_input`. Numbers are taken over exactly; 32-bit floats are doubles already.
/// Hexahedra, voxels, wedges and pyramids are cut into tets with `split_cell`; `TensorField::split`
/// counts them. A gradient is computed in doubles at the points, as the mean of the gradients in
/// the cells there; the result is what is taken as exact.
/// Cells flagged as duplicate or hidden by `vtkGhostType` are left out. The pieces of a file are
/// joined: points with equal coordinates and equal tensors become one, repeated cells are left
/// out; where one of two such points is flagged as a duplicate, the tensor of the other one holds.
/// A gradient is that on the joined mesh.
/// `repairs`, if given, receives what `merge_points` and `fix_orientation` did.
/// Not to be called from two threads at a time, nor while other code uses VTK's output window.
/// \throw BadInput: one line that begins with the name of the file, for whatever is wrong with it.
TensorField read_field(const std::filesystem::path& file, const ReadOptions& options = {},
                       InputRepairs* repairs = nullptr);

}  // namespace triplex

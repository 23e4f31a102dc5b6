// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/io/write_polydata.hpp"

namespace triplex {

struct ImportOptions {
  /// The step or time to take. Nothing: the last one.
  std::optional<double> time = {};
  /// OpenFOAM: the volume vector field whose gradient the tensors are. Empty, and no
  /// `tensor_name`: U.
  std::string gradient_of = {};
  /// OpenFOAM: the volume tensor field that the tensors are. Of a name "grad(...)" the transposes
  /// are taken, since OpenFOAM stores d u_j / d x_i. Excludes `gradient_of`.
  std::string tensor_name = {};
};

/// A solver's result as a field, with what else it has at the points.
struct ImportedCase {
  TensorField field;
  std::vector<PointValues> arrays;
  double time = 0;
};

/// Reads the result of a solver, by kind of path: a CalculiX result file (.frd, ASCII) or an
/// OpenFOAM case (a directory). The field passed `check_input`; no point is without a tet.
/// CalculiX: tensors are the first Piola-Kirchhoff stress P = J s F^-T of the Cauchy stress s
/// (STRESS); F = I + d u_i / d X_j, the gradient of the displacement (DISP) as `read_field`
/// computes gradients; `arrays` are `cauchy`, `F` (9, row-major) and `displacement` (3), all on the
/// undeformed mesh. Of elements of second order only the corners are taken, for F too.
/// OpenFOAM: through VTK's reader, in single precision and with its means of cells at points;
/// tensors are d u_i / d x_j; `arrays` is the vector field, called `velocity` if it is U.
/// Not to be called from two threads at a time, nor while other code uses VTK's output window.
/// \throw BadInput: one line that begins with the path, for whatever is wrong with it.
ImportedCase import_case(const std::filesystem::path& path, const ImportOptions& options = {});

}  // namespace triplex

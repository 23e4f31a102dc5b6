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

/// What a solver computed, as a field, and further arrays at its points.
struct ImportedField {
  TensorField field;
  std::vector<PointValues> values;
  double time = 0;  ///< of the solver
};

/// Reads displacements and stresses from a CalculiX result (.frd, ASCII) at `time`, or the last
/// one.
/// The mesh is the undeformed one; hexahedra and wedges are cut into tets by `split_cell`, of
/// quadratic elements only the corners are points. The tensor is the first Piola-Kirchhoff stress
/// P = J s F^-T, P N dA = s n da, with J = det F; further arrays: `cauchy` (s, 9), `F` (9, the mean
/// over the elements around a point of the deformation gradient that each has at that corner by its
/// own shape functions) and `displacement` (3). Row-major; F has d x_i / d X_j in row i, column j.
/// Stresses are those that CalculiX wrote at the points: extrapolated from within the elements, and
/// averaged. Numbers have the six digits of the file.
/// \throw BadInput: one line that begins with the name of the file and names the line at fault.
ImportedField import_frd(const std::filesystem::path& file, std::optional<double> time = {});

/// Reads a volume field of an OpenFOAM case, given by its directory, at `time`, or the last one.
/// `array` is the velocity (3 components), whose gradient is then computed at the points as by
/// `read_field`, or its gradient (9 components), which OpenFOAM stores as d u_j / d x_i and which is
/// transposed. Values in cells become values at points: inside by the inverses of the distances to
/// the centres of the cells around; on the boundary likewise from its faces alone, so that walls
/// have the values of their boundary conditions, where the file gives them (fixedValue does; noSlip
/// and slip do not, and have those of the cells). Hexahedra, wedges and pyramids are cut into tets.
/// Further arrays: `velocity`, if it was read.
/// \throw BadInput: one line that begins with the name of the directory.
ImportedField import_openfoam(const std::filesystem::path& directory,
                              const std::string& array = "U", std::optional<double> time = {});

}  // namespace triplex

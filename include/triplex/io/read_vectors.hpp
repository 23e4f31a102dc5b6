// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "triplex/field/input_check.hpp"
#include "triplex/field/vector_field.hpp"

namespace triplex {

/// Reads a point array with three components from a .vtu, .pvtu or legacy .vtk file. Mesh, cells
/// that are no tets, ghosts and pieces are treated, and checked, as by `read_field`; points that no
/// tet uses are left out.
/// Not to be called from two threads at a time, nor while other code uses VTK's output window.
/// \throw BadInput: one line that begins with the name of the file.
VectorField read_vectors(const std::filesystem::path& file, const std::string& array_name,
                         const InputOptions& repairs = {});

}  // namespace triplex

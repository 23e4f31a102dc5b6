// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex {

/// Reads points, such as seeds: those of a .vtp, .vtu, .pvtu or legacy .vtk file, in their order,
/// or of a text file with one point per line: three numbers with blanks or commas between; empty
/// lines and what follows a # do not count.
/// Not to be called from two threads at a time, nor while other code uses VTK's output window.
/// \throw BadInput: one line that begins with the name of the file, also if there are no points or
/// coordinates that are not finite.
std::vector<Point> read_points(const std::filesystem::path& file);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "vtk_messages.hpp"

namespace triplex::detail {

/// The extension in lower case, with the dot.
std::string lower_extension(const std::filesystem::path& file);

/// \throw BadInput, without the name of the file, if it is missing, a directory, unreadable, empty.
void check_readable(const std::filesystem::path& file);

/// Runs a reader of `file`; whatever VTK has to say about it becomes one line.
/// \throw BadInput, without the name of the file.
vtkSmartPointer<vtkDataObject> run_reader(vtkAlgorithm& reader, const std::filesystem::path& file,
                                          const VtkMessages& messages);

/// VTK guesses at versions of legacy files that it cannot read, and may crash on what it then takes
/// for cells.
bool has_legacy_header(const std::filesystem::path& file);

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "triplex/field/tensor_field.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {

/// Whether `write_field` knows the extension of the file: .vtu or .vtk.
bool can_write_field(const std::filesystem::path& file);

/// Writes a field as .vtu (inline base64) or legacy .vtk (binary), by extension. Doubles are
/// written bit for bit; equal fields give equal bytes. The array is called `field.array_name`, or
/// "tensor". Guarantee: all or nothing, as `write_file_atomically`. \throw IoError, also for other
/// extensions.
/// `velocities`, one per point, become the array `velocity` if there are any.
void write_field(const std::filesystem::path& file, const TensorField& field,
                 std::span<const Point> velocities = {});

}  // namespace triplex

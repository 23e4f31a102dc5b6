// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "triplex/extract/extraction.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {

/// Writes one feature as .vtp (inline base64), an empty one too. Point arrays: `mode`, `p`, `q`
/// (Float64). Cell arrays: `SourceCellId` (Int64), `Feature` (UInt8, the number of the `Feature`),
/// `Certified` (UInt8). Segments come before triangles in the cell arrays, as in VTK.
/// Guarantee: all or nothing, as `write_file_atomically`; equal meshes give equal bytes.
/// \pre one p, q and mode per point; one source cell and certified flag per cell. \throw IoError.
void write_polydata(const std::filesystem::path& file, const FeatureMesh& mesh, Feature feature);

}  // namespace triplex

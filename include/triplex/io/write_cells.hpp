// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "triplex/extract/identical.hpp"
#include "triplex/extract/unresolved.hpp"

namespace triplex {

/// Writes the open cells as a .vtu file of tets with the cell arrays `Features` (Int64, a bit per
/// feature), `Obstacle` (UInt8, the number of the `Obstacle`), `Depth` (UInt8) and `SourceCellId`.
/// Guarantee: all or nothing; equal cells give equal bytes. \throw IoError; std::invalid_argument
/// if the arrays differ in length.
void write_open_cells(const std::filesystem::path& file, const OpenCells& cells);

/// Writes the simplices on which something vanishes identically as a .vtu file of tets, triangles
/// and lines with the cell arrays `Holds` (UInt8, a bit per `Identity`) and `OnBoundary` (UInt8).
/// Guarantee: all or nothing; equal simplices give equal bytes. \throw IoError.
void write_identical(const std::filesystem::path& file, const IdenticalSimplices& identical);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "triplex/io/atomic_file.hpp"
#include "triplex/verify/audit.hpp"

namespace triplex {

/// Writes the tets of the cells where two methods differ as a .vtu file, once for each feature that
/// differs there, with the cell arrays `SourceCellId` (Int64), `Feature`, `Kind`, `Ruling` (the
/// numbers of the `Feature`, `DifferenceKind` and `Ruling`), `ReferenceOpen`, `OtherOpen` (UInt8),
/// and of the pieces of each side `ReferenceComponents`, `OtherComponents` (Int64). Guarantee: all
/// or nothing; equal differences give equal bytes. \throw IoError.
void write_differing_cells(const std::filesystem::path& file, const TensorField& field,
                           std::span<const Difference> differences);

/// Writes as a .vtp file the witnesses, as lines, and what both sides have in the cells where they
/// differ, as lines and triangles. Cell arrays: `Side` (UInt8; 0 reference, 1 other, 2 witness),
/// `SourceCellId` (Int64), `Feature`, `Kind`, `Ruling` (UInt8) and, of witnesses, `Exact`,
/// `ReferenceCount`, `OtherCount` (Int64; -1 on the meshes). Guarantee and errors as above.
void write_differing_pieces(const std::filesystem::path& file,
                            std::span<const Difference> differences, const AuditedRoad& reference,
                            const AuditedRoad& other);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "triplex/extract/nodes.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {

/// Writes nodes as the vertices of a .vtp file (inline base64), also if there are none. Point
/// arrays: `eigenvalue`, `EigenvalueEnclosure` (lo, hi), `EnclosureLow`, `EnclosureHigh` (x, y, z;
/// all Float64), `SourceCellId` (Int64), `Feature` (UInt8), `Status` (UInt8, the number of the
/// `NodeStatus`), `Proven` (UInt8, 0 if shared).
/// Guarantee: all or nothing; equal nodes give equal bytes. \throw IoError.
void write_nodes(const std::filesystem::path& file, std::span<const Node> nodes);

}  // namespace triplex

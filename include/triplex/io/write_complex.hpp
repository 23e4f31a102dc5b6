// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "triplex/topology/feature_complex.hpp"
#include "triplex/verify/crossing_curves.hpp"

namespace triplex {

/// Writes the complex as a .vtu file: its triangles, then the edges on curves as lines, then the
/// corners as vertices. Cell arrays: `Kind` (UInt8: 0 a triangle of a page, 1 of a level set; of
/// lines 2 segments, 3 boundary, 4 branch; 5 a corner, 6 a corner that is a node), `Feature`
/// (UInt8; 255 for lines and corners), `Features` (Int64, a bit per feature there; 0 for corners),
/// `Patch`, `Curve`, `Corner` (Int64 numbers, -1 for other cells), `DomainFront`, `DomainBack`
/// (UInt8: a `PatchSide`, 255 for lines and corners), `Certified` (UInt8; 1 for corners),
/// `SourceCellId` (Int64; -1 where there is none).
/// Guarantee: all or nothing; equal complexes give equal bytes. \throw IoError.
void write_complex(const std::filesystem::path& file, const FeatureComplex& complex,
                   const FeatureTable& table);

/// Writes the curves as a .vtp file of lines with the cell arrays `FeatureA`, `FeatureB` (UInt8),
/// `SourceCellA`, `SourceCellB` (Int64). Guarantee: as above. \throw IoError.
void write_crossings(const std::filesystem::path& file, const CrossingCurves& curves);

}  // namespace triplex

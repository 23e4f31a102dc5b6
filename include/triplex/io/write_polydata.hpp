// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "triplex/extract/extraction.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex {

/// A further quantity at the points of a mesh.
struct PointValues {
  std::string name;
  int components = 1;
  std::vector<double> values;  ///< point by point
};

/// \throw std::invalid_argument if the arrays of a mesh, or `extra`, do not fit it.
void check_arrays(const FeatureMesh& mesh, std::span<const PointValues> extra);

/// Writes one feature as .vtp (inline base64), an empty one too. Segments are joined to polylines
/// and loops; a change of `certified` ends one. Point arrays: `mode`, `p`, `q` (Float64),
/// `PositionError` (Float64) and `PeriodicPoint` (Int64, the point that this one is a copy of) if
/// the mesh has them, then `extra`. Cell arrays: `SourceCellId` (Int64; -1 for a polyline through
/// several cells), `Feature` (UInt8, the number of the `Feature`), `Certified` (UInt8). Polylines
/// come before triangles in the cell arrays, as in VTK. Field array: `SegmentSourceCellId` (Int64),
/// the cells of the segments, polyline by polyline.
/// Guarantee: all or nothing, as `write_file_atomically`; equal meshes give equal bytes.
/// \pre one p, q and mode per point; one source cell and certified flag per cell. \throw IoError.
void write_polydata(const std::filesystem::path& file, const FeatureMesh& mesh, Feature feature,
                    std::span<const PointValues> extra = {});

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex {

struct MeshReadOptions {
  /// Make one point of points with equal coordinates, as is always done for STL, whose triangles
  /// have points of their own.
  bool merge_points = false;
};

/// What reading changed.
struct MeshRepairs {
  std::uint64_t merged_points = 0;  ///< points that became another one of the same coordinates
  std::uint64_t dropped_cells = 0;  ///< triangles and segments with a point twice: left out
};

/// Whether the extension is one that `read_mesh` knows.
bool is_mesh_file(const std::filesystem::path& file);

/// Reads a surface or curve mesh of any origin: .vtp, legacy .vtk with polygonal data, .ply, .obj,
/// .stl, by extension. Polygons and triangle strips are cut into triangles, polylines into
/// segments; vertex cells and free points are not cells. Coordinates are taken over exactly, as
/// doubles. Of the arrays only `SourceCellId` and `Certified` are kept, as `source_cell` and
/// `certified`, where they are there for all cells; segments come first, as in `FeatureMesh`, all
/// other members of which are empty. A mesh without cells is none of bad input.
/// Not to be called from two threads at a time, nor while other code uses VTK's output window.
/// \throw BadInput: one line that begins with the name of the file, for a file that is missing,
/// empty, damaged or of another kind; indices out of range; coordinates that are no numbers or
/// beyond 1e100.
FeatureMesh read_mesh(const std::filesystem::path& file, const MeshReadOptions& options = {},
                      MeshRepairs* repairs = nullptr);

}  // namespace triplex

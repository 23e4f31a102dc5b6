// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex::detail {

/// Cells of any number of points, one after another.
struct RawCells {
  std::vector<std::int64_t> first = {0};  ///< one more than cells
  std::vector<std::int64_t> points;
  std::vector<std::int64_t> source_cell;  ///< per cell, or empty
  std::vector<std::uint8_t> certified;    ///< per cell, or empty

  std::size_t size() const { return first.size() - 1; }
  void close() { first.push_back(static_cast<std::int64_t>(points.size())); }
};

/// A mesh as a file has it, not checked yet.
struct RawMesh {
  std::vector<Point> points;
  RawCells polylines;
  RawCells polygons;
  RawCells strips;
  std::vector<std::int64_t> segment_source_cell;  ///< per segment of the polylines, or empty
};

// Each reads one kind of file. VTK's readers of the last three round to floats, and lose edges or
// do not notice that a file ends early. \throw BadInput, without the name of the file.
RawMesh load_polydata(const std::filesystem::path& file);  // .vtp, .vtk, through VTK
RawMesh parse_ply(const std::string& content);
RawMesh parse_obj(const std::string& content);
RawMesh parse_stl(const std::string& content);  // every triangle with points of its own

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/io/write_polydata.hpp"

namespace triplex {

/// A number for every polyline.
struct LineNumbers {
  std::string name;
  std::vector<std::int64_t> values;
};

/// Polylines with numbers at their points.
struct LineSet {
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> lines;  ///< the points of each
  std::vector<PointValues> point_values;
  std::vector<LineNumbers> line_numbers;
};

/// Writes polylines as .vtp (inline base64), an empty set too. Point arrays are Float64, cell
/// arrays Int64. Guarantee: all or nothing; equal sets give equal bytes. \throw IoError.
void write_lines(const std::filesystem::path& file, const LineSet& set);

}  // namespace triplex

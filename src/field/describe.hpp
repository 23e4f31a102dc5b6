// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// "point 7 at (0, 0.5, 1)", with the shortest digits that determine the doubles.
inline std::string describe_point(const TensorField& field, std::size_t point) {
  const Point& x = field.mesh.points[point];
  return fmt::format("point {} at ({}, {}, {})", point, x[0], x[1], x[2]);
}

/// Whether the tet is part of a cell that was split.
inline bool is_part(const TensorField& field, std::size_t tet) {
  const auto& cells = field.source_cells;
  if (cells.empty()) return false;
  return (tet > 0 && cells[tet - 1] == cells[tet]) ||
         (tet + 1 < cells.size() && cells[tet + 1] == cells[tet]);
}

/// "cell 7 (points 1, 2, 3, 4)", or "cell 7 (part with points 1, 2, 3, 4)" if it was split.
inline std::string describe_cell(const TensorField& field, std::size_t tet) {
  const auto& v = field.mesh.tets[tet];
  return fmt::format("cell {} ({}points {}, {}, {}, {})", field.source_cell(TetId(tet)),
                     is_part(field, tet) ? "part with " : "", index(v[0]), index(v[1]), index(v[2]),
                     index(v[3]));
}

}  // namespace triplex::detail

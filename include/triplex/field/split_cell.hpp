// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// Cells that are cut into tets without new points. Corners are numbered as in VTK: a pyramid's
/// base 0-3 is counter-clockwise seen from the apex 4; the triangle 0-2 of a wedge is
/// counter-clockwise seen from outside, with 3-5 opposite to 0-2; the base 0-3 of a hexahedron is
/// counter-clockwise seen from the opposite side 4-7.
enum class CellShape : std::uint8_t { Pyramid, Wedge, Hexahedron };

/// 5, 6 or 8.
std::size_t corner_count(CellShape shape);

/// The tets of a cell, as corner numbers: 2, 3 or 6.
class CellTets {
 public:
  using Tet = std::array<std::uint8_t, 4>;
  const Tet* begin() const { return tets_.data(); }
  const Tet* end() const { return tets_.data() + size_; }
  std::size_t size() const { return size_; }
  void add(const Tet& tet) { tets_[size_++] = tet; }

 private:
  std::array<Tet, 6> tets_{};
  std::size_t size_ = 0;
};

/// Cuts a cell into tets. Every quadrilateral face is cut by the diagonal through its lowest corner
/// (lexicographically by coordinates), so two cells at a face agree, of whatever shape they are.
/// Guarantee: no corner number, only coordinates decide; the tets fill a convex cell with planar
/// faces and are positively oriented if its corners are in VTK's order. Where faces are not planar
/// the tets define the cell; `check_input` tells whether they are sound.
/// \pre as many corners as the shape has; coordinates are finite and differ.
/// Source: proofs/splitting.md.
CellTets split_cell(CellShape shape, std::span<const Point> corners);

}  // namespace triplex

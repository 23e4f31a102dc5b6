// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "triplex/field/bad_input.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// An axis-parallel box.
struct Box {
  Point lo{0, 0, 0};
  Point hi{1, 1, 1};
};

/// How a grid cell is cut into tets. Six: Kuhn's cut along the diagonal (0,0,0)-(1,1,1), the same
/// in every cell, so that opposite sides of the grid match. Five: one regular and four corner tets,
/// mirrored in every other cell.
enum class CellSplit : std::uint8_t { Six, Five };

struct GridOptions {
  /// Cells per axis: the mesh has 6 n^3 (or 5 n^3) tets; 13, 44 and 63 give 13k, 511k and 1.5M.
  int n = 13;
  /// The generator's own box if not given.
  std::optional<Box> box = std::nullopt;
  /// Interior vertices are moved by up to this fraction of the spacing along each axis, in [0,
  /// 0.5).
  double jitter = 0;
  /// Of the jitter and of random fields.
  std::uint64_t seed = 1;
  CellSplit split = CellSplit::Six;
};

/// A tet mesh of the box; vertex (i, j, k) has id (k (n+1) + j) (n+1) + i, i along x.
/// Guarantee: conforming and positively oriented (checked exactly); the same bits for the same
/// options. Coordinates are mirror-symmetric in the box, and dyadic where box and spacing are:
/// offsets are multiples of 2^-20 of the spacing.
/// \throw BadInput for options out of range, and if the jitter or rounding inverts a tet.
TetMesh grid_mesh(const GridOptions& options, const Box& default_box);

}  // namespace triplex

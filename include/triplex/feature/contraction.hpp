// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/grid.hpp"

namespace triplex {

/// Triangles and segments of several features over common vertices: what is one vertex has one
/// number, and what is not has two, though the points may be equal.
struct SharedComplex {
  struct Cell {
    std::array<std::uint32_t, 3> vertices{};  ///< of a segment the last two are the same
    Feature feature{};
    bool is_segment() const { return vertices[1] == vertices[2]; }
  };
  std::vector<Cell> cells;
  std::vector<Point> points;        ///< per vertex
  std::vector<std::uint8_t> fixed;  ///< per vertex: 1 for those that must stay, such as nodes

  /// Whether an edge of a cell is at most so long.
  static bool is_short(const Point& a, const Point& b, double reach);
};

/// What contraction did.
struct Contraction {
  /// Per vertex: the one it became, itself if it stayed.
  std::vector<std::uint32_t> became;
  std::uint64_t removed = 0;  ///< vertices that became others
  double moved = 0;           ///< an upper bound of how far any of them is from what it became
};

/// What edges are contracted.
struct ContractionLengths {
  double reach = 0;  ///< edges up to this length are short, and no vertex goes further
  double core = 0;   ///< short edges count only if they are connected, by short edges, to one of
                     ///< this length or less
  /// Vertices on the border of one surface go to equal points only, or where the border runs within
  /// one side of this box before and after; anywhere if there is none.
  std::optional<Box> domain = std::nullopt;
};

/// Contracts short edges, one end onto the other, as long as that changes no topology and no vertex
/// ends further than `reach` from where it was. A cell then has the vertices that its own became;
/// it vanishes if two of them are equal.
/// Guarantee: the complex without the cells that vanish is homeomorphic to the one before, by a map
/// that keeps every feature; so is, then, every feature, with its boundary, and the union of all.
/// Vertices are not moved: those that stay are where they were. The result depends on the arguments
/// alone. All cells at vertices of short edges must be given; others may be left out.
/// Source: proofs/contraction.md.
Contraction contract_short_edges(const SharedComplex& complex, const ContractionLengths& lengths);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "triplex/verify/embedding.hpp"

namespace triplex::detail {

/// A triangle (size 3) or segment (size 2) by its vertices, in the points of a soup.
struct Cell {
  std::array<std::uint32_t, 3> vertices;
  int size;
};

/// Whether the cell has less than its dimension: a repeated vertex, or collinear corners. Exact.
bool is_degenerate(const Cell& cell, std::span<const Point> points);

struct CellContact {
  ContactKind kind;
  std::uint8_t shared;
};
/// How two cells meet beyond their common vertices and edges, if they do. Exact.
/// \pre neither is degenerate; equal points have equal numbers. Source: proofs/embedding.md.
std::optional<CellContact> contact_of(const Cell& a, const Cell& b, std::span<const Point> points);

}  // namespace triplex::detail

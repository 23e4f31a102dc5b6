// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/feature/contraction.hpp"

namespace triplex {

/// What surrounds a vertex: a graph of its neighbours, with an edge for every triangle.
struct VertexLink {
  enum class Shape : std::uint8_t {
    Circle,  ///< one circle: the inside of one surface
    Book,    ///< arcs between two neighbours, none or more: half discs along a curve
    Other,
  };
  Shape shape = Shape::Other;
  std::array<std::uint32_t, 2> ends{};      ///< of the arcs of a book
  std::size_t arcs = 0;                     ///< of a book; 1 at the border of one surface
  std::vector<std::uint32_t> neighbours{};  ///< ascending
};

/// The link of vertex v. `star`: the cells at v, each once, with their present vertices.
/// Circle and Book are said of links without a double edge only; neighbours at which the feature or
/// the orientation changes, or where not exactly two triangles or a segment end, are ends.
/// Source: proofs/contraction.md.
VertexLink link_of(std::uint32_t v, std::span<const SharedComplex::Cell> star);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// The domain of the field cut by all pages into cells, each in one of the six domains of tensors.
/// Tets that no page crosses stay whole; the others are cut into polyhedra. Cells share points by
/// index, and where they touch, they have one polygon in common, with opposite orientations.
struct DomainMesh {
  std::vector<Point> points;  ///< of the refined mesh, then crossings, then points of the curve
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< positively oriented
  /// Polygons, each as the number of its corners and these, counter-clockwise seen from outside;
  /// those of polyhedron n begin at stream[first[n]] and end before stream[first[n + 1]].
  std::vector<std::uint32_t> stream;
  std::vector<std::uint64_t> first = {0};
  // per cell: the tets, then the polyhedra
  std::vector<Domain> domain;
  std::vector<std::int64_t> source_cell;  ///< cell id in the input file
  std::vector<std::uint8_t> certified;    ///< 1 where the topology of all pages is proven

  std::size_t polyhedra() const { return first.size() - 1; }
  std::size_t cells() const { return tets.size() + polyhedra(); }
  /// Calls take(corners) for every polygon of polyhedron n, with a span of indices of points.
  template <class Take>
  void for_each_polygon(std::size_t n, const Take& take) const {
    for (std::uint64_t at = first[n]; at < first[n + 1]; at += 1 + stream[at])
      take(std::span<const std::uint32_t>(&stream[at + 1], stream[at]));
  }
};

/// The volume of a cell, in doubles. Up to rounding the sum over the cells of a tet is its volume.
double volume_approx(const DomainMesh& mesh, std::size_t cell);
/// The volume of all cells in each domain, by number of the domain.
std::array<double, kDomains> domain_volumes_approx(const DomainMesh& mesh);

}  // namespace triplex

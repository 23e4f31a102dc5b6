// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "feature_mesh.hpp"
#include "triplex/feature/contraction.hpp"

namespace triplex {
namespace {

/// Of the largest coordinate of the mesh, how far a vertex may go. A choice: some 64 roundings of
/// that coordinate; the position of a vertex has three or four. Shorter edges have no direction
/// that means anything; from about a hundred times as much on, contraction itself makes sheets meet
/// that did not (docs/embedding.md).
constexpr double kReach = 0x1p-46;

/// Of the largest coordinate, edges that make others count. A choice: a hundredth of one rounding
/// of it. Such edges are there where a coordinate is zero and points are equal or all but that;
/// where there are none, meshes as fine as rounding may still be embedded, and are left as they
/// are.
constexpr double kCore = 0x1p-60;

Box box_of(const TensorField& field) {
  Box box = {field.mesh.points.front(), field.mesh.points.front()};
  for (const Point& x : field.mesh.points)
    for (std::size_t k = 0; k < 3; ++k) {
      box.lo[k] = std::min(box.lo[k], x[k]);
      box.hi[k] = std::max(box.hi[k], x[k]);
    }
  return box;
}

double largest_coordinate(const Box& box) {
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    largest = std::max({largest, std::fabs(box.lo[k]), std::fabs(box.hi[k])});
  return largest;
}

}  // namespace

std::vector<std::uint32_t> FeatureMeshBuilder::ends_of_short_edges(const std::vector<Cells>& parts,
                                                                   double reach) const {
  std::vector<std::vector<std::uint32_t>> found(parts.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    for (const auto& cells : parts[n])
      for (const Cell& cell : cells) {
        const auto& v = cell.vertices;
        const std::array x = {position(v[0]), position(v[1]), position(v[2])};
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t a = common_number(v[i]), b = common_number(v[(i + 1) % 3]);
          if (a != b && SharedComplex::is_short(x[i], x[(i + 1) % 3], reach))
            found[n].insert(found[n].end(), {a, b});
        }
      }
  });
  std::vector<std::uint32_t> ends;
  for (const auto& part : found) ends.insert(ends.end(), part.begin(), part.end());
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

ContractionStatistics FeatureMeshBuilder::contract(std::vector<Cells>& parts) const {
  const Box box = box_of(input_);
  const double largest = largest_coordinate(box);
  const double reach = kReach * largest, core = kCore * largest;
  if (ends_of_short_edges(parts, core).empty()) return {};
  const std::vector<std::uint32_t> ends = ends_of_short_edges(parts, reach);

  // The cells at these vertices, over their own vertices in order.
  const auto is_end = [&](const PatchVertex& v) {
    return std::ranges::binary_search(ends, common_number(v));
  };
  std::vector<Cell*> cells;
  SharedComplex complex;
  for (std::size_t f = 0; f < static_cast<std::size_t>(table_.size()); ++f)
    for (Cells& part : parts)
      for (Cell& cell : part[f]) {
        if (std::ranges::none_of(cell.vertices, is_end)) continue;
        cells.push_back(&cell);
        complex.cells.push_back({{}, static_cast<Feature>(f)});
      }
  std::vector<PatchVertex> vertices;
  for (const Cell* cell : cells)
    vertices.insert(vertices.end(), cell->vertices.begin(), cell->vertices.end());
  const auto number = [&](const PatchVertex& v) { return common_number(v); };
  std::ranges::sort(vertices, {}, number);
  const auto repeated = std::ranges::unique(vertices, {}, number);
  vertices.erase(repeated.begin(), repeated.end());
  for (const PatchVertex& v : vertices) {
    complex.points.push_back(position(v));
    complex.fixed.push_back(!v.on_spine && joined_.at_node[v.number] ? 1 : 0);
  }
  const auto local = [&](const PatchVertex& v) {
    const auto at = std::ranges::lower_bound(vertices, common_number(v), {}, number);
    return static_cast<std::uint32_t>(at - vertices.begin());
  };
  for (std::size_t c = 0; c < cells.size(); ++c)
    std::ranges::transform(cells[c]->vertices, complex.cells[c].vertices.begin(), local);

  const Contraction contraction = contract_short_edges(complex, {reach, core, box});
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t i = 0; i < 3; ++i)
      cells[c]->vertices[i] = vertices[contraction.became[complex.cells[c].vertices[i]]];
  drop_collapsed(parts);
  return {contraction.removed, contraction.moved, reach};
}

void FeatureMeshBuilder::drop_collapsed(std::vector<Cells>& parts) const {
  const auto triple = index(Feature::TripleCurve);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    for (std::size_t f = 0; f < parts[n].size(); ++f)
      std::erase_if(parts[n][f], [&](const Cell& cell) {
        const std::uint32_t a = common_number(cell.vertices[0]),
                            b = common_number(cell.vertices[1]),
                            c = common_number(cell.vertices[2]);
        return a == b || (f != triple && (b == c || a == c));
      });
  });
}

}  // namespace triplex

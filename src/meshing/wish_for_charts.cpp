// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/wish_for_charts.hpp"

#include <algorithm>
#include <bit>

#include "chart.hpp"
#include "sample_arc.hpp"

namespace triplex {
namespace {

std::array<VertexId, 2> longest_edge(const CellMap& cell) {
  std::array<std::size_t, 2> longest{0, 1};
  double length = -1;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (const double other = (cell.corner(i) - cell.corner(j)).squaredNorm(); other > length) {
        longest = {i, j};
        length = other;
      }
  return {cell.vertices()[longest[0]], cell.vertices()[longest[1]]};
}

/// The surface may pass through the cell, and there it is in no known way a graph.
bool lacks_chart(const CellMap& cell, const SurfaceFunction& f) {
  const auto corners = corner_tensors(cell);
  unsigned above = 0, below = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double value = f.value(corners[i]);
    if (value >= 0) above |= 1u << i;
    if (value <= 0) below |= 1u << i;
  }
  if (above == 0 || below == 0) return false;
  const auto passes = [&](unsigned vertices) {
    return (above & vertices) != 0 && (below & vertices) != 0;
  };
  if (!best_chart(cell, f)) return true;
  for (std::size_t lacking = 0; lacking < 4; ++lacking)
    if (passes(0b1111u & ~(1u << lacking)) && !has_face_chart(cell, f, lacking)) return true;
  return false;
}

}  // namespace

LeafWish wish_for_charts(const TensorField& input, const FeatureTable& table, Tolerance tolerance) {
  return [&input, &table, tolerance](const RefinableField& field,
                                     const Leaf& leaf) -> std::optional<std::array<VertexId, 2>> {
    if (leaf.graph == 0) return std::nullopt;
    const double allowed = tolerance.at(longest_edge_approx(input, leaf.input));
    std::array<std::optional<CellMap>, 2> cells;  // without and with the trace
    for (FeatureSet rest = leaf.graph; rest != 0; rest &= rest - 1) {
      const auto feature = static_cast<Feature>(std::countr_zero(rest));
      if (feature == Feature::TripleCurve) continue;
      const SurfaceFunction f(table, feature, field.scale_exponent());
      std::optional<CellMap>& cell = cells[f.takes_trace() ? 1 : 0];
      if (!cell) cell.emplace(field, leaf.vertices, f.takes_trace());
      if (cell->size() <= allowed) return std::nullopt;
      if (lacks_chart(*cell, f)) return longest_edge(*cell);
    }
    if (contains(leaf.graph, Feature::TripleCurve) || leaf.has_spine_proof)
      if (cells[0] && !has_spine_slices(*cells[0])) return longest_edge(*cells[0]);
    return std::nullopt;
  };
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_error.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace triplex {

double error_up(const PatchOutline& outline, const Chart& chart,
                const std::array<Weights, 3>& corners, double allowed) {
  const CellMap& cell = outline.cell;
  const double value = outline.f.largest_value<3>(
      {cell.tensor(corners[0]), cell.tensor(corners[1]), cell.tensor(corners[2])}, cell.bounds());
  const double coarse = value / chart.rise * (1 + 0x1p-20);
  if (!std::isfinite(coarse)) return std::numeric_limits<double>::infinity();
  if (coarse <= allowed || !(coarse < cell.size())) return coarse;
  // The vector of `up_weights` may be shorter than one, by less than this.
  const double reach = coarse * (1 + 4 / kLeastLength);
  std::array<Tensor<double>, 6> prism;
  for (std::size_t k = 0; k < 3; ++k) {
    const Weights above = corners[k] + reach * chart.up_weights;
    const Weights below = corners[k] + -reach * chart.up_weights;
    if (CellMap::total(above) > CellMap::kMostWeight ||
        CellMap::total(below) > CellMap::kMostWeight)
      return coarse;
    prism[k] = cell.tensor(above);
    prism[k + 3] = cell.tensor(below);
  }
  const Bounds growth = growth_along(cell, outline.f, prism, chart.up_weights);
  return growth.low > chart.rise ? value / growth.low * (1 + 0x1p-17) : coarse;
}

double error_at_boundary(const PatchOutline& outline, const Chart& chart) {
  return (outline.value / chart.rise + outline.deviation) * (1 + 0x1p-20);
}

double error_of_tangled(const PatchOutline& outline,
                        std::span<const std::array<std::uint32_t, 3>> triangles) {
  const auto n = static_cast<std::uint32_t>(outline.boundary.size());
  const Chart& chart = *outline.chart;
  std::vector<Vector> x;
  double twice_area = 0;
  for (const Weights& w : outline.boundary) x.push_back(outline.cell.position(w) - chart.origin);
  const auto twice = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return chart.up.dot((x[b] - x[a]).cross(x[c] - x[a]));
  };
  for (const auto& [a, b, c] : triangles) twice_area += twice(a, b, c);
  double up = 0, width = 0;
  // Twice an area is right to some roundings of the squared size of the cell, and to what its
  // corners and the direction may be off by times at most four sides.
  const double size = outline.cell.size();
  const double doubtful =
      0x1p-40 * size * size + 8 * (outline.cell.position_error() + chart.drift) * size;
  for (const auto& t : triangles) {
    up = std::max(
        up, error_up(outline, chart,
                     {outline.boundary[t[0]], outline.boundary[t[1]], outline.boundary[t[2]]}, 0));
    const double turned = twice(t[0], t[1], t[2]) * (twice_area < 0 ? -1 : 1);
    if (turned > doubtful) continue;
    double narrow = std::max(
        {(x[t[0]] - x[t[1]]).norm(), (x[t[1]] - x[t[2]]).norm(), (x[t[0]] - x[t[2]]).norm()});
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      if ((a + 1) % n != b && (b + 1) % n != a) continue;
      const Vector side = x[b] - x[a];
      const double along = std::clamp(side.dot(x[c] - x[a]) / side.squaredNorm(), 0.0, 1.0);
      narrow = std::min(narrow, (x[c] - x[a] - along * side).norm());
    }
    width = std::max(width, narrow);
  }
  return (up + error_at_boundary(outline, chart) + (width > 0 ? width + up : 0)) * (1 + 0x1p-20);
}

}  // namespace triplex

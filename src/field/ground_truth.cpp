// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/ground_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "ground_truth_families.hpp"
#include "triplex/field/bad_input.hpp"

namespace triplex {
namespace detail {

std::string fraction_text(double value) {
  std::int64_t denominator = 1;
  for (; value != std::trunc(value); value *= 2) denominator *= 2;
  const auto numerator = static_cast<std::int64_t>(value);
  return denominator == 1 ? fmt::format("{}", numerator)
                          : fmt::format("{}/{}", numerator, denominator);
}

std::vector<SurfaceTruth> all_surfaces(std::vector<SurfaceTruth> present) {
  for (const char* name : {"degenerate-linear", "degenerate-planar", "neutral-real",
                           "neutral-complex", "balanced-linear", "balanced-planar"}) {
    if (std::ranges::find(present, name, &SurfaceTruth::feature) == present.end())
      present.push_back({name});
  }
  return present;
}

}  // namespace detail

const std::vector<GroundTruth>& ground_truth_suite() {
  static const std::vector<GroundTruth> suite = [] {
    std::vector<GroundTruth> all;
    detail::add_lorenz(all);
    detail::add_cones(all);
    detail::add_nodes(all);
    detail::add_closed(all);
    detail::add_sheets(all);
    detail::add_tubes(all);
    return all;
  }();
  return suite;
}

Box ground_truth_box(const GroundTruth& truth, int n) {
  Box box;
  for (std::size_t k = 0; k < 3; ++k) {
    const double cell = 2 * truth.half[k] / n;
    box.lo[k] = truth.centre[k] - truth.half[k] - truth.fraction[k] * cell;
    box.hi[k] = truth.centre[k] + truth.half[k] - truth.fraction[k] * cell;
  }
  return box;
}

TensorField sample_ground_truth(const GroundTruth& truth, int n) {
  if (n < kLeastTruthCells || n > kMostTruthCells || !std::has_single_bit(static_cast<unsigned>(n)))
    throw BadInput(fmt::format(
        "{} cells along each axis: fields with known answers need a power of two from {} to {}", n,
        kLeastTruthCells, kMostTruthCells));
  TensorField field;
  field.array_name = "tensor";
  GridOptions grid;
  grid.n = n;
  grid.box = ground_truth_box(truth, n);
  field.mesh = grid_mesh(grid, *grid.box);
  const auto& c = truth.tensors;
  field.tensors.reserve(field.mesh.points.size());
  for (const Point& x : field.mesh.points) {
    Tensor<double>& t = field.tensors.emplace_back();
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = c[0][i] + x[0] * c[1][i] + x[1] * c[2][i] + x[2] * c[3][i];
  }
  return field;
}

}  // namespace triplex

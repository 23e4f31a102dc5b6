// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_warnings.hpp"

#include <fmt/core.h>

#include <string_view>

namespace triplex::cli {
namespace {

using Warnings = std::vector<std::string>;

void add_rounding(Warnings& warnings, const FieldStatistics& s) {
  if (s.trace_is_rounding()) {
    warnings.emplace_back(
        "the trace is at the level of rounding; what depends on its sign has no meaning");
  }
  if (s.asymmetry_is_rounding()) {
    warnings.emplace_back(
        "the tensors are symmetric up to rounding; complex domains have no meaning, and extract "
        "--symmetric takes the symmetric parts");
  }
}

// Invariants that vanish everywhere, the strongest statement only.
void add_vanishing(Warnings& warnings, const FieldStatistics& s) {
  const VertexStatistics& v = s.at_vertices;
  if (v.zero_tensors == s.vertices) {
    warnings.emplace_back("every tensor is zero");
  } else if (v.multiples_of_identity == s.vertices) {
    warnings.emplace_back("every tensor is a multiple of the identity: the deviator is zero");
  } else if (v.on_spine == s.vertices) {
    warnings.emplace_back("every tensor is triple degenerate");
  } else {
    if (v.zero_p == s.vertices) warnings.emplace_back("every tensor is balanced: p = 0");
    if (v.zero_q == s.vertices) warnings.emplace_back("every tensor is neutral: q = 0");
    if (v.zero_discriminant == s.vertices) {
      warnings.emplace_back("every tensor is degenerate: D = 0");
    }
  }
}

void add_shape(Warnings& warnings, const FieldStatistics& s) {
  const VertexStatistics& v = s.at_vertices;
  if (v.zero_tensors == s.vertices) return;
  if (v.symmetric == s.vertices) {
    warnings.emplace_back(
        "every tensor is symmetric: there is no complex domain, and the degenerate surfaces "
        "shrink to curves");
  }
  if (v.antisymmetric == s.vertices) warnings.emplace_back("every tensor is antisymmetric");
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (v.without_axis[axis] != s.vertices) continue;
    warnings.push_back(fmt::format(
        "the field is planar: row and column {} of every tensor are zero", kAxes[axis]));
  }
}

void add_cells(Warnings& warnings, const FieldStatistics& s) {
  const CellStatistics& c = s.in_cells;
  if (s.tets > 0 && c.constant_tets == s.tets) {
    warnings.emplace_back("the field is constant in every tet");
  } else if (c.vanishing_tets > 0) {
    warnings.push_back(
        fmt::format("all tensors of {} tets are zero: features fill them", c.vanishing_tets));
  }
}

}  // namespace

Warnings field_warnings(const FieldStatistics& statistics) {
  Warnings warnings;
  if (statistics.vertices == 0) return warnings;
  add_rounding(warnings, statistics);
  add_vanishing(warnings, statistics);
  add_shape(warnings, statistics);
  add_cells(warnings, statistics);
  return warnings;
}

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/certify/cell.hpp"

namespace triplex {

/// By how much the graph certificate misses on an open tet, or on its faces or edges if that is
/// where `obstacle` lies: with g_i the control vectors of a sheet's gradient, the largest over unit
/// vectors d of min_i d . g_i / max_i |g_i|, as found by a search; then the least of these over the
/// simplices and the sheets of `features`. In [-1, 0]: near 0 it nearly holds, or fails by rounding
/// alone; far below, the gradient turns by more than a right angle. Nothing for obstacles of other
/// kinds. A measure in doubles that decides nothing. \pre vertices ascending.
std::optional<double> graph_margin_approx(const RefinableField& field,
                                          const std::array<VertexId, 4>& vertices,
                                          Obstacle obstacle, FeatureSet features,
                                          const FeatureTable& table);

}  // namespace triplex

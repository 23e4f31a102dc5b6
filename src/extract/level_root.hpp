// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "edge_root.hpp"
#include "triplex/feature/level_set.hpp"

namespace triplex {

/// Where a level set crosses an edge whose ends lie on different sides, the first one inside if
/// `first_inside`. Approximation and bracket as in `find_crossing`; where the filter leaves the
/// bracket wider than kWidestBracket, exact bisection narrows it.
/// Guarantee: the one crossing lies within `error` of t.
EdgeRoot find_level_crossing(const RefinableField& field, const std::array<VertexId, 2>& ends,
                             const LevelSet& level, bool first_inside);

}  // namespace triplex

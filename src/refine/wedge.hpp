// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// Where tensors are block triangular in a plane, the degenerate surface meets the plane in a curve
/// only, and opens to both sides of the curve with the distance from the plane. A leaf with an edge
/// in the plane that departs from the curve further than the surface opens over the leaf: that
/// edge. A heuristic that nothing certified depends on: edges in the plane are crossed by nothing,
/// so nothing else asks for them, while the leaf's other edges become shorter without end.
std::optional<std::array<VertexId, 2>> edge_across_wedge(const RefinableField& field,
                                                         const Leaf& leaf);

}  // namespace triplex

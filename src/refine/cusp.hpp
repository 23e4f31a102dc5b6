// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// At the triple degenerate curve the degenerate surface is a cusp, 2 P^3 + 3 Q^2 = 0: where Q is
/// small next to |P|^(3/2), it is all but the surface P = 0 there, seen from too far. Halving must
/// not make Q smaller still, or leaves become flatter without end. The edge of such a leaf along
/// which P varies, and Q least for it; nothing in other leaves. A choice of edges only.
std::optional<std::array<VertexId, 2>> edge_across_cusp(const RefinableField& field,
                                                        const Leaf& leaf);

}  // namespace triplex

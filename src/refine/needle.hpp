// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// The longest edge of a leaf, if that is much longer than a leaf of its volume need be; the length
/// of an edge is the distance of the tensors at its ends. A heuristic that nothing certified
/// depends on: edges chosen for a face or an edge that fails may leave the longest edge of the tet
/// whole for ever, while its parts become flat along it. Not for leaves with enclosed vertices:
/// tets around a node are cones over their link, and may be as thin as they like.
std::optional<std::array<VertexId, 2>> edge_of_needle(const RefinableField& field,
                                                      const Leaf& leaf);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <array>
#include <vector>

#include "cell_patches.hpp"

namespace triplex {

/// The vertex from which a patch is fanned into triangles. A quadrilateral between two vertices of
/// the tet and the other two has its corners on four edges, and is cut between those two opposite
/// edges whose middles are nearer to each other: the same for all sheets that pass there, so that
/// sheets whose corners are in order on the edges do not cross. It does not depend on where the
/// loop starts or which way it runs. Source: proofs/cell.md.
std::size_t fan_apex(const PatchLoop& loop, const Leaf& leaf, const RefinableField& field);

/// Calls take(a, b, c) for every triangle of a patch, with vertices in the sense of its loop.
/// Whether the loop meets an edge twice. Then corners may lie in one face without being neighbours.
bool meets_edge_twice(const PatchLoop& loop);
/// A triangulation with as few diagonals in faces of the tet as there can be: the next tet might
/// have the same diagonal.
std::vector<std::array<std::size_t, 3>> triangulate(const PatchLoop& loop);

template <class Take>
void for_each_triangle(const PatchLoop& loop, const Leaf& leaf, const RefinableField& field,
                       const Take& take) {
  if (meets_edge_twice(loop)) {
    for (const auto& [a, b, c] : triangulate(loop)) take(loop[a], loop[b], loop[c]);
    return;
  }
  const std::size_t n = loop.size, apex = fan_apex(loop, leaf, field);
  for (std::size_t i = 1; i + 1 < n; ++i)
    take(loop[apex], loop[(apex + i) % n], loop[(apex + i + 1) % n]);
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "border_regions.hpp"

namespace triplex::detail {

BorderRegions::BorderRegions(const std::array<EdgeCut, 6>& edges,
                             const std::array<FaceCut, 4>& faces)
    : sets_(kPieces) {
  // at each vertex all edges begin in one region
  std::array<std::uint32_t, 4> at_vertex{};
  std::array<bool, 4> known{};
  for (std::uint32_t e = 0; e < 6; ++e)
    for (int end = 0; end < 2; ++end) {
      const auto v = static_cast<std::size_t>(kTetEdges[e][static_cast<std::size_t>(end)]);
      const std::uint32_t piece = 3 * e + (end == 0 ? 0u : edges[e].roots);
      if (known[v])
        sets_.unite(at_vertex[v], piece);
      else
        at_vertex[v] = piece;
      known[v] = true;
    }
  // along both sides of an arc; edge 02 of a face is passed through backwards
  for (int f = 0; f < 4; ++f)
    for (int n = 0; n < faces[static_cast<std::size_t>(f)].arcs; ++n) {
      const auto& [a, b] = faces[static_cast<std::size_t>(f)].ends[static_cast<std::size_t>(n)];
      const auto piece = [&](EdgeRoot r, bool beyond) {
        const EdgeRoot root = in_tet(f, r);
        return beyond == (r.edge != 2) ? after(root) : before(root);
      };
      sets_.unite(piece(a, true), piece(b, false));
      sets_.unite(piece(a, false), piece(b, true));
    }
}

}  // namespace triplex::detail

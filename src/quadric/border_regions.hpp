// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "triplex/quadric/adjugate.hpp"
#include "triplex/quadric/tet_cut.hpp"
#include "triplex/topology/disjoint_sets.hpp"

namespace triplex::detail {

/// The regions into which a quadric's loops cut the boundary of a tet, as sets of pieces: piece k
/// of edge e is number 3 e + k, the inside of an oval in face f is 18 + f.
class BorderRegions {
 public:
  static constexpr std::uint32_t kPieces = 22;

  BorderRegions(const std::array<EdgeCut, 6>& edges, const std::array<FaceCut, 4>& faces);

  /// The pieces on the two sides of a root: before it and after it on its edge.
  static std::uint32_t before(EdgeRoot r) { return 3u * r.edge + r.root; }
  static std::uint32_t after(EdgeRoot r) { return before(r) + 1; }
  static std::uint32_t inside(int face) { return 18u + static_cast<std::uint32_t>(face); }
  static std::uint32_t around(int face) {
    return 3u * static_cast<std::uint32_t>(kEdgesOfFaces[static_cast<std::size_t>(face)][0]);
  }

  const DisjointSets& sets() const { return sets_; }

 private:
  DisjointSets sets_;
};

/// A root of a face as one of its tet.
inline EdgeRoot in_tet(int face, EdgeRoot r) {
  return {static_cast<std::uint8_t>(kEdgesOfFaces[static_cast<std::size_t>(face)][r.edge]), r.root};
}

/// A positive multiple of the centre of a conic, as a point of its tet. \pre it lies inside the
/// face.
template <class NT>
std::array<NT, 4> oval_center(const QuadraticForm<NT, 4>& f, int face) {
  const auto& vertices = kTetFaces[static_cast<std::size_t>(face)];
  const auto c = center(adjugate(restricted<3>(f, vertices)));
  std::array<NT, 4> x;
  x.fill(NT(0));
  for (std::size_t k = 0; k < 3; ++k)  // all coordinates have the sign of the first
    x[static_cast<std::size_t>(vertices[k])] = c[0] * c[k];
  return x;
}

/// A vector of the closed tet with the sign `cone`, beside the loop: a vertex, the extremum of an
/// edge, or the centre of an oval.
template <class NT>
std::array<NT, 4> place_in_cone(const QuadraticForm<NT, 4>& f, const std::array<EdgeCut, 6>& edges,
                                const QuadricLoop& loop, Sign cone) {
  if (loop.is_oval()) {
    const Sign around = edges[static_cast<std::size_t>(kEdgesOfFaces[loop.oval_face][0])].ends[0];
    if (around != cone) return oval_center(f, loop.oval_face);
    return Representative{kTetFaces[loop.oval_face][0], -1}.place(f, around);
  }
  const EdgeRoot root = loop.arcs.front().start;
  const EdgeCut& edge = edges[root.edge];
  const auto [v, w] = kTetEdges[root.edge];
  const int piece = edge.piece(root.root) == cone ? root.root : root.root + 1;
  const Representative r = piece == 0            ? Representative{v, -1}
                           : piece == edge.roots ? Representative{w, -1}
                                                 : Representative{v, w};
  return r.place(f, edge.ends[0]);
}

}  // namespace triplex::detail

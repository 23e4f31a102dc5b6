// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

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

}  // namespace triplex::detail

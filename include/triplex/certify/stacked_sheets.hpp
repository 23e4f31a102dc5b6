// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <compare>
#include <optional>
#include <vector>

#include "triplex/certify/degenerate_roots.hpp"

namespace triplex {

/// An edge of the refined mesh that a degenerate page crosses exactly twice.
struct DoubleCrossing {
  std::array<VertexId, 2> edge{};  ///< ascending
  Feature page{};
  friend auto operator<=>(const DoubleCrossing&, const DoubleCrossing&) = default;
};

/// The crossings of one page on the edges of a face, numbered 2 e + k: the k-th one, counted from
/// the lower vertex, on edge e of (0, 1), (0, 2), (1, 2).
inline constexpr std::array<std::array<int, 2>, 3> kEdgesOfFace = {{{0, 1}, {0, 2}, {1, 2}}};
/// Each crossing's partner at the other end of its arc; -1 where there is no crossing.
using FacePairing = std::array<std::int8_t, 6>;

/// How the arcs of a degenerate page join its crossings on a face, up to two per edge.
/// Guarantee: the page in the face is just these arcs. Nothing where that is not proven. A function
/// of the face alone. Source: proofs/stacked_sheets.md. \pre vertices ascending; no triple
/// degenerate point on the face.
std::optional<FacePairing> pair_crossings(const Simplex<3>& face, Feature page, SignStages& stages);

/// What other certificates say of a page on a tet and its parts: nothing or one disc, arc,
/// crossing.
struct OneSheet {
  bool cell = false;
  std::array<bool, 4> faces{};    ///< face f lacks vertex f
  std::array<bool, 6> edges{};    ///< (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)
  std::array<bool, 6> crossed{};  ///< of these edges: there is a crossing
};

/// Certifies a degenerate page on a tet that it may cross in several discs, with up to two
/// crossings per edge.
/// Guarantee: the page is one disc for each closed curve that its arcs form on the tet's border;
/// the edges that it crosses twice are returned. Nothing where that is not proven. Source:
/// proofs/stacked_sheets.md. \pre vertices ascending; no triple degenerate point in the tet.
std::optional<std::vector<DoubleCrossing>> certify_stacked_sheets(const Simplex<4>& cell,
                                                                  Feature page,
                                                                  const OneSheet& known,
                                                                  SignStages& stages);

}  // namespace triplex

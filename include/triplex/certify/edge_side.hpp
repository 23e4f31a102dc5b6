// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "triplex/certify/vertex.hpp"

namespace triplex {

/// The sign of q where p vanishes on an edge whose ends have p of opposite signs: on which side of
/// the spine the edge passes. p is quadratic on the edge, so the root is one and simple. Guarantee:
/// exact, for the perturbed field. Nothing if the perturbation leaves the sign open. \pre p has
/// opposite signs at the ends. Source: proofs/edge_side.md.
std::optional<Sign> q_at_root_of_p(const RefinableField& field, VertexId a, VertexId b,
                                   SignStages& stages);

/// How the image of an edge winds around the origin of the (p, q) plane: the number of pages
/// crossed from the sector at one end to that at the other, positive counter-clockwise. Pages are
/// crossed in cyclic order, each at most once. Guarantee: the homotopy class of the image of the
/// edge in the punctured plane if p and q vanish at most once each on the edge or (p, q) stays in a
/// half plane. Nothing where `q_at_root_of_p` is open.
std::optional<int> rotation_along(const RefinableField& field, VertexId a, VertexId b,
                                  Sector sector_a, Sector sector_b, const FeatureTable& table,
                                  SignStages& stages);

/// Page number i, from 0, that an edge leaving a sector with that rotation crosses.
inline Feature page_crossed(const FeatureTable& table, Sector from, int rotation, int i) {
  const int k = table.page_count();
  const int position = rotation > 0 ? index(from) + 1 + i : index(from) - i;
  return table.page((position + k) % k);
}
inline FeatureSet pages_crossed(const FeatureTable& table, Sector from, int rotation) {
  FeatureSet pages = 0;
  for (int i = 0; i < (rotation < 0 ? -rotation : rotation); ++i)
    pages |= bit(page_crossed(table, from, rotation, i));
  return pages;
}

}  // namespace triplex

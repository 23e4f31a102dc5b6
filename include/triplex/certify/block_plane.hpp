// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Certificates on and near planes where the tensor is exactly block triangular along a coordinate
/// axis, a 2 x 2 block M in the plane and a number e: mirror planes, where nothing couples them,
/// and free-slip walls, where one of the two couplings vanishes. There
///     D = disc(M) det(M - e I)^2:
/// the degenerate surface crosses the plane where disc(M) changes sign and only touches it where
/// det(M - e I) = 0. Touching counts as no crossing: the points of such a curve belong to the real
/// side. Proofs: proofs/block_plane.md.

/// On an edge or a face in such a plane: disc(M) vanishes at most once on every segment between two
/// opposite parts, so a degenerate page crosses the edge at most once, the face in one arc at most.
/// No node is in it, or nothing is beyond it: at a node on the boundary the page only touches it.
/// N = 2, 3 vertices. \pre simplex.block_axis() >= 0.
template <int N>
bool certifies_block(const Simplex<N>& simplex, SignStages& stages);

/// On a simplex of which some, not all, vertices lie in such a plane: D > 0 off the plane, as the
/// product of the two entries that couple the pair of eigenvalues is positive there. Then neither
/// degenerate page crosses the simplex. N = 2, 3, 4 vertices.
template <int N>
bool certifies_real_off_block(const Simplex<N>& simplex, SignStages& stages);

/// On a simplex with a face in such a plane, on which disc(M) has one sign: D vanishes at most once
/// on every segment from the face to the opposite one, but for what only touches in the plane. So
/// the degenerate page is the graph over the face that the signs at the vertices tell of, also
/// where it touches the plane along a curve; see certify/pencil.hpp. N = 3, 4 vertices.
template <int N>
bool certifies_pencil_from_block(const Simplex<N>& simplex, SignStages& stages);

}  // namespace triplex

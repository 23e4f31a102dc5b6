// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/certify/critical_zero.hpp"

namespace triplex {

/// On an edge or a face where the tensors are block triangular along an axis: none of the points
/// where the number e of the block form is an eigenvalue of the block M, at which D only touches
/// zero, is an isolated node. (On a mirror plane they all are nodes, and form curves: these are
/// passed over.) N = 2, 3 vertices. Source: proofs/block_plane.md.
template <int N>
bool excludes_block_node(const Simplex<N>& simplex, int axis, SignStages& stages);

/// The nodes inside an edge or a face that lie where nothing couples an axis to the plane beside
/// it, on the edge or along a line of the face, and that are rational: chi = det(M - e I) is linear
/// along it. Guarantee: exact; others may exist. N = 2, 3 vertices.
template <int N>
std::vector<ExactWeights<N>> rational_block_nodes(const Simplex<N>& simplex);

}  // namespace triplex

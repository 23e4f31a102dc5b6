// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Certificates in the star of a node that has become a vertex of the mesh. There D vanishes to
/// second order: along rays from the node it is r^2 times a polynomial whose Bernstein coefficients
/// are positive multiples of the layers L_2, ..., L_6 of D on the opposite face, and L_0 = L_1 = 0
/// by what a node is. Proofs: proofs/star.md.

/// All coefficients of the layers L_2, ..., L_6 have one strict sign: on the simplex D vanishes
/// nowhere but at its vertex that is a node. N = 2, 3, 4 vertices. \pre it has such a vertex.
template <int N>
bool certifies_only_node(const Simplex<N>& simplex, SignStages& stages);

/// Whether a tet with a node inside may be replaced by the four tets that join the node to its
/// faces: p < 0, q has one sign, and the nappes are graphs on all of it. What the four lack then
/// can be mended by halving edges; each is certified anew. \pre the node lies inside the tet.
bool is_ready_for_star(const Simplex<4>& cell, SignStages& stages);

/// Whether the edges and faces between the node and the tet's edges would be certified at once. A
/// matter of cost: halving them makes new ones, and around narrow cones ever more.
bool has_certified_spokes(const Simplex<4>& cell, VertexId node, SignStages& stages);

}  // namespace triplex

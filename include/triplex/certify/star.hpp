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

/// A tet may be replaced by the four tets that join a node inside it to its faces: then these,
/// their faces and edges at the node will be certified. What the tet's own faces lack can be mended
/// by bisecting its edges. \pre the node, a vertex known by an enclosure, lies inside the tet.
bool certifies_star(const Simplex<4>& cell, VertexId node, SignStages& stages);

}  // namespace triplex

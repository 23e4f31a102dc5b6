// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Pencil certificate: D of the mapped forms vanishes at most once on every segment between two
/// opposite faces of the simplex (a vertex and the rest of it, or two edges of a tet). Along such a
/// segment D is a Bernstein form whose coefficients, the layers, are forms on the pair of faces; by
/// Descartes' rule one change of sign in the sequence of layers leaves at most one root. Where the
/// spine is excluded the pages with that mode and sign of p are then fixed by the signs at the
/// vertices, as with the graph certificate, which this replaces where the surface is a narrow tube
/// around an edge or a vertex. N = 3, 4 vertices. Proof: proofs/pencil.md.
template <int N>
bool certifies_pencil(const Simplex<N>& simplex, const Sheet& sheet, SignStages& stages);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Graph certificate: some direction d in the affine hull of the simplex has d . grad f > 0 on all
/// of it, f the function of the sheet. Then f vanishes at most once on each line along d: no closed
/// components, at most one root on an edge, at most one arc on a triangle with certified edges, at
/// most one disc in a tet with certified faces. N = 2, 3, 4 vertices. Proof: proofs/graph.md.
///
/// For a curved sheet, seen through its map, f is G = q - s 2 v^3, v = sqrt(max(0,-p)/3), a C^1
/// function with gradient grad q + s v grad p: affine in v, so two quadratic positivity tests at
/// bounds of v suffice.
template <int N>
bool certifies_graph(const Simplex<N>& simplex, const Sheet& sheet, SignStages& stages);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Graph certificate beside zeros: p or q vanishes throughout an edge or a face of the simplex, as
/// q does on planes of antisymmetry. For some direction d in that edge or face and some number mu,
/// d . grad f + mu f > 0 on the simplex (f = p, q, or G of a curved sheet), by its Bernstein
/// coefficients under the perturbation; so f exp(mu s) grows along d, and f vanishes at most once
/// on each line, as `certifies_graph` claims. Proof: proofs/graph.md.
template <int N>
bool certifies_graph_beside_zeros(const Simplex<N>& simplex, const Sheet& sheet,
                                  SignStages& stages);

}  // namespace triplex

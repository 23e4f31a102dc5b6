// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Descartes' rule on an edge: the Bernstein coefficients of the sheet's polynomial (p, q, or D of
/// the mapped forms for a curved sheet) change sign at most once, so it has at most one root on the
/// edge. Weaker to ask for than the graph certificate: the polynomial need not be monotone. For a
/// curved sheet it bounds the crossings of the *page* (D does not see the neutral part of the
/// sheet), so it serves only where the spine is excluded. Proof: proofs/descartes.md.
bool certifies_one_root(const Simplex<2>& edge, const Sheet& sheet, SignStages& stages);

}  // namespace triplex

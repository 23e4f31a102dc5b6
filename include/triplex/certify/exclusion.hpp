// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Exclusion certificates: proofs that a feature has no point on a closed simplex. Each passes on
/// to every sub-simplex. N = 2, 3, 4 vertices. Statement and proofs: proofs/exclusion.md.

/// The common sign of all Bernstein coefficients of p (of q): then p (q) has that sign on the
/// simplex. Zero: not proven.
template <int N>
Sign uniform_sign_of_p(const Simplex<N>& simplex, SignStages& stages);
template <int N>
Sign uniform_sign_of_q(const Simplex<N>& simplex, SignStages& stages);

/// No point of the page that a curved sheet carries, seen through its map: q = s 2 w^3, p <= 0 (s
/// the page's sign of q): all control points (p_ijk, q_ijk) lie beyond the convex curve, or all on
/// the inner side of one of its tangents. \pre the sheet is curved.
template <int N>
bool excludes_page(const Simplex<N>& simplex, const Sheet& sheet, SignStages& stages);

/// The common sign of all Bernstein coefficients of the discriminant of the mapped forms (84 on a
/// tet), zero if not proven: then neither page with that mode and sign of p, nor the spine, meets
/// the simplex. Slower than the page's own test, and decides where the page is thin.
template <int N>
Sign uniform_sign_of_discriminant(const Simplex<N>& simplex, const ModeMap& map,
                                  SignStages& stages);

/// No point with p = q = 0: all control points (p_ijk, q_ijk) lie in an open half plane.
template <int N>
bool excludes_spine(const Simplex<N>& simplex, SignStages& stages);

}  // namespace triplex

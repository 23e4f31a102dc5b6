// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"

namespace triplex {

/// The map (p, q) is injective on a triangle: with a constant 2x2 matrix C, the symmetric part of
/// C J is positive definite at every Bernstein coefficient of the Jacobian J. So at most one point
/// of the triple degenerate curve lies on the triangle, and the winding number of (p, q) along the
/// boundary says whether there is one. Proof: proofs/spine.md.
bool certifies_injective(const Simplex<3>& face, SignStages& stages);

/// The same for given forms, up to positive factors; nothing is perturbed.
/// \pre inside an `IntervalRounding`.
bool certifies_injective(const Forms<Interval, 3>& forms);

/// The triple degenerate curve runs monotonically through a tet: d . (grad p x grad q) > 0 for some
/// d. So it has no closed loops there, and with at most two points on the boundary it is at most
/// one arc. Proof: proofs/spine.md.
bool certifies_monotone_spine(const Simplex<4>& cell, SignStages& stages);

}  // namespace triplex

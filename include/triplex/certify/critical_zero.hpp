// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Points inside a face or an edge where p or q vanishes together with its derivatives along it:
/// the balanced or the neutral sheet touches the face there, or two of its branches cross in it, as
/// they do on planes of symmetry. However small the parts of the face, that which holds the point
/// has up to four ends of arcs: the point has to become a vertex.

/// A point as weights of the vertices, all positive, up to a common factor.
template <int N>
using ExactWeights = std::array<Exact, N>;

/// The critical zeros of q at which two entries of the deviator vanish (on an edge perhaps one),
/// and that of p, where it is in the kernel of the form; on an edge also the middle between the
/// zeros of two entries that agree up to rounding. Guarantee: but for such middles all are exact;
/// others may exist. N = 2, 3. Source: proofs/critical_zero.md.
template <int N>
std::vector<ExactWeights<N>> critical_zeros(const Simplex<N>& simplex);

/// On a face: the Hessian of p (of q) along it is indefinite everywhere. Then the balanced
/// (neutral) sheet, if it crosses each edge at most once, leaves nothing or one arc there.
/// \pre the sheet is not curved. Source: proofs/critical_zero.md.
bool certifies_saddle(const Simplex<3>& face, const Sheet& sheet, SignStages& stages);

}  // namespace triplex

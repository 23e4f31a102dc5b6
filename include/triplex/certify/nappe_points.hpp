// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/nappe.hpp"
#include "triplex/certify/sheet_pair.hpp"

namespace triplex {

/// On which nappe a zero of D on an edge lies: -1 where D grows along the direction of the
/// certificate, 1 where it falls; 0 if the enclosure is too wide to tell.
template <int N>
int nappe_at(const Simplex<N>& simplex, const NappeDirection<N>& direction, const EdgePoint& zero);

/// No node on the simplex, so the two nappes do not meet: at no point where D > 0 is not known all
/// entries of the block's traceless part vanish. Halves a copy of the simplex, first across the
/// direction in which the nappes are apart, so that the effort grows with the logarithm of the gap.
/// N = 3, 4 vertices. Source: proofs/stacked_sheets.md.
template <int N>
bool keeps_nappes_apart(const Simplex<N>& simplex, const NappeDirection<N>& direction,
                        SignStages& stages);

}  // namespace triplex

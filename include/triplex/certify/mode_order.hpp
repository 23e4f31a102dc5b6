// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// The mode of the mapped forms is strictly monotone along an edge wherever p < 0, q keeps its sign
/// and p changes its own at most once: so a curved sheet is crossed at most once. Unlike the graph
/// certificate it holds where the triple degenerate curve passes through an edge on which q
/// vanishes throughout, for the perturbed field. Proof: proofs/mode_order.md.
bool certifies_monotone_mode(const Simplex<2>& edge, const Sheet& sheet, SignStages& stages);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/quadric/tet_cut.hpp"

namespace triplex::detail {

/// Whether both lines of a quadric of signature (2,2) through a root on an edge enter the tet
/// there. Guarantee: exact. \pre the quadric is transverse to the tet and its faces.
bool both_rulings_enter(const QuadraticForm<Exact, 4>& form, const EdgeCut& edge, EdgeRoot root);

}  // namespace triplex::detail

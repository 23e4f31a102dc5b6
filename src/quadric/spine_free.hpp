// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spine_on_edge.hpp"

namespace triplex::detail {

/// Whether some linear function L is found with all Bernstein coefficients of q - L p of one sign:
/// then p and q have no common zero in the tet. Certified; false if none is found.
/// \pre inside an `IntervalRounding`. Source: proofs/quadric_spine.md.
bool is_free_of_spine(const Forms<Interval, 4>& forms);

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <span>
#include <vector>

#include "triplex/arithmetic/exact_range.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {

/// Encloses forms in (1 - t, t) on an interval of t in [0, 1]. Shape: each form by its integer
/// coefficients of (1 - t)^d, (1 - t)^(d-1) t, ..., t^d; one enclosure per form, all scaled by the
/// same power of two, the largest to about one, and rounded outwards to so many bits after the
/// point.
std::vector<ExactRange> enclosures(std::span<const std::vector<mpz_class>> forms,
                                   const RootInterval& interval, int bits);

/// x_i / (x_0 + x_1 + x_2), for numbers of which the sum is not zero. Nothing if that is not
/// proven.
std::vector<Range> shares(std::span<const ExactRange> x);

}  // namespace triplex

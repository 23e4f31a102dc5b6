// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Mpzf.h>

#include "triplex/arithmetic/sign.hpp"

#ifndef CGAL_HAS_MPZF
#error "Triplex needs CGAL::Mpzf (GMP with 64-bit limbs)"
#endif

namespace triplex {

/// The exact dyadic rationals: a ring that holds every finite double, with +, - and * exact at any
/// exponent. There is no division and no rounding.
using Exact = CGAL::Mpzf;

inline Sign sign(const Exact& x) { return static_cast<Sign>(static_cast<int>(x.sign())); }

}  // namespace triplex

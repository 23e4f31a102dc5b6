// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Interval_nt.h>

#include "triplex/arithmetic/sign.hpp"

namespace triplex {

/// Interval arithmetic in doubles. Operations are valid only inside the scope of an
/// `IntervalRounding`, which sets rounding upwards and restores it.
using Interval = CGAL::Interval_nt<false>;
using IntervalRounding = CGAL::Protect_FPU_rounding<true>;

}  // namespace triplex

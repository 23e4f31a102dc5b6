// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// p, q and mode at a point of a feature, from p and q of the deviator there as computed: with the
/// values put in that the feature has by definition. Mode is mu = 3 sqrt(3) |q| / (2 |p|^(3/2)).
std::array<double, 3> invariants_on(const FeatureTable& table, Feature feature, double p, double q);

/// p = q = 0 has no mode.
inline constexpr std::array<double, 3> kInvariantsOnTripleCurve = {
    0, 0, std::numeric_limits<double>::quiet_NaN()};

}  // namespace triplex

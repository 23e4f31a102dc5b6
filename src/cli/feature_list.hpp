// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "triplex/feature/feature.hpp"

namespace triplex::cli {

/// The features in the order in which people read them: the paper's.
inline constexpr std::array<Feature, kFeatures> kReadingOrder = {
    Feature::DegenerateLinear, Feature::DegeneratePlanar, Feature::NeutralReal,
    Feature::NeutralComplex,   Feature::BalancedLinear,   Feature::BalancedPlanar,
    Feature::TripleCurve};

constexpr bool contains(FeatureSet set, Feature f) { return (set & bit(f)) != 0; }

/// The set of the features of these names. \throw UsageError naming the wrong one.
FeatureSet parse_features(const std::vector<std::string>& names);

/// All names, separated by commas.
std::string all_feature_names();

/// The names of the features of a set, in reading order.
std::vector<std::string_view> names_of(FeatureSet set);

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/feature/feature.hpp"

#include <algorithm>

namespace triplex {
namespace {

constexpr std::array<FeatureRow, kFeatures> kTable = {{
    {Feature::NeutralComplex,
     "neutral-complex",
     "complex neutral surface",
     Sheet::Neutral,
     Sign::Positive,
     Sign::Zero,
     {0.84, 0.10, 0.11}},  // red
    {Feature::BalancedLinear,
     "balanced-linear",
     "linear balanced surface",
     Sheet::Balanced,
     Sign::Zero,
     Sign::Positive,
     {0.12, 0.32, 0.90}},  // blue
    {Feature::DegenerateLinear,
     "degenerate-linear",
     "linear degenerate surface",
     Sheet::DegenerateLinear,
     Sign::Negative,
     Sign::Positive,
     {0.13, 0.63, 0.22}},  // green
    {Feature::NeutralReal,
     "neutral-real",
     "real neutral surface",
     Sheet::Neutral,
     Sign::Negative,
     Sign::Zero,
     {0.96, 0.51, 0.12}},  // orange
    {Feature::DegeneratePlanar,
     "degenerate-planar",
     "planar degenerate surface",
     Sheet::DegeneratePlanar,
     Sign::Negative,
     Sign::Negative,
     {0.97, 0.85, 0.16}},  // yellow
    {Feature::BalancedPlanar,
     "balanced-planar",
     "planar balanced surface",
     Sheet::Balanced,
     Sign::Zero,
     Sign::Negative,
     {0.83, 0.16, 0.78}},  // magenta
    {Feature::TripleCurve,
     "triple-curve",
     "triple degenerate curve",
     Sheet::Neutral,
     Sign::Zero,
     Sign::Zero,
     {0.0, 0.0, 0.0}},  // black
}};

}  // namespace

const std::array<FeatureRow, kFeatures>& feature_table() { return kTable; }

std::optional<Feature> feature_named(std::string_view name) {
  const auto found = std::find_if(kTable.begin(), kTable.end(), [&](const FeatureRow& candidate) {
    return candidate.name == name;
  });
  if (found == kTable.end()) return std::nullopt;
  return found->feature;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// A place where a road without certificates gave up: what it wrote there for the feature, if
/// anything, is a guess.
struct GivenUp {
  std::int64_t source_cell = 0;  ///< cell id in the input file
  Feature feature = Feature::NeutralComplex;

  friend auto operator<=>(const GivenUp&, const GivenUp&) = default;
};

/// The features of a field as a floating-point method without certificates sees them. Nothing of
/// it is proven: `certified` is 0 on every cell of its meshes, and nothing certified uses it.
struct Approximation {
  FeatureTable table;
  FeatureSet requested = 0;
  std::vector<FeatureMesh> features;  ///< one per row of the table; empty where not asked for
  std::vector<GivenUp> given_up;      ///< sorted, each once
  double seconds = 0;                 ///< wall time, reading and writing left out

  const FeatureMesh& mesh(Feature f) const { return features[index(f)]; }
};

}  // namespace triplex

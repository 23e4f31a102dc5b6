// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh_builder.hpp"
#include "sheet_plan.hpp"

namespace triplex::baseline {

/// What all tets share.
struct Task {
  const TensorField& field;
  const std::vector<SheetPlan>& plans;
  const WeldGrid& grid;
  int scale_exponent;  ///< the tensors are multiplied by 2^-scale_exponent
  double scale;        ///< that factor
  int max_depth, samples;
  PatchTest patch_test;
  int features;  ///< rows of the table
};

/// What was found in a run of tets.
struct Findings {
  std::vector<FeatureMesh> meshes;   ///< one per row of the table, or none at all
  std::vector<GivenUp> given_up;     ///< in the order of tets
  std::vector<APatchCounts> counts;  ///< one per plan
  APatchCounts curve_counts;
};

/// The patches in the tets [first, last).
Findings extract_run(const Task& task, std::size_t first, std::size_t last);

}  // namespace triplex::baseline

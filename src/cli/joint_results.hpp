// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "progress.hpp"
#include "report.hpp"
#include "staged_directory.hpp"
#include "triplex/feature/feature_soup.hpp"
#include "triplex/topology/feature_complex.hpp"
#include "triplex/verify/crossing_curves.hpp"
#include "triplex/verify/embedding.hpp"

namespace triplex::cli {

/// What is asked of all features together, as far as the user asked for it.
struct JointResults {
  FeatureSoup soup;
  std::optional<EmbeddingResult> embedding;
  std::optional<CrossingCurves> crossings;
  std::optional<FeatureComplex> complex;
  double embedding_s = 0, complex_s = 0;
};
JointResults examine_jointly(const ExtractRequest& request, const Extraction& extraction,
                             Progress& progress);

/// Writes complex.vtu and crossings.vtp, or drops those of an earlier run.
void write_joint_files(const JointResults& joint, const FeatureTable& table,
                       StagedDirectory& directory);
/// Adds the blocks `embedding`, `crossings` and `complex`.
void add_to_report(const JointResults& joint, const FeatureTable& table,
                   nlohmann::ordered_json& report);
/// The lines for people.
std::string joint_lines(const JointResults& joint);

}  // namespace triplex::cli

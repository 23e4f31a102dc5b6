// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "effort_options.hpp"
#include "feature_list.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/verify/audit.hpp"
#include "triplex/verify/mesh_comparison.hpp"
#include "triplex/verify/road_summary.hpp"

namespace triplex::cli {

/// What the user asked for, as given.
struct AuditRequest {
  std::string field;
  std::string directory;
  ReadOptions reading;
  FeatureRequest features;
  std::string against = "a-patches";
  double tolerance = 1e-3;  ///< of distances, relative to the diagonal of the domain; 0: none
  int max_depth = 0;
  int samples = 1;
  bool layers_only = false;  ///< what counts as an A-patch
  EffortOptions effort;
  bool meshes = false;
};

/// One feature on both roads.
struct FeatureAudit {
  Feature feature{};
  RoadSummary robust, other;
  std::uint64_t robust_open = 0, other_open = 0;  ///< cells of the input
  /// Robust first: distances from each side to the other, and components matched by place. Nothing
  /// if not asked for.
  std::optional<MeshComparison> comparison;
};

/// What one road cost.
struct RoadCost {
  double seconds = 0;
  std::optional<std::uint64_t> bytes;  ///< peak of resident memory over what was there before
};

struct AuditResult {
  FeatureTable table;
  std::size_t tets = 0;
  RefinementStatistics refinement;     ///< of the certified road
  std::vector<FeatureAudit> features;  ///< in reading order
  std::vector<Feature> left_out;       ///< curves on one side and surfaces on the other
  std::vector<Difference> differences;
  RoadCost robust, other;
};

/// Whether somewhere exact arithmetic contradicts a cell that the robust road certified.
bool refutes_certificate(const AuditResult& result);

/// The contents of audit.json; docs/formats.md says what each key means.
nlohmann::ordered_json audit_json(const AuditRequest& request, const AuditResult& result);

/// The tables for people.
std::string audit_table(const AuditRequest& request, const AuditResult& result);

}  // namespace triplex::cli

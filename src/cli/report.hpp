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
#include "quadric_check.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/io/write_mesh.hpp"
#include "triplex/topology/curve_topology.hpp"
#include "triplex/topology/surface_topology.hpp"
#include "triplex/topology/triangle_quality.hpp"

namespace triplex::cli {

struct RefinedMeshes;

/// One feature in numbers. For a curve `curve` and `measure` (a length) are used, for a surface
/// `surface` and `measure` (an area).
struct FeatureSummary {
  bool is_curve = false;
  SurfaceTopology surface;
  CurveTopology curve;
  double measure = 0;
  AngleHistogram angles;         ///< of a surface
  std::uint64_t unresolved = 0;  ///< tets of the input whose list names the feature
};
using FeatureSummaries = std::vector<FeatureSummary>;  ///< per row of the table

FeatureSummaries summarize(const Extraction& extraction);

/// Seconds of wall time per step of the run; reading includes checking.
struct StepTiming {
  double read = 0, quadrics = 0, mesh = 0, topology = 0, write = 0, total = 0;
};

/// What the user asked for, as given.
struct ExtractRequest {
  std::string field;
  std::string directory;
  ReadOptions reading;
  FeatureRequest features;
  std::vector<std::string> arrays;  ///< names of further point arrays
  std::vector<MeshFormat> formats = {MeshFormat::Vtp};
  std::vector<std::string> periodic;  ///< axes
  EffortOptions effort;
  bool symmetric = false;  ///< take the symmetric parts of the tensors
  bool domains = false;
  std::string tolerance;  ///< empty: one polygon per tet
  bool stacks = false;
  bool keep_short_edges = false;
  bool check_embedding = false;
  bool complex = false;
  bool verify_quadrics = false;  ///< also take the quadric road and compare
};

/// The contents of report.json; docs/formats.md says what each key means.
nlohmann::ordered_json make_report(const ExtractRequest& request, const TensorField& field,
                                   const Extraction& extraction, const FeatureSummaries& summaries,
                                   const std::optional<RefinedMeshes>& refined,
                                   const QuadricChecks& quadrics, const StepTiming& timing);

/// The table for people.
std::string make_table(const Extraction& extraction, const FeatureSummaries& summaries);

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "feature_list.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/quadric/quadric_extraction.hpp"
#include "triplex/verify/quadric_comparison.hpp"

namespace triplex::cli {

/// One surface found again as quadrics of the input's tets, and held against the certified mesh.
struct QuadricCheck {
  std::string name;      ///< of the feature; `balanced` for linear and planar part together
  bool is_part = false;  ///< the linear or planar part of `balanced`, where its split is known
  QuadricExtraction quadrics;
  QuadricComparison comparison;
  double seconds = 0;  ///< of the second road; of a part, of its comparison
};
using QuadricChecks = std::vector<QuadricCheck>;

/// \throw UsageError if no feature asked for is a quadric, or just one part of the balanced one is.
void require_quadrics(const RequestedFeatures& requested);

/// Runs the second road for every quadric among the features of an extraction.
QuadricChecks check_quadrics(const TensorField& field, const Extraction& extraction,
                             unsigned threads);

bool all_agree(const QuadricChecks& checks);

/// The block `quadrics` of report.json, and lines for people.
nlohmann::ordered_json quadrics_json(const TensorField& field, const QuadricChecks& checks);
std::string quadrics_lines(const QuadricChecks& checks);

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "triplex/feature/feature_table.hpp"

namespace triplex::cli {

/// Features as a user names them.
struct FeatureRequest {
  std::vector<std::string> names;  ///< of standard features; empty: all; "none": none
  std::vector<std::string> modes;  ///< MU,SIGN_P,SIGN_Q
  std::vector<double> magnitudes;
  std::vector<double> isotropicities;
  bool traceless = false;
};

/// A table with a row for each feature that was named, and which rows were.
struct RequestedFeatures {
  FeatureTable table;
  FeatureSet set = kStandardSet;
};
/// \throw UsageError naming what is wrong and what there is.
RequestedFeatures resolve(const FeatureRequest& request);

/// The options --features, --mode, --magnitude, --isotropicity and --traceless. `request` must
/// outlive the parsing.
void add_feature_options(CLI::App& command, FeatureRequest& request);

/// Adds the request to the options of report.json, every name spelt out; and back.
void add_to_json(const FeatureRequest& request, nlohmann::ordered_json& options);
FeatureRequest feature_request_from(const nlohmann::ordered_json& options);

/// The rows of a set in the order in which people read them: the paper's, then those added.
std::vector<Feature> reading_order(FeatureSet set);
/// The names of a set, in reading order.
std::vector<std::string_view> names_of(const FeatureTable& table, FeatureSet set);

}  // namespace triplex::cli

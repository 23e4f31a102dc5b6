// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command.hpp"
#include "triplex/render/render.hpp"

namespace triplex::cli {

/// What `render` is told about looks, as it is on the command line.
struct LookRequest {
  std::string size = "1600x1200";
  std::vector<std::string> views = {"diagonal"};  ///< presets
  std::string view;                               ///< AZIMUTH,ELEVATION; empty: the presets
  std::vector<std::string> opacities;             ///< FRACTION or NAME=FRACTION
  std::string clip;
  std::vector<std::string> extra;  ///< FILE, FILE:COLOUR or FILE:COLOUR:OPACITY
  std::string background = "white", outline;
  RenderOptions look;  ///< what needs no reading
};

/// The options of `render` but for directory, picture and features. `request` must outlive the
/// parsing.
void add_look_options(CLI::App& command, LookRequest& request);

/// The options for the library; features, table and domain are left to the caller, except that
/// names in --opacity are looked up in `table`. \throw UsageError naming option and value.
RenderOptions resolve(const LookRequest& request, const FeatureTable& table);

}  // namespace triplex::cli

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
  std::vector<std::string> panels;  ///< NAME,NAME,...
  std::vector<std::string> extra;   ///< [PANEL@]FILE[:COLOUR[:OPACITY]]
  std::string background = "white", outline;
  RenderOptions look;  ///< what needs no reading
};

/// The options of `render` but for directory, picture and features. `request` must outlive the
/// parsing.
void add_look_options(CLI::App& command, LookRequest& request);

/// The options for the library. Names of features must be in the table of one of the subjects.
/// \throw UsageError naming option and value.
RenderOptions resolve(const LookRequest& request, const std::vector<Subject>& subjects);

}  // namespace triplex::cli

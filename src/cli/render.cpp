// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/render.hpp"

#include <fmt/core.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "feature_list.hpp"
#include "render_options.hpp"

namespace triplex::cli {
namespace {

struct RenderRequest {
  std::vector<std::string> directories;
  std::string picture;
  LookRequest look;
  FeatureRequest features;
};

// What extract reported; null when there is no such report.
nlohmann::ordered_json report_of(const std::string& directory) {
  std::ifstream file(directory + "/report.json");
  const auto report = nlohmann::ordered_json::parse(file, nullptr, /*allow_exceptions=*/false);
  return report.is_discarded() ? nlohmann::ordered_json() : report;
}

// The box of the domain; nothing when the report does not say.
std::optional<Bounds> domain_of(const nlohmann::ordered_json& report) {
  const auto pointer = nlohmann::ordered_json::json_pointer("/field/bounds");
  if (!report.contains(pointer)) return std::nullopt;
  try {
    return report.at(pointer).get<Bounds>();
  } catch (const nlohmann::ordered_json::exception&) {
    return std::nullopt;
  }
}

// What the user asks for, or else what was extracted; all standard features if that is not known.
FeatureRequest features_of(const RenderRequest& request, const nlohmann::ordered_json& report) {
  const FeatureRequest& wanted = request.features;
  const bool any = !wanted.names.empty() || !wanted.modes.empty() || !wanted.magnitudes.empty() ||
                   !wanted.isotropicities.empty() || wanted.traceless;
  const auto pointer = nlohmann::ordered_json::json_pointer("/options");
  if (any || !report.contains(pointer)) return wanted;
  try {
    return feature_request_from(report.at(pointer));
  } catch (const nlohmann::ordered_json::exception&) {
    return wanted;
  }
}

// `--features none` alone: a picture of other geometry.
bool is_nothing(const FeatureRequest& wanted) {
  return wanted.names == std::vector<std::string>{"none"} && wanted.modes.empty() &&
         wanted.magnitudes.empty() && wanted.isotropicities.empty() && !wanted.traceless;
}

Subject subject_of(const RenderRequest& request, const std::string& directory) {
  const auto report = report_of(directory);
  const FeatureRequest wanted = features_of(request, report);
  const RequestedFeatures requested =
      is_nothing(wanted) ? RequestedFeatures{.table = {}, .set = 0} : resolve(wanted);
  return {directory, requested.table, requested.set, domain_of(report)};
}

ExitCode run_render(const RenderRequest& request) {
  std::vector<Subject> subjects;
  for (const std::string& directory : request.directories)
    subjects.push_back(subject_of(request, directory));
  render_features(subjects, request.picture, resolve(request.look, subjects));
  fmt::print("{}\n", request.picture);
  return ExitCode::Certified;
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
  auto request = std::make_shared<RenderRequest>();
  CLI::App* const command = program.add_subcommand(
      "render", "Draw what extract wrote, in the colours of the literature. Needs an X display.");
  command
      ->add_option("DIR", request->directories, "Directories that extract wrote; panels for each")
      ->required();
  command->add_option("-o,--output", request->picture, "Picture to write (.png)")
      ->required()
      ->type_name("PICTURE");
  add_look_options(*command, request->look);
  add_feature_options(*command, request->features);
  command->footer(
      "Examples:\n"
      "  triplex render flow -o flow.png\n"
      "  triplex render flow -o flow.png --sheet --size 2400x700 --columns 4 --opacity 0.8\n"
      "  triplex render flow -o flow.png --view 30,20 --clip 0,1,0,1,0,0.5 --with lines.vtp:gold\n"
      "  xvfb-run -a -s \"-screen 0 1280x1024x24\" triplex render flow -o flow.png\n"
      "The last one is for machines without a screen.");
  command->callback([request, &action] { action = [request] { return run_render(*request); }; });
}

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/render.hpp"

#include <fmt/core.h>

#include <charconv>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "feature_list.hpp"

namespace triplex::cli {
namespace {

struct RenderRequest {
  std::string directory;
  std::string picture;
  std::string size = "1600x1200";
  std::string camera = "diagonal";
  FeatureRequest features;
};

// WxH, both from 16 to 16384.
void parse_size(const std::string& text, RenderOptions& options) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, options.width);
  const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = cross ? std::from_chars(width.ptr + 1, end, options.height) : width;
  const auto in_range = [](int pixels) { return pixels >= 16 && pixels <= 16384; };
  if (!cross || height.ec != std::errc() || height.ptr != end || !in_range(options.width) ||
      !in_range(options.height)) {
    throw UsageError("--size: '" + text + "' is not WIDTHxHEIGHT in pixels, 16 to 16384 each");
  }
}

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

ExitCode run_render(const RenderRequest& request) {
  RenderOptions options;
  parse_size(request.size, options);
  const auto report = report_of(request.directory);
  const RequestedFeatures requested = resolve(features_of(request, report));
  options.table = requested.table;
  options.features = requested.set;
  options.camera = camera_named(request.camera).value_or(CameraPreset::Diagonal);
  options.outline = domain_of(report);
  render_features(request.directory, request.picture, options);
  fmt::print("{}\n", request.picture);
  return ExitCode::Certified;
}

}  // namespace

void add_render(CLI::App& program, Action& action) {
  auto request = std::make_shared<RenderRequest>();
  CLI::App* const command = program.add_subcommand(
      "render", "Draw what extract wrote, in the colours of the literature. Needs an X display.");
  command->add_option("DIR", request->directory, "Directory that extract wrote")->required();
  command->add_option("-o,--output", request->picture, "Picture to write (.png)")
      ->required()
      ->type_name("PICTURE");
  command->add_option("--size", request->size, "Width and height in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command->add_option("--camera", request->camera, "Seen from: diagonal, x, y or z")
      ->check(CLI::IsMember({"diagonal", "x", "y", "z"}))
      ->type_name("PRESET")
      ->capture_default_str();
  add_feature_options(*command, request->features);
  command->footer(
      "Examples:\n"
      "  triplex render flow -o flow.png\n"
      "  xvfb-run -a -s \"-screen 0 1280x1024x24\" triplex render flow -o flow.png\n"
      "The second one is for machines without a screen.");
  command->callback([request, &action] { action = [request] { return run_render(*request); }; });
}

}  // namespace triplex::cli

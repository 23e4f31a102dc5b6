// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/plot_space.hpp"

#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "numbers.hpp"
#include "reading_options.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/tensor/eigenvalue_space.hpp"

namespace triplex::cli {
namespace {

// So many bins that bars are as wide as a few pixels, and an odd number of rows, so that traceless
// tensors, with the rounding of their traces, are in the middle one.
constexpr int kPerEdge = 30, kRows = 41;

struct PlotRequest {
  std::string field, picture, numbers;
  std::string size = "1800x900";
  bool hexagon = false, cone = false;
  ReadOptions reading;
};

void write_numbers(const std::string& file, const SpaceDensity& density) {
  nlohmann::ordered_json json;
  json["bins_per_edge"] = density.per_edge;
  json["rows"] = density.rows;
  json["corners"] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < 6; ++k) json["corners"].push_back(special_modes()[k].name);
  json["share_by_row_edge_bin"] = density.share;
  json["on_axis"] = density.on_axis;
  json["zero"] = density.zero;
  json["domains"] = {
      {"real-linear", density.domains[2]},          {"real-planar", density.domains[3]},
      {"outer-complex-linear", density.domains[1]}, {"outer-complex-planar", density.domains[4]},
      {"inner-complex-linear", density.domains[0]}, {"inner-complex-planar", density.domains[5]}};
  json["on_features"] = density.on_features;
  write_text_file(file, json.dump() + "\n");
}

ExitCode run_plot_space(const PlotRequest& request) {
  PlotSpaceOptions options;
  const PictureSize size = parse_size(request.size);
  options.width = size.width;
  options.height = size.height;
  if (request.hexagon || request.cone) {
    options.hexagon = request.hexagon;
    options.cone = request.cone;
  }
  if (request.field.empty()) {
    if (!request.numbers.empty()) throw UsageError("--json needs a FIELD to count in");
    plot_eigenvalue_space(request.picture, nullptr, options);
  } else {
    const TensorField field = read_field(request.field, request.reading);
    const SpaceDensity density = space_density_approx(field, kPerEdge, kRows);
    plot_eigenvalue_space(request.picture, &density, options);
    if (!request.numbers.empty()) write_numbers(request.numbers, density);
  }
  fmt::print("{}\n", request.picture);
  return ExitCode::Certified;
}

}  // namespace

void add_plot_space(CLI::App& program, Action& action) {
  auto request = std::make_shared<PlotRequest>();
  CLI::App* const command = program.add_subcommand(
      "plot-space",
      "Draw the eigenvalue space, and how a field spreads in it. Needs an X display.");
  add_reading_options(*command, request->field, request->reading);
  command->get_option("FIELD")->required(false);
  command->add_option("-o,--output", request->picture, "Picture to write (.png)")
      ->required()
      ->type_name("PICTURE");
  command->add_option("--size", request->size, "Width and height in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command->add_flag("--hexagon", request->hexagon, "Only the hexagon of modes");
  command->add_flag("--cone", request->cone, "Only the double cone of modes and isotropicity");
  command->add_option("--json", request->numbers, "Also write the shares of the volume, by bins")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  triplex plot-space -o space.png\n"
      "  triplex plot-space stress.vtu --tensor pk1 -o stress.png --json stress.json");
  command->callback(
      [request, &action] { action = [request] { return run_plot_space(*request); }; });
}

}  // namespace triplex::cli

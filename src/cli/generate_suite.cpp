// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "generate_suite.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "staged_directory.hpp"
#include "triplex/field/ground_truth.hpp"
#include "triplex/io/write_field.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormatVersion = 1;

Json features_json(const GroundTruth& truth) {
  Json features = Json::object();
  for (const SurfaceTruth& s : truth.surfaces)
    features[s.feature] = {
        {"components", s.components}, {"euler", s.euler}, {"boundary_loops", s.boundary_loops}};
  if (truth.curve)
    features["triple-curve"] = {{"components", truth.curve->components},
                                {"closed", truth.curve->closed},
                                {"ends", truth.curve->ends}};
  return features;
}

/// What the file says nothing about.
Json not_stated(const GroundTruth& truth) {
  Json names = Json::array();
  for (const char* name : {"degenerate-linear", "degenerate-planar", "neutral-real",
                           "neutral-complex", "balanced-linear", "balanced-planar"})
    if (std::ranges::find(truth.surfaces, name, &SurfaceTruth::feature) == truth.surfaces.end())
      names.push_back(name);
  if (!truth.curve) names.push_back("triple-curve");
  if (!truth.nodes) names.push_back("nodes");
  return names;
}

Json nodes_json(const GroundTruth& truth) {
  if (!truth.nodes) return nullptr;
  Json nodes = Json::array();
  for (const NodeTruth& node : *truth.nodes)
    nodes.push_back(
        {{"position", node.position}, {"eigenvalue", node.eigenvalue}, {"feature", node.feature}});
  return nodes;
}

/// The options of extract that ask for what is stated beyond the standard features.
Json extract_options(const GroundTruth& truth) {
  Json options = Json::array();
  for (const double s : truth.magnitudes) {
    options.push_back("--magnitude");
    options.push_back(fmt::format("{}", s));
  }
  return options;
}

Json truth_json(const GroundTruth& truth, const TensorField& field, const Box& box, int n,
                const std::vector<std::string>& files) {
  return {{"format", kFormatVersion},
          {"name", truth.name},
          {"title", truth.title},
          {"files", files},
          {"array", field.array_name},
          {"box", {{box.lo[0], box.hi[0]}, {box.lo[1], box.hi[1]}, {box.lo[2], box.hi[2]}}},
          {"cells_per_axis", n},
          {"tets", field.mesh.tets.size()},
          {"tensor",
           {{"1", truth.tensors[0]},
            {"x", truth.tensors[1]},
            {"y", truth.tensors[2]},
            {"z", truth.tensors[3]}}},
          {"p", truth.p},
          {"q", truth.q},
          {"extract_options", extract_options(truth)},
          {"features", features_json(truth)},
          {"nodes", nodes_json(truth)},
          {"statements", truth.statements},
          {"not_stated", not_stated(truth)},
          {"source", truth.source}};
}

std::vector<std::string> formats_of(const SuiteRequest& request) {
  std::vector<std::string> formats = request.formats;
  if (formats.empty()) formats = {"vtu"};
  for (const std::string& format : formats)
    if (format != "vtu" && format != "vtk")
      throw UsageError(fmt::format("--formats: '{}' is none of vtu, vtk", format));
  std::ranges::sort(formats, std::greater<>());  // vtu first
  formats.erase(std::unique(formats.begin(), formats.end()), formats.end());
  return formats;
}

}  // namespace

ExitCode run_generate_suite(const SuiteRequest& request) {
  const std::vector<std::string> formats = formats_of(request);
  const auto& suite = ground_truth_suite();
  sample_ground_truth(suite.front(), request.n);  // a wrong n is better known before the directory
  StagedDirectory directory(request.directory);
  Json index = {
      {"format", kFormatVersion}, {"cells_per_axis", request.n}, {"fields", Json::array()}};
  for (const GroundTruth& truth : suite) {
    const TensorField field = sample_ground_truth(truth, request.n);
    std::vector<std::string> files;
    for (const std::string& format : formats) {
      files.push_back(truth.name + "." + format);
      write_field(directory.stage(files.back()), field);
    }
    const std::string about = truth.name + ".truth.json";
    const Json json =
        truth_json(truth, field, ground_truth_box(truth, request.n), request.n, files);
    write_text_file(directory.stage(about), json.dump(2) + "\n");
    index["fields"].push_back({{"name", truth.name},
                               {"title", truth.title},
                               {"files", files},
                               {"truth", about},
                               {"extract_options", extract_options(truth)}});
  }
  write_text_file(directory.stage("suite.json"), index.dump(2) + "\n");
  directory.commit();
  fmt::print("{}: {} fields, {} tets each\n", request.directory, suite.size(),
             6 * request.n * request.n * request.n);
  return ExitCode::Certified;
}

}  // namespace triplex::cli

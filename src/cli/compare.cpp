// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "command.hpp"
#include "compare_report.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "triplex/io/atomic_file.hpp"

namespace triplex::cli {
namespace fs = std::filesystem;

namespace {

struct CompareRequest {
  std::array<std::string, 2> inputs;
  std::string tolerance = "1e-3r";
  std::string json;
  bool merge_points = false;
  bool quiet = false;
};

/// In units of length, or of the diagonal of the common bounding box.
struct Tolerance {
  double value = 0;
  bool relative = false;
};

Tolerance parse_tolerance(const std::string& text) {
  Tolerance result;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, result.value);
  result.relative = rest != end && *rest == 'r';
  if (error != std::errc() || rest + (result.relative ? 1 : 0) != end ||
      !(result.value > 0 && result.value < 1e100))
    throw UsageError("--tolerance: '" + text +
                     "' is not a positive length, such as 0.01, or share of the diagonal: 1e-3r");
  return result;
}

ComparedFiles compare_files(const std::array<std::string, 2>& files, const CompareRequest& request,
                            Progress& progress) {
  ComparedFiles result;
  result.files = files;
  std::array<FeatureMesh, 2> meshes;
  for (std::size_t m = 0; m < 2; ++m) {
    progress.show("reading " + files[m]);
    meshes[m] = read_mesh(files[m], {.merge_points = request.merge_points}, &result.repairs[m]);
    throw_if_interrupted();
  }
  const std::array views = {view_of(meshes[0]), view_of(meshes[1])};
  const double diagonal = common_box(bounding_box(views[0]), bounding_box(views[1])).diagonal();
  if (diagonal > 0 && diagonal < 1e-100)
    throw BadInput(files[0] + ": the meshes are smaller than 1e-100; choose other units");
  const Tolerance tolerance = parse_tolerance(request.tolerance);
  ComparisonOptions options;
  options.tolerance = tolerance.relative ? tolerance.value * diagonal : tolerance.value;
  options.check = [] { throw_if_interrupted(); };
  progress.show("comparing " + files[0]);
  result.comparison = compare_meshes(views[0], views[1], options);
  return result;
}

nlohmann::ordered_json report_of(const CompareRequest& request, bool agree) {
  return {{"agree", agree},
          {"inputs", request.inputs},
          {"only_in", {{"a", nlohmann::json::array()}, {"b", nlohmann::json::array()}}}};
}

void write_json(const CompareRequest& request, const nlohmann::ordered_json& report) {
  if (!request.json.empty()) write_text_file(request.json, report.dump(2) + "\n");
}

ExitCode compare_two_files(const CompareRequest& request) {
  Progress progress(request.quiet);
  const ComparedFiles files = compare_files(request.inputs, request, progress);
  progress.clear();
  const bool agree = files.comparison.agree();
  nlohmann::ordered_json report = report_of(request, agree);
  report["comparisons"] = {to_json(files)};
  write_json(request, report);
  fmt::print("{}", table_of(files));
  for (const std::string& line : differences_of(files)) fmt::print("{}\n", line);
  fmt::print("{} within {:.4g}\n", agree ? "the meshes agree" : "the meshes do not agree",
             files.comparison.tolerance);
  return agree ? ExitCode::Certified : ExitCode::Differ;
}

/// The names of the meshes in a directory; nodes.vtp, which holds points alone, is none.
std::vector<std::string> meshes_in(const std::string& directory) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (entry.is_regular_file() && is_mesh_file(entry.path()) &&
        entry.path().filename() != "nodes.vtp")
      names.push_back(entry.path().filename().string());
  if (error) throw BadInput(directory + ": the directory cannot be read; check its permissions");
  if (names.empty())
    throw BadInput(directory +
                   ": there are no meshes in this directory; give one that triplex "
                   "extract wrote");
  return names;
}

ExitCode compare_directories(const CompareRequest& request) {
  const auto& [a, b] = request.inputs;
  std::map<std::string, std::array<bool, 2>> names;
  for (std::size_t m = 0; m < 2; ++m)
    for (const std::string& name : meshes_in(request.inputs[m])) names[name][m] = true;

  Progress progress(request.quiet);
  std::map<std::string, ComparedFiles> compared;
  bool agree = true;
  nlohmann::ordered_json report = report_of(request, true);
  for (const auto& [name, in] : names) {
    if (in[0] && in[1]) {
      const std::array files = {(fs::path(a) / name).string(), (fs::path(b) / name).string()};
      const auto& result = compared[name] = compare_files(files, request, progress);
      agree = agree && result.comparison.agree();
      report["comparisons"].push_back(to_json(result));
    } else {
      agree = false;
      report["only_in"][in[0] ? "a" : "b"].push_back(name);
    }
  }
  progress.clear();
  report["agree"] = agree;
  write_json(request, report);

  fmt::print("{}", summary_header());
  for (const auto& [name, files] : compared) fmt::print("{}", summary_of(name, files));
  for (const auto& [name, in] : names)
    if (in[0] != in[1]) fmt::print("{}: only in {}\n", name, in[0] ? "A" : "B");
  for (const auto& [name, files] : compared)
    for (const std::string& line : differences_of(files)) fmt::print("{}: {}\n", name, line);
  fmt::print("{}\n", agree ? "all meshes agree" : "not all meshes agree");
  return agree ? ExitCode::Certified : ExitCode::Differ;
}

ExitCode run_compare(const CompareRequest& request) {
  parse_tolerance(request.tolerance);
  const std::array directory = {fs::is_directory(request.inputs[0]),
                                fs::is_directory(request.inputs[1])};
  if (directory[0] != directory[1])
    throw BadInput(
        request.inputs[directory[0] ? 0 : 1] +
        ": this is a directory and the other is none; give two files or two directories");
  return directory[0] ? compare_directories(request) : compare_two_files(request);
}

}  // namespace

void add_compare(CLI::App& program, Action& action) {
  auto request = std::make_shared<CompareRequest>();
  CLI::App* const command = program.add_subcommand(
      "compare", "Compare two meshes of any origin: components, topology, defects, distance.");
  command->add_option("A", request->inputs[0], "Mesh (.vtp, .vtk, .ply, .obj, .stl), or directory")
      ->required();
  command->add_option("B", request->inputs[1], "Mesh, or directory, to compare it with")
      ->required();
  command
      ->add_option(
          "--tolerance", request->tolerance,
          "What counts as near: a length, or with suffix r a share of the diagonal of both")
      ->type_name("EPS")
      ->capture_default_str();
  command->add_option("--json", request->json, "Write all results here, for programs")
      ->type_name("FILE");
  command->add_flag("--merge-points", request->merge_points,
                    "Make one point of points with equal coordinates");
  command->add_flag("--quiet", request->quiet, "No progress on stderr");
  command->footer(
      "Examples:\n"
      "  triplex compare flow/neutral-real.vtp mine.ply\n"
      "  triplex compare flow coarse --tolerance 0.01 --json differences.json\n"
      "Exit codes: 0 they agree, 2 they differ.");
  command->callback([request, &action] { action = [request] { return run_compare(*request); }; });
}

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.hpp"
#include "effort_options.hpp"
#include "feature_list.hpp"
#include "interrupt.hpp"
#include "joint_results.hpp"
#include "mesh_refinement.hpp"
#include "periodic_option.hpp"
#include "progress.hpp"
#include "reading_options.hpp"
#include "report.hpp"
#include "staged_directory.hpp"
#include "stopwatch.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/symmetric.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/io/write_cells.hpp"
#include "triplex/io/write_domains.hpp"
#include "triplex/io/write_mesh.hpp"
#include "triplex/io/write_nodes.hpp"
#include "triplex/meshing/wish_for_charts.hpp"
#include "triplex/tensor/point_arrays.hpp"

namespace triplex::cli {
namespace {

struct Steps {
  Progress progress;
  StepTiming timing;
  Stopwatch step;
  Stopwatch total;
  std::optional<RefinedMeshes> refined;
};

TensorField read_checked(const ExtractRequest& request, InputRepairs& repairs, Steps& steps) {
  steps.progress.show("reading and checking");
  TensorField field = read_field(request.field, request.reading, &repairs);
  if (request.symmetric) take_symmetric_part(field);
  steps.timing.read = steps.step.lap();
  throw_if_interrupted();
  return field;
}

Extraction extract_with_progress(const TensorField& field, const ExtractRequest& request,
                                 Steps& steps) {
  ExtractionOptions options;
  const RequestedFeatures requested = resolve(request.features);
  options.table = requested.table;
  options.features = requested.set;
  options.keep_tensors = !request.arrays.empty();
  if (const auto tolerance = parse_tolerance(request.tolerance)) {
    options.keep_patches = true;
    options.wish = wish_for_charts(field, options.table, *tolerance);
  }
  options.domains = request.domains;
  // Meshes for a tolerance are made otherwise, and the second road compares cell by cell.
  options.contract =
      !request.keep_short_edges && request.tolerance.empty() && !request.verify_quadrics;
  options.stacks = request.stacks;
  options.periodic = parse_axes(request.periodic);
  options.max_bisections = request.effort.max_bisections;
  options.max_tets = request.effort.max_tets;
  options.threads = request.effort.threads;
  options.progress = [&](std::string_view step, double done) { steps.progress.show(step, done); };
  options.interrupted = &interrupted();
  try {
    Extraction extraction = extract(field, options);
    steps.step.lap();  // timed inside
    throw_if_interrupted();
    return extraction;
  } catch (const BadInput& error) {
    throw BadInput(request.field + ": " + error.what());
  }
}

std::vector<PointValues> evaluate_arrays(const FeatureMesh& mesh,
                                         const std::vector<std::string>& names) {
  std::vector<PointValues> arrays;
  for (const std::string& name : names) {
    const PointArray& array = *point_array_named(name);
    const auto components = static_cast<std::size_t>(array.components);
    PointValues values{name, array.components, {}};
    values.values.resize(components * mesh.tensors.size());
    tbb::parallel_for(std::size_t{0}, mesh.tensors.size(), [&](std::size_t v) {
      array.evaluate(mesh.tensors[v], &values.values[components * v]);
    });
    arrays.push_back(std::move(values));
  }
  return arrays;
}

/// Files that are there only if they hold something.
void write_places(const Extraction& extraction, StagedDirectory& directory) {
  constexpr const char *kOpen = "unresolved.vtu", *kIdentical = "identical.vtu";
  if (extraction.open_cells.tets.empty())
    directory.drop(kOpen);
  else
    write_open_cells(directory.stage(kOpen), extraction.open_cells);
  if (extraction.identical.simplices.empty())
    directory.drop(kIdentical);
  else
    write_identical(directory.stage(kIdentical), extraction.identical);
}

// The meshes first, the report last: where the report is, the set is complete.
void write_results(const ExtractRequest& request, const TensorField& field,
                   const Extraction& extraction, const FeatureSummaries& summaries,
                   const QuadricChecks& quadrics, const JointResults& joint,
                   StagedDirectory& directory, Steps& steps) {
  const FeatureTable& table = extraction.table;
  for (const Feature f : reading_order(table.all())) {
    steps.progress.show("writing");
    const FeatureMesh& mesh = extraction.mesh(f);
    const std::vector<PointValues> arrays = evaluate_arrays(mesh, request.arrays);
    for (const MeshFormat format : request.formats)
      write_mesh(directory.stage(fmt::format("{}.{}", table.row(f).name, name_of(format))), format,
                 mesh, f, arrays);
    throw_if_interrupted();
  }
  if (std::ranges::count(request.formats, MeshFormat::Vtp) > 0) {
    write_nodes(directory.stage("nodes.vtp"), extraction.nodes);
    std::vector<std::string_view> blocks = names_of(table, table.all());
    blocks.push_back("nodes");
    if (joint.crossings) blocks.push_back("crossings");
    write_collection(directory.stage("features.vtpc"), blocks);
  }
  write_joint_files(joint, table, directory);
  if (request.domains) write_domains(directory.stage("domains.vtu"), extraction.domains);
  write_places(extraction, directory);
  steps.timing.write = steps.step.lap();
  steps.timing.total = steps.total.lap();
  nlohmann::ordered_json report =
      make_report(request, field, extraction, summaries, steps.refined, quadrics, steps.timing);
  add_to_report(joint, table, report);
  write_text_file(directory.stage("report.json"), report.dump(2) + "\n");
  directory.commit();
}

ExitCode run_extract(const ExtractRequest& request) {
  Steps steps{Progress(request.effort.quiet), {}, {}, {}, {}};
  InputRepairs repairs;
  const TensorField field = read_checked(request, repairs, steps);
  StagedDirectory directory(request.directory);  // before the long part: it may be unwritable
  Extraction extraction = extract_with_progress(field, request, steps);
  QuadricChecks quadrics;
  if (request.verify_quadrics) {
    steps.progress.show("quadrics");
    quadrics = check_quadrics(field, extraction, request.effort.threads);
    steps.timing.quadrics = steps.step.lap();
    throw_if_interrupted();
  }
  if (!request.tolerance.empty()) {
    steps.refined = refine_meshes(request, field, extraction, steps.progress);
    steps.timing.mesh = steps.step.lap();
  }
  steps.progress.show("topology");
  const FeatureSummaries summaries = summarize(extraction);
  const JointResults joint = examine_jointly(request, extraction, steps.progress);
  steps.timing.topology = steps.step.lap();
  write_results(request, field, extraction, summaries, quadrics, joint, directory, steps);
  steps.progress.clear();
  fmt::print("{}", describe_reading(field.split, repairs));
  fmt::print("{}{}", make_table(extraction, summaries), quadrics_lines(quadrics));
  if (steps.refined) fmt::print("{}", describe(*steps.refined));
  fmt::print("{}", joint_lines(joint));
  if (!all_agree(quadrics)) return ExitCode::Fault;
  return extraction.certified() ? ExitCode::Certified : ExitCode::Unresolved;
}

std::string point_array_names() {
  std::vector<std::string_view> names;
  for (const PointArray& array : point_array_table()) names.push_back(array.name);
  return fmt::format("{}", fmt::join(names, ","));
}

void check_array_names(std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (point_array_named(name) == nullptr)
      throw UsageError(fmt::format("--arrays: no array is called '{}'; there are {}", name,
                                   point_array_names()));
  // Every mesh has these.
  std::erase_if(names, [](const std::string& n) { return n == "p" || n == "q" || n == "mode"; });
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

void check_tolerance(const ExtractRequest& request) {
  if (request.tolerance.empty()) return;
  if (!parse_tolerance(request.tolerance))
    throw UsageError(
        fmt::format("--tolerance: '{}' is no positive number, with or without an r behind it",
                    request.tolerance));
}

std::vector<MeshFormat> parse_formats(const std::vector<std::string>& names) {
  std::vector<MeshFormat> formats;
  for (const std::string& name : names) {
    const auto format = mesh_format_named(name);
    if (!format)
      throw UsageError(fmt::format("--format: '{}' is none of vtp, ply, obj, stl", name));
    if (std::ranges::count(formats, *format) == 0) formats.push_back(*format);
  }
  return formats;
}

}  // namespace

void add_extract(CLI::App& program, Action& action) {
  auto request = std::make_shared<ExtractRequest>();
  auto formats = std::make_shared<std::vector<std::string>>();
  CLI::App* const command = program.add_subcommand(
      "extract",
      "Extract the feature surfaces and the triple degenerate curve, with certificates.");
  add_reading_options(*command, request->field, request->reading);
  command->add_option("-o,--output", request->directory, "Directory for the results")
      ->required()
      ->type_name("DIR");
  add_feature_options(*command, request->features);
  command
      ->add_option("--arrays", request->arrays,
                   "Further point arrays of the meshes, of " + point_array_names())
      ->delimiter(',')
      ->type_name("A,B,...");
  command->add_option("--format", *formats, "Formats of the meshes: vtp, ply, obj, stl")
      ->delimiter(',')
      ->type_name("A,B,...")
      ->default_str("vtp");
  command->add_flag(
      "--symmetric", request->symmetric,
      "Take the symmetric parts of the tensors; their degenerate features are curves");
  command->add_flag("--domains", request->domains,
                    "Also domains.vtu: the domain cut by all pages into cells");
  command
      ->add_option(
          "--tolerance", request->tolerance,
          "Largest distance between meshes and surfaces, both ways: a length, or with an r "
          "behind it a part of the longest edge of the tet at hand")
      ->type_name("EPS");
  command->add_flag(
      "--verify-quadrics", request->verify_quadrics,
      "Find balanced, magnitude, isotropicity and traceless surfaces again as quadrics "
      "of each tet, and compare");
  add_periodic_option(*command, request->periodic,
                      "Opposite sides across these axes are one; their tensors must be equal");
  command
      ->add_flag("--stacks", request->stacks,
                 "Also certify cells that hold several discs of a degenerate surface, where its "
                 "sheets nearly touch; slow on hard fields")
      ->excludes("--periodic", "--domains", "--tolerance");
  command->add_flag("--keep-short-edges", request->keep_short_edges,
                    "Keep edges of the size of rounding, which are contracted otherwise where "
                    "that changes no topology");
  command->add_flag("--check-embedding", request->check_embedding,
                    "Decide exactly whether triangles meet where they should not");
  command->add_flag("--complex", request->complex,
                    "Also complex.vtu: all features as one complex of patches, curves, corners");
  add_effort_options(*command, request->effort);
  command->footer(
      "Examples:\n"
      "  triplex extract flow.vtu -o flow\n"
      "  triplex extract flow.vtu -o flow --features degenerate-linear,triple-curve\n"
      "  triplex extract flow.vtu -o flow --gradient-of U\n"
      "  triplex extract flow.vtu -o flow --tolerance 1e-3r\n"
      "  triplex extract beam.vtu -o beam --symmetric\n"
      "  triplex extract flow.vtu -o flow --features none --mode 1/2,-,+ --mode 1/2,-,-\n"
      "DIR gets one file per feature (empty ones too), nodes.vtp, features.vtpc for all of them, "
      "and report.json.");
  command->callback([request, formats, &action] {
    const RequestedFeatures requested = resolve(request->features);  // wrong ones: before the work
    if (request->verify_quadrics) require_quadrics(requested);
    check_array_names(request->arrays);
    parse_axes(request->periodic);
    check_tolerance(*request);
    if (!formats->empty()) request->formats = parse_formats(*formats);
    action = [request] { return run_extract(*request); };
  });
}

}  // namespace triplex::cli

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "feature_list.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "reading_options.hpp"
#include "report.hpp"
#include "staged_directory.hpp"
#include "stopwatch.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/io/write_polydata.hpp"

namespace triplex::cli {
namespace {

struct Steps {
  Progress progress;
  StepTiming timing;
  Stopwatch step;
  Stopwatch total;
};

TensorField read_checked(const ExtractRequest& request, InputRepairs& repairs, Steps& steps) {
  steps.progress.show("reading and checking");
  TensorField field = read_field(request.field, request.reading, &repairs);
  steps.timing.read = steps.step.lap();
  throw_if_interrupted();
  return field;
}

Extraction extract_with_progress(const TensorField& field, const ExtractRequest& request,
                                 Steps& steps) {
  ExtractionOptions options;
  options.features = request.features;
  options.max_bisections = request.max_bisections;
  options.threads = request.threads;
  options.progress = [&](std::string_view step, double done) { steps.progress.show(step, done); };
  options.interrupted = &interrupted();
  Extraction extraction = extract(field, options);
  steps.step.lap();  // timed inside
  throw_if_interrupted();
  return extraction;
}

// The meshes first, the report last: where the report is, the set is complete.
void write_results(const ExtractRequest& request, const TensorField& field,
                   const Extraction& extraction, const FeatureSummaries& summaries,
                   StagedDirectory& directory, Steps& steps) {
  for (const Feature f : kReadingOrder) {
    steps.progress.show("writing");
    write_polydata(directory.stage(std::string(row(f).name) + ".vtp"),
                   extraction.features[static_cast<std::size_t>(f)], f);
    throw_if_interrupted();
  }
  steps.timing.write = steps.step.lap();
  steps.timing.total = steps.total.lap();
  write_text_file(directory.stage("report.json"),
                  make_report(request, field, extraction, summaries, steps.timing).dump(2) + "\n");
  directory.commit();
}

ExitCode run_extract(const ExtractRequest& request) {
  Steps steps{Progress(request.quiet), {}, {}, {}};
  InputRepairs repairs;
  const TensorField field = read_checked(request, repairs, steps);
  StagedDirectory directory(request.directory);  // before the long part: it may be unwritable
  const Extraction extraction = extract_with_progress(field, request, steps);
  steps.progress.show("topology");
  const FeatureSummaries summaries = summarize(extraction);
  steps.timing.topology = steps.step.lap();
  write_results(request, field, extraction, summaries, directory, steps);
  steps.progress.clear();
  fmt::print("{}", describe_reading(field.split, repairs));
  fmt::print("{}", make_table(request, extraction, summaries));
  return extraction.certified() ? ExitCode::Certified : ExitCode::Unresolved;
}

}  // namespace

void add_extract(CLI::App& program, Action& action) {
  auto request = std::make_shared<ExtractRequest>();
  auto names = std::make_shared<std::vector<std::string>>();
  request->max_bisections = ExtractionOptions{}.max_bisections;
  CLI::App* const command = program.add_subcommand(
      "extract",
      "Extract the feature surfaces and the triple degenerate curve, with certificates.");
  add_reading_options(*command, request->field, request->reading);
  command->add_option("-o,--output", request->directory, "Directory for the results")
      ->required()
      ->type_name("DIR");
  command->add_option("--features", *names, "Only these, of " + all_feature_names())
      ->delimiter(',')
      ->type_name("A,B,...");
  command
      ->add_option("--max-bisections", request->max_bisections,
                   "Bisections that one tet may ask for before it is listed as unresolved")
      ->check(CLI::Range(0u, 1'000'000u))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--threads", request->threads, "Threads; 0: all cores")
      ->check(CLI::Range(0u, 4096u))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--quiet", request->quiet, "No progress on stderr");
  command->footer(
      "Examples:\n"
      "  triplex extract flow.vtu -o flow\n"
      "  triplex extract flow.vtu -o flow --features degenerate-linear,triple-curve\n"
      "  triplex extract flow.vtu -o flow --gradient-of U\n"
      "DIR gets one .vtp file per feature (empty ones too) and report.json.");
  command->callback([request, names, &action] {
    if (!names->empty()) request->features = parse_features(*names);
    action = [request] { return run_extract(*request); };
  });
}

}  // namespace triplex::cli

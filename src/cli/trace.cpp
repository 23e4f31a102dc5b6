// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "command.hpp"
#include "interrupt.hpp"
#include "periodic_option.hpp"
#include "progress.hpp"
#include "reading_options.hpp"
#include "seed_options.hpp"
#include "staged_directory.hpp"
#include "trace_report.hpp"
#include "triplex/flow/streamlines.hpp"
#include "triplex/flow/vortex_cores.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/io/read_vectors.hpp"
#include "triplex/io/write_hyperstreamlines.hpp"
#include "triplex/trace/tracer.hpp"
#include "version.hpp"

namespace triplex::cli {
namespace {

constexpr const char* kNothing = "none";
// Of the diagonal of the mesh's box; choices, so that a curve through the box is seen as a plant.
constexpr double kRadius = 0.004, kSpacing = 0.02, kSize = 0.03;

struct TraceRequest {
  std::string field;
  ReadOptions reading;
  std::string directory;
  SeedRequest seeds;
  std::string follow = "dominant";
  std::string streamlines, cores;
  bool unfiltered = false;
  double length = 0, tolerance = 1e-9;
  std::size_t max_steps = 100'000;
  std::vector<std::string> periodic;
  bool bare = false;
  double spacing = 0, radius = 0, size = 0;
  int threads = 0;
  bool quiet = false;

  bool wants_curves() const { return seeds.any() && follow != kNothing; }
  InputOptions repairs() const { return {reading.merge_points, reading.fix_orientation}; }
};

Box box_of(const TetMesh& mesh) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (const auto& tet : mesh.tets)
    for (const VertexId v : tet)
      for (std::size_t k = 0; k < 3; ++k) {
        box.lo[k] = std::min(box.lo[k], mesh.points[index(v)][k]);
        box.hi[k] = std::max(box.hi[k], mesh.points[index(v)][k]);
      }
  return box;
}

double diagonal_of(const Box& box) {
  return std::hypot(box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]);
}

TraceOptions trace_options(const TraceRequest& request) {
  TraceOptions options;
  const auto field = std::ranges::find(kEigenvectorFields, request.follow);
  options.field = static_cast<EigenvectorField>(field - kEigenvectorFields.begin());
  options.max_length = request.length;
  options.max_steps = request.max_steps;
  options.tolerance = request.tolerance;
  options.interrupted = &interrupted();
  return options;
}

/// The user's own seeds, and those of the grid that the mesh holds.
std::vector<Point> seeds_inside(const TraceRequest& request, const TensorField& field,
                                const Tracer& tracer, TraceResults& results) {
  const Seeds seeds = find_seeds(request.seeds, box_of(field.mesh));
  for (const auto& [x, y, z] : seeds.own)
    if (!tracer.find({x, y, z}))
      throw BadInput(fmt::format(
          "{}: the seed ({}, {}, {}) lies outside the mesh; choose one inside (triplex info shows "
          "its box)",
          request.field, x, y, z));
  std::vector<Point> inside = seeds.own;
  for (const Point& seed : seeds.of_grid)
    if (tracer.find(seed)) inside.push_back(seed);
  results.seeds = inside.size();
  results.seeds_outside = seeds.own.size() + seeds.of_grid.size() - inside.size();
  return inside;
}

Plant grow_all(const TraceRequest& request, const std::vector<Hyperstreamline>& curves,
               double diagonal, TraceResults& results) {
  const auto choose = [diagonal](double given, double share) {
    return given > 0 ? given : share * diagonal;
  };
  const double size = choose(request.size, kSize);
  const PlantSizes sizes = {.radius = choose(request.radius, kRadius), .thorn = size, .leaf = size};
  Plant plant;
  try {
    for (std::size_t c = 0; c < curves.size(); ++c) {
      throw_if_interrupted();
      const Augmentation augmentation =
          augment(curves[c], {.spacing = choose(request.spacing, kSpacing)});
      results.thorns += augmentation.thorns.size();
      results.leaves += augmentation.leaves.size();
      grow(curves[c], augmentation, sizes, static_cast<std::uint32_t>(c), plant);
    }
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string(error.what()) + " (--spacing, --radius, --bare)");
  }
  return plant;
}

/// Files that this run does not write go, if an earlier one wrote them.
template <class Write>
void write_or_drop(StagedDirectory& directory, const char* name, bool wanted, const Write& write) {
  if (wanted)
    write(directory.stage(name));
  else
    directory.drop(name);
}

/// Traces through the tensors; the seeds that the mesh holds.
std::vector<Point> trace_tensors(const TraceRequest& request, StagedDirectory& directory,
                                 Progress& progress, TraceResults& results,
                                 std::string& reading_lines) {
  progress.show("reading and checking");
  InputRepairs repairs;
  const TensorField field = read_field(request.field, request.reading, &repairs);
  reading_lines = describe_reading(field.split, repairs);
  throw_if_interrupted();
  progress.show("locating");
  std::vector<Point> seeds;
  try {
    const Tracer tracer(field, parse_axes(request.periodic));
    seeds = seeds_inside(request, field, tracer, results);
    progress.show("tracing");
    results.curves = tracer.trace_all(seeds, trace_options(request));
  } catch (const BadInput& error) {
    const std::string text = error.what();
    const bool named = text.starts_with(request.field) ||
                       (!request.seeds.file.empty() && text.starts_with(request.seeds.file));
    throw BadInput(named ? text : request.field + ": " + text);
  }
  throw_if_interrupted();
  const auto& curves = *results.curves;
  Plant plant;
  if (!request.bare) {
    progress.show("growing thorns and leaves");
    plant = grow_all(request, curves, diagonal_of(box_of(field.mesh)), results);
  }
  progress.show("writing");
  write_hyperstreamlines(directory.stage("hyperstreamlines.vtp"), curves, field);
  write_stem_events(directory.stage("events.vtp"), curves);
  write_or_drop(directory, "plant.vtp", !request.bare,
                [&](const auto& file) { write_plant(file, plant); });
  return seeds;
}

/// The velocity array, which may be the same for streamlines and cores.
void trace_flow(const TraceRequest& request, const std::vector<Point>& seeds, Progress& progress,
                TraceResults& results) {
  if (!request.streamlines.empty()) {
    progress.show("streamlines");
    const VectorField field = read_vectors(request.field, request.streamlines, request.repairs());
    const Box box = box_of(field.mesh);
    std::vector<Point> starts = seeds;
    if (!request.wants_curves()) {
      const Seeds found = find_seeds(request.seeds, box);
      starts = found.own;
      starts.insert(starts.end(), found.of_grid.begin(), found.of_grid.end());
      results.seeds = starts.size();
    }
    results.streamlines =
        streamlines(field, starts, {.max_length = request.length, .max_steps = request.max_steps});
    throw_if_interrupted();
  }
  if (!request.cores.empty()) {
    progress.show("vortex cores");
    const VectorField field = read_vectors(request.field, request.cores, request.repairs());
    results.cores = vortex_cores(field, request.unfiltered ? CoreFilter::Complex : CoreFilter::Vtk);
    throw_if_interrupted();
  }
}

nlohmann::ordered_json options_of(const TraceRequest& request) {
  return {{"follow", request.follow},
          {"seed", request.seeds.points},
          {"seeds", request.seeds.file},
          {"seed_grid", request.seeds.grid},
          {"streamlines", request.streamlines},
          {"vortex_cores", request.cores},
          {"unfiltered", request.unfiltered},
          {"length", request.length},
          {"max_steps", request.max_steps},
          {"step_tolerance", request.tolerance},
          {"periodic", request.periodic},
          {"bare", request.bare},
          {"spacing", request.spacing},
          {"radius", request.radius},
          {"size", request.size}};
}

ExitCode run_trace(const TraceRequest& request) {
  std::unique_ptr<tbb::global_control> limit;
  if (request.threads > 0)
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  static_cast<std::size_t>(request.threads));
  Progress progress(request.quiet);
  TraceResults results;
  std::string reading_lines;
  StagedDirectory directory(request.directory);
  std::vector<Point> seeds;
  if (request.wants_curves()) {
    seeds = trace_tensors(request, directory, progress, results, reading_lines);
  } else {
    for (const char* name : {"hyperstreamlines.vtp", "events.vtp", "plant.vtp"})
      directory.drop(name);
  }
  trace_flow(request, seeds, progress, results);
  progress.show("writing");
  write_or_drop(directory, "streamlines.vtp", results.streamlines.has_value(),
                [&](const auto& file) { write_lines(file, *results.streamlines); });
  write_or_drop(directory, "vortex-cores.vtp", results.cores.has_value(),
                [&](const auto& file) { write_lines(file, *results.cores); });
  nlohmann::ordered_json report = {{"version", kVersion}, {"field", request.field}};
  report["options"] = options_of(request);
  report.update(to_json(results));
  write_text_file(directory.stage("trace.json"), report.dump(2) + "\n");
  directory.commit();
  progress.clear();
  fmt::print("{}{}", reading_lines, describe(results));
  return ExitCode::Certified;
}

void check_request(const TraceRequest& request) {
  check_seed_options(request.seeds);
  parse_axes(request.periodic);
  if (!request.seeds.any() && request.cores.empty())
    throw UsageError(
        "there is nothing to trace; give --seed, --seeds, --seed-grid or "
        "--vortex-cores");
  if (!request.seeds.any() && !request.streamlines.empty())
    throw UsageError("--streamlines needs seeds; give --seed, --seeds or --seed-grid");
  if (request.follow == kNothing && request.streamlines.empty() && request.cores.empty())
    throw UsageError("--follow none leaves nothing to trace; add --streamlines or --vortex-cores");
  if (request.unfiltered && request.cores.empty())
    throw UsageError("--unfiltered is for --vortex-cores only");
  for (const auto& [name, value] : {std::pair{"--length", request.length},
                                    {"--spacing", request.spacing},
                                    {"--radius", request.radius},
                                    {"--size", request.size}})
    if (!(value >= 0) || !std::isfinite(value))
      throw UsageError(fmt::format("{}: {} is no positive length", name, value));
}

void add_tracing_options(CLI::App& command, TraceRequest& request) {
  std::vector<std::string> fields(kEigenvectorFields.begin(), kEigenvectorFields.end());
  fields.emplace_back(kNothing);
  command
      .add_option("--follow", request.follow,
                  "The eigenvector to follow: dominant, major, medium, minor, real or none")
      ->check(CLI::IsMember(fields))
      ->type_name("WHICH")
      ->capture_default_str();
  command
      .add_option("--length", request.length,
                  "Longest arc in each direction; 0: twice the diagonal of the mesh's box")
      ->type_name("L")
      ->capture_default_str();
  command.add_option("--max-steps", request.max_steps, "Most steps in each direction")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}))
      ->type_name("N")
      ->capture_default_str();
  command
      .add_option("--step-tolerance", request.tolerance,
                  "Estimated error of one step, as a part of the longest edge of its tet")
      ->check(CLI::Range(1e-13, 1e-2))
      ->type_name("EPS")
      ->capture_default_str();
  add_periodic_option(
      command, request.periodic,
      "Curves that leave by one side across these axes go on from the opposite one");
  command
      .add_option("--streamlines", request.streamlines,
                  "Also streamlines of this point array with 3 components, through the seeds")
      ->type_name("NAME");
  command
      .add_option("--vortex-cores", request.cores,
                  "Also the vortex core lines of this velocity array, as VTK's filter has them")
      ->type_name("NAME");
  command.add_flag("--unfiltered", request.unfiltered,
                   "All of them where the gradient has complex eigenvalues");
}

void add_plant_options(CLI::App& command, TraceRequest& request) {
  command.add_flag("--bare", request.bare, "No plant.vtp: curves and events only");
  command
      .add_option("--spacing", request.spacing,
                  "Distance between thorns, and between leaves; 0: a share of the box")
      ->type_name("D")
      ->capture_default_str();
  command.add_option("--radius", request.radius, "Of the stem; 0: a share of the box")
      ->type_name("R")
      ->capture_default_str();
  command
      .add_option("--size", request.size,
                  "Length of thorns, long semi-axis of leaves; 0: a share of the box")
      ->type_name("S")
      ->capture_default_str();
}

}  // namespace

void add_trace(CLI::App& program, Action& action) {
  auto request = std::make_shared<TraceRequest>();
  CLI::App* const command = program.add_subcommand(
      "trace", "Trace hyperstreamlines with thorns and leaves, streamlines, vortex cores.");
  add_reading_options(*command, request->field, request->reading);
  command->add_option("-o,--output", request->directory, "Directory for the results")
      ->required()
      ->type_name("DIR");
  add_seed_options(*command, request->seeds);
  add_tracing_options(*command, *request);
  add_plant_options(*command, *request);
  command->add_option("--threads", request->threads, "Threads; 0: all cores")
      ->check(CLI::Range(0, 4096))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--quiet", request->quiet, "No progress on stderr");
  command->footer(
      "Examples:\n"
      "  triplex trace flow.vtu -o trace --seed 0.5,0.5,0.5\n"
      "  triplex trace flow.vtu -o trace --seed-grid 4,4,4 --follow major --bare\n"
      "  triplex trace abc.vtu -o trace --seed 3.14159,3.14159,3.14159 --periodic x,y,z\n"
      "  triplex trace case.vtu -o trace --gradient-of U --vortex-cores U --unfiltered\n"
      "DIR gets hyperstreamlines.vtp, events.vtp and plant.vtp, streamlines.vtp, vortex-cores.vtp "
      "and trace.json.");
  command->callback([request, &action] {
    check_request(*request);
    action = [request] { return run_trace(*request); };
  });
}

}  // namespace triplex::cli

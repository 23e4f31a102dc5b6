// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "audit_report.hpp"
#include "command.hpp"
#include "effort_options.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "reading_options.hpp"
#include "staged_directory.hpp"
#include "stopwatch.hpp"
#include "triplex/baseline/a_patches.hpp"
#include "triplex/contour/vtk_contour.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/io/atomic_file.hpp"
#include "triplex/io/resident_memory.hpp"
#include "triplex/io/write_differences.hpp"
#include "triplex/io/write_mesh.hpp"

namespace triplex::cli {
namespace {

constexpr std::string_view kAPatches = "a-patches", kContour = "vtk-contour";

/// Runs one road and takes its time and the memory it needed on top of what was there.
template <class Run>
auto measured(RoadCost& cost, const Run& run) {
  const bool peak_known = restart_memory_peak();
  const auto before = resident_memory();
  Stopwatch watch;
  auto result = run();
  cost.seconds = watch.lap();
  if (const auto after = resident_memory(); peak_known && before && after)
    cost.bytes = after->peak - before->now;
  throw_if_interrupted();
  return result;
}

Extraction run_robust(const TensorField& field, const AuditRequest& request,
                      const RequestedFeatures& requested, Progress& progress) {
  ExtractionOptions options;
  options.table = requested.table;
  options.features = requested.set;
  options.max_bisections = request.effort.max_bisections;
  options.max_tets = request.effort.max_tets;
  options.threads = request.effort.threads;
  options.progress = [&](std::string_view step, double done) { progress.show(step, done); };
  options.interrupted = &interrupted();
  return extract(field, options);
}

Approximation run_other(const TensorField& field, const AuditRequest& request,
                        const RequestedFeatures& requested, Progress& progress) {
  progress.show(request.against);
  if (request.against == kContour)
    return extract_vtk_contours(field, requested.table, requested.set);
  APatchOptions options;
  options.table = requested.table;
  options.features = requested.set;
  options.max_depth = request.max_depth;
  options.samples = request.samples;
  if (request.layers_only) options.patch_test = PatchTest::Layers;
  options.threads = request.effort.threads;
  options.progress = [&](std::string_view step, double done) { progress.show(step, done); };
  options.interrupted = &interrupted();
  return extract_a_patches(field, options);
}

AuditedRoad road_of(const Extraction& extraction) {
  AuditedRoad road{extraction.features, {}};
  road.open.resize(extraction.features.size());
  for (const UnresolvedTet& tet : extraction.unresolved)
    for (std::size_t f = 0; f < road.open.size(); ++f)
      if (contains(tet.features, static_cast<Feature>(f))) road.open[f].push_back(tet.source_cell);
  return road;
}
AuditedRoad road_of(const Approximation& approximation) {
  AuditedRoad road{approximation.features, {}};
  road.open.resize(approximation.features.size());
  for (const GivenUp& given_up : approximation.given_up)
    road.open[index(given_up.feature)].push_back(given_up.source_cell);
  return road;
}

/// What of the field the comparison of two meshes needs: where surfaces may end, the diagonal of
/// its box, and the edge of a cube that is as large as six of as many tets in that box.
struct Domain {
  DomainBoundary boundary;
  double diagonal = 0, cell = 0;

  explicit Domain(const TensorField& field) : boundary(field) {
    BoundingBox box{field.mesh.points.front(), field.mesh.points.front()};
    for (const Point& x : field.mesh.points) box = common_box(box, {x, x});
    double volume = 1;
    for (std::size_t k = 0; k < 3; ++k) volume *= box.high[k] - box.low[k];
    diagonal = box.diagonal();
    cell = std::cbrt(6 * volume / static_cast<double>(field.mesh.tets.size()));
  }
};

/// Of one feature: numbers of both sides and the distances between them.
FeatureAudit audit_feature(const Domain& domain, const FeatureTable& table, Feature f,
                           const AuditedRoad& robust, const AuditedRoad& other,
                           const AuditRequest& request) {
  FeatureAudit audit;
  audit.feature = f;
  audit.robust = summarize(domain.boundary, table, robust.features, f);
  audit.other = summarize(domain.boundary, table, other.features, f);
  audit.robust_open = robust.open[index(f)].size();
  audit.other_open = other.open[index(f)].size();
  if (request.tolerance == 0) return audit;
  // Components belong together if they are nearer than a cell is large; chords are off by less.
  ComparisonOptions options;
  options.tolerance = domain.cell;
  options.gap = request.tolerance * domain.diagonal;
  options.check = throw_if_interrupted;
  audit.comparison = compare_meshes(view_of(robust.features[index(f)]),
                                    view_of(other.features[index(f)]), options);
  return audit;
}

AuditResult compare_roads(const TensorField& field, const RequestedFeatures& requested,
                          const Extraction& extraction, const Approximation& approximation,
                          const AuditRequest& request, Progress& progress) {
  const AuditedRoad robust = road_of(extraction), other = road_of(approximation);
  AuditResult result;
  result.table = requested.table;
  result.tets = field.mesh.tets.size();
  result.refinement = extraction.refinement;
  const Domain domain(field);
  for (const Feature f : reading_order(requested.set)) {
    if (contains(extraction.curves, f)) {
      result.left_out.push_back(f);
      continue;
    }
    progress.show("measuring " + requested.table.row(f).name);
    result.features.push_back(audit_feature(domain, requested.table, f, robust, other, request));
    throw_if_interrupted();
  }
  progress.show("auditing tets");
  AuditOptions options;
  options.threads = request.effort.threads;
  options.interrupted = &interrupted();
  result.differences =
      audit(field, requested.table, requested.set & ~extraction.curves, robust, other, options);
  return result;
}

void write_meshes(const RequestedFeatures& requested, const std::string& prefix,
                  std::span<const FeatureMesh> features, StagedDirectory& directory) {
  for (const Feature f : reading_order(requested.set))
    write_mesh(directory.stage(fmt::format("{}-{}.vtp", prefix, requested.table.row(f).name)),
               MeshFormat::Vtp, features[index(f)], f);
}

ExitCode run_audit(const AuditRequest& request) {
  Progress progress(request.effort.quiet);
  progress.show("reading and checking");
  InputRepairs repairs;
  const TensorField field = read_field(request.field, request.reading, &repairs);
  const RequestedFeatures requested = resolve(request.features);
  throw_if_interrupted();
  StagedDirectory directory(request.directory);  // before the long part: it may be unwritable

  RoadCost robust_cost, other_cost;
  const Approximation approximation =
      measured(other_cost, [&] { return run_other(field, request, requested, progress); });
  const Extraction extraction =
      measured(robust_cost, [&] { return run_robust(field, request, requested, progress); });
  AuditResult result =
      compare_roads(field, requested, extraction, approximation, request, progress);
  result.robust = robust_cost;
  result.other = other_cost;

  progress.show("writing");
  write_differing_cells(directory.stage("differences.vtu"), field, result.differences);
  write_differing_pieces(directory.stage("differences.vtp"), result.differences,
                         road_of(extraction), road_of(approximation));
  if (request.meshes) {
    write_meshes(requested, "robust", extraction.features, directory);
    write_meshes(requested, request.against, approximation.features, directory);
  }
  write_text_file(directory.stage("audit.json"), audit_json(request, result).dump(2) + "\n");
  directory.commit();
  progress.clear();
  fmt::print("{}{}", describe_reading(field.split, repairs), audit_table(request, result));
  if (refutes_certificate(result)) return ExitCode::Fault;
  return extraction.certified() ? ExitCode::Certified : ExitCode::Unresolved;
}

}  // namespace

void add_audit(CLI::App& program, Action& action) {
  auto request = std::make_shared<AuditRequest>();
  request->max_depth = APatchOptions{}.max_depth;
  CLI::App* const command = program.add_subcommand(
      "audit", "Compare the certified extraction with a fast one, per feature and per tet.");
  add_reading_options(*command, request->field, request->reading);
  command->add_option("-o,--output", request->directory, "Directory for the results")
      ->required()
      ->type_name("DIR");
  add_feature_options(*command, request->features);
  command->add_option("--against", request->against, "The fast road: a-patches or vtk-contour")
      ->check(CLI::IsMember({std::string(kAPatches), std::string(kContour)}))
      ->capture_default_str();
  command
      ->add_option("--max-depth", request->max_depth, "Halvings of a tet before A-patches give up")
      ->check(CLI::Range(0, 60))
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--samples", request->samples, "Segments along an edge of an A-patch")
      ->check(CLI::Range(1, 64))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--layers-only", request->layers_only,
                    "A-patches by the published condition on layers alone");
  command
      ->add_option("--tolerance", request->tolerance,
                   "Of the distances, relative to the diagonal of the domain; 0: no distances")
      ->check(CLI::Range(0.0, 1.0))
      ->type_name("EPS")
      ->capture_default_str();
  command->add_flag("--meshes", request->meshes, "Also write the meshes of both roads");
  add_effort_options(*command, request->effort);
  command->footer(
      "Examples:\n"
      "  triplex audit flow.vtu -o audit\n"
      "  triplex audit flow.vtu -o audit --against vtk-contour --features degenerate-linear\n"
      "DIR gets audit.json, differences.vtu (tets) and differences.vtp (pieces and witnesses).\n"
      "Exit codes as of extract; 3 also if exact arithmetic refutes a certified tet.");
  command->callback([request, &action] {
    resolve(request->features);  // what is wrong with it is better known before the work
    action = [request] { return run_audit(*request); };
  });
}

}  // namespace triplex::cli

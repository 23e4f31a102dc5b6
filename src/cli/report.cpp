// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "mesh_refinement.hpp"
#include "report_places.hpp"
#include "triplex/io/resident_memory.hpp"
#include "version.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

Json bounds_of(const TensorField& field) {
  Json bounds = Json::array();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -lo;
    for (const Point& x : field.mesh.points) {
      lo = std::min(lo, x[axis]);
      hi = std::max(hi, x[axis]);
    }
    bounds.push_back({lo, hi});
  }
  return bounds;
}

Json field_json(const ExtractRequest& request, const TensorField& field) {
  return {{"file", request.field},
          {"tets", field.mesh.tets.size()},
          {"vertices", field.mesh.points.size()},
          {"array", field.array_name},
          {"bounds", bounds_of(field)},
          {"split",
           {{"hexahedra", field.split.hexahedra},
            {"wedges", field.split.wedges},
            {"pyramids", field.split.pyramids}}}};
}

Json options_json(const ExtractRequest& request, const Extraction& extraction) {
  std::vector<std::string_view> formats;
  for (const MeshFormat format : request.formats) formats.push_back(name_of(format));
  Json json = Json::object();
  add_to_json(request.features, json);
  json.update({{"arrays", request.arrays},
               {"formats", formats},
               {"periodic", request.periodic},
               {"symmetric", request.symmetric},
               {"domains", request.domains},
               {"tolerance", request.tolerance},
               {"verify_quadrics", request.verify_quadrics},
               {"max_bisections", extraction.refinement.max_bisections},
               {"max_tets", extraction.refinement.max_tets},
               {"threads", request.effort.threads},
               {"stacks", request.stacks},
               {"keep_short_edges", request.keep_short_edges},
               {"check_embedding", request.check_embedding},
               {"complex", request.complex},
               {"tensor", request.reading.tensor_name},
               {"gradient_of", request.reading.gradient_of},
               {"transpose", request.reading.transpose},
               {"symmetric_order", request.reading.symmetric_order},
               {"merge_points", request.reading.merge_points},
               {"fix_orientation", request.reading.fix_orientation}});
  return json;
}

Json surface_json(const FeatureSummary& summary) {
  const SurfaceTopology& s = summary.surface;
  return {{"vertices", s.vertices},
          {"triangles", s.triangles},
          {"components", s.components},
          {"euler", s.euler},
          {"boundary_loops", s.boundary_loops},
          {"area", summary.measure},
          {"smallest_angles",
           {{"degrees", summary.angles.smallest}, {"by_ten_degrees", summary.angles.counts}}},
          {"unresolved", summary.unresolved}};
}

Json curve_json(const FeatureSummary& summary) {
  const CurveTopology& c = summary.curve;
  return {{"vertices", c.vertices},          {"segments", c.segments},
          {"components", c.components},      {"closed", c.closed},
          {"open", c.components - c.closed}, {"length", summary.measure},
          {"unresolved", summary.unresolved}};
}

Json triple_curve_json(const FeatureSummary& summary, const SpineAccuracy& accuracy) {
  Json json = curve_json(summary);
  json["largest_error"] = accuracy.error;
  json["largest_error_in_face"] = accuracy.coordinate_error;
  json["proven_points"] = accuracy.proven;
  json["unproven_points"] = accuracy.unproven;
  return json;
}

/// The degenerate features of symmetric tensors.
Json degenerate_curve_json(const FeatureSummary& summary) {
  Json json = curve_json(summary);
  json["ends"] = summary.curve.ends;
  json["certified"] = summary.unresolved == 0;
  return json;
}

Json features_json(const Extraction& extraction, const FeatureSummaries& summaries) {
  Json json = Json::object();
  for (const Feature f : reading_order(extraction.requested)) {
    const FeatureRow& row = extraction.table.row(f);
    const FeatureSummary& summary = summaries[index(f)];
    json[row.name] = contains(extraction.curves, f) ? degenerate_curve_json(summary)
                     : summary.is_curve ? triple_curve_json(summary, extraction.spine_accuracy)
                                        : surface_json(summary);
  }
  return json;
}

Json domains_json(const DomainMesh& mesh) {
  Json json = Json::object();
  const auto volumes = domain_volumes_approx(mesh);
  for (std::size_t d = 0; d < kDomains; ++d) json[name_of(static_cast<Domain>(d))] = volumes[d];
  return json;
}

Json range_json(const Range& range) { return {range.lo, range.hi}; }

Json nodes_json(const Extraction& extraction) {
  Json json = Json::array();
  for (const Node& node : extraction.nodes) {
    Json enclosure = Json::array();
    for (const Range& range : node.enclosure) enclosure.push_back(range_json(range));
    json.push_back({{"position", node.position},
                    {"enclosure", enclosure},
                    {"eigenvalue", node.eigenvalue},
                    {"eigenvalue_enclosure", range_json(node.eigenvalue_enclosure)},
                    {"feature", extraction.table.row(node.feature).name},
                    {"status", name_of(node.status)},
                    {"tet", node.source_cell}});
  }
  return json;
}

Json nodes_undecided_json(const TensorField& field, const Extraction& extraction) {
  Json json = Json::array();
  for (const NodesUndecided& undecided : extraction.nodes_undecided) {
    json.push_back(
        {{"tet", field.source_cell(undecided.tet)}, {"reason", describe(undecided.obstacle)}});
  }
  return json;
}

/// Gives `take` the cells of a mesh with periodic copies of a point taken as that point.
template <std::size_t N, class Take>
auto with_copies_identified(const std::vector<std::array<std::uint32_t, N>>& cells,
                            const FeatureMesh& mesh, const Take& take) {
  if (mesh.identified.empty()) return take(cells);
  auto glued = cells;
  for (auto& cell : glued)
    for (std::uint32_t& v : cell) v = mesh.identified[v];
  return take(glued);
}

}  // namespace

FeatureSummaries summarize(const Extraction& extraction) {
  FeatureSummaries summaries(extraction.features.size());
  for (const Feature f : reading_order(extraction.requested)) {
    const FeatureMesh& mesh = extraction.mesh(f);
    FeatureSummary& summary = summaries[index(f)];
    summary.is_curve = f == Feature::TripleCurve || contains(extraction.curves, f);
    if (summary.is_curve) {
      summary.curve = with_copies_identified(mesh.segments, mesh, [&](const auto& segments) {
        return curve_topology(segments, mesh.points.size());
      });
      summary.measure = length_approx(mesh.points, mesh.segments);
    } else {
      summary.surface = with_copies_identified(mesh.triangles, mesh, [&](const auto& triangles) {
        return surface_topology(triangles, mesh.points.size());
      });
      summary.measure = area_approx(mesh.points, mesh.triangles);
      summary.angles = smallest_angles_approx(mesh.points, mesh.triangles);
    }
    summary.unresolved = static_cast<std::uint64_t>(
        std::count_if(extraction.unresolved.begin(), extraction.unresolved.end(),
                      [&](const UnresolvedTet& tet) { return contains(tet.features, f); }));
  }
  return summaries;
}

Json make_report(const ExtractRequest& request, const TensorField& field,
                 const Extraction& extraction, const FeatureSummaries& summaries,
                 const std::optional<RefinedMeshes>& refined, const QuadricChecks& quadrics,
                 const StepTiming& timing) {
  const CertificateCounts& proofs = extraction.certificates;
  const RefinementStatistics& refinement = extraction.refinement;
  const SignStages& stages = extraction.sign_stages;
  Json report;
  report["certified"] = extraction.certified();
  report["version"] = kVersion;
  report["field"] = field_json(request, field);
  report["options"] = options_json(request, extraction);
  report["certificates"] = {{"exclusion", proofs.exclusion},
                            {"graph", proofs.graph},
                            {"spine", proofs.spine},
                            {"radial", proofs.radial},
                            {"unresolved", proofs.unresolved}};
  report["refinement"] = {{"rounds", refinement.rounds},
                          {"bisections", refinement.bisections},
                          {"tets", refinement.tets}};
  report["contraction"] = {{"vertices", extraction.contraction.vertices},
                           {"largest_shift", extraction.contraction.moved},
                           {"reach", extraction.contraction.reach}};
  report["sign_stages"] = {
      {"filter", stages.filter}, {"interval", stages.interval}, {"exact", stages.exact}};
  if (extraction.curves != 0) report["symmetric"] = {{"shifted", extraction.curves_shifted}};
  report["features"] = features_json(extraction, summaries);
  if (refined) report["accuracy"] = accuracy_json(*refined);
  if (request.domains) report["domains"] = domains_json(extraction.domains);
  if (request.verify_quadrics) report["quadrics"] = quadrics_json(field, quadrics);
  report["nodes"] = nodes_json(extraction);
  report["nodes_undecided"] = nodes_undecided_json(field, extraction);
  report["isotropic_points"] = extraction.isotropic_points;
  report["identical"] = identical_json(extraction.identical);
  report["unresolved"] = unresolved_json(extraction);
  report["open_cells"] = {{"written", extraction.open_cells.tets.size()},
                          {"left_out", extraction.open_cells.left_out}};
  report["timing_s"] = {{"read", timing.read},
                        {"refine", extraction.timing.refine_s},
                        {"nodes", extraction.timing.nodes_s},
                        {"extract", extraction.timing.extract_s},
                        {"topology", timing.topology},
                        {"write", timing.write},
                        {"total", timing.total}};
  if (refined) report["timing_s"]["mesh"] = timing.mesh;
  if (request.verify_quadrics) report["timing_s"]["quadrics"] = timing.quadrics;
  if (extraction.curves != 0) report["timing_s"]["curves"] = extraction.timing.curves_s;
  const auto memory = resident_memory();
  report["peak_memory_bytes"] = memory ? Json(memory->peak) : Json(nullptr);
  return report;
}

namespace {

/// Nothing if no degenerate surface was asked for, or the tensors are symmetric.
std::string nodes_line(const Extraction& extraction) {
  const FeatureSet surfaces = extraction.requested & ~extraction.curves;
  if (!contains(surfaces, Feature::DegenerateLinear) &&
      !contains(surfaces, Feature::DegeneratePlanar))
    return {};
  const auto shared = std::ranges::count(extraction.nodes, NodeStatus::Shared, &Node::status);
  const std::size_t undecided = extraction.nodes_undecided.size();
  return fmt::format("nodes: {} ({} proven){}\n", extraction.nodes.size(),
                     extraction.nodes.size() - static_cast<std::size_t>(shared),
                     undecided == 0 ? "" : fmt::format("; {} tets undecided", undecided));
}

}  // namespace

std::string make_table(const Extraction& extraction, const FeatureSummaries& summaries) {
  constexpr std::string_view kLine = "{:<{}} {:>9} {:>9} {:>10} {:>6} {:>8} {:>12.6g} {:>10}\n";
  std::size_t width = 18;
  for (const std::string_view name : names_of(extraction.table, extraction.requested))
    width = std::max(width, name.size());
  std::string table =
      fmt::format("{:<{}} {:>9} {:>9} {:>10} {:>6} {:>8} {:>12} {:>10}\n", "feature", width,
                  "vertices", "cells", "components", "euler", "boundary", "area", "unresolved");
  const auto out = std::back_inserter(table);
  for (const Feature f : reading_order(extraction.requested)) {
    const FeatureSummary& summary = summaries[index(f)];
    const std::string& name = extraction.table.row(f).name;
    if (summary.is_curve) {
      const CurveTopology& c = summary.curve;
      fmt::format_to(out, kLine, name, width, c.vertices, c.segments, c.components,
                     static_cast<std::int64_t>(c.vertices) - static_cast<std::int64_t>(c.segments),
                     c.ends, summary.measure, summary.unresolved);
    } else {
      const SurfaceTopology& s = summary.surface;
      fmt::format_to(out, kLine, name, width, s.vertices, s.triangles, s.components, s.euler,
                     s.boundary_loops, summary.measure, summary.unresolved);
    }
  }
  if (const DomainMesh& domains = extraction.domains; domains.cells() > 0)
    fmt::format_to(out, "domains: {} cells, {} of them cut out by pages\n", domains.cells(),
                   domains.polyhedra());
  table += nodes_line(extraction);
  if (const std::size_t points = extraction.isotropic_points.size(); points > 0)
    fmt::format_to(out, "isotropic points: {}\n", points);
  table += identical_lines(extraction.identical);
  const std::size_t open = extraction.unresolved.size();
  if (open == 0) {
    fmt::format_to(out, "certified: every cell is decided\n");
  } else {
    fmt::format_to(out, "{} of the field's tets unresolved; report.json lists them\n", open);
  }
  return table;
}

}  // namespace triplex::cli

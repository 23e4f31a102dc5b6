// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "command.hpp"
#include "feature_list.hpp"
#include "reading_options.hpp"
#include "staged_directory.hpp"
#include "triplex/io/read_field.hpp"
#include "triplex/io/write_lines.hpp"
#include "triplex/quadric/quadric_steps.hpp"

namespace triplex::cli {
namespace {

struct QuadricRequest {
  std::string field, output;
  std::uint32_t tet = 0;
  int samples = 8;
  FeatureRequest features;
  ReadOptions reading;
};

void add_line(LineSet& set, const std::vector<Point>& points, bool closed) {
  auto& line = set.lines.emplace_back();
  for (const Point& x : points) {
    line.push_back(static_cast<std::uint32_t>(set.points.size()));
    set.points.push_back(x);
  }
  if (closed) line.push_back(line.front());
}

/// The edges of the triangles, each once.
void add_edges(LineSet& set, const std::vector<Point>& points,
               const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  for (const auto& [a, b] : edges) add_line(set, {points[a], points[b]}, false);
}

/// Parameters as points, to be looked at beside the tet: as large as it, through its middle, in a
/// plane across the y axis.
std::vector<Point> laid_out(const std::vector<std::array<double, 2>>& domain,
                            const std::array<Point, 4>& tet) {
  Point middle{};
  double size = 0, extent = 0;
  for (const Point& x : tet)
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] += x[k] / 4;
      for (const Point& y : tet) size = std::max(size, std::fabs(x[k] - y[k]));
    }
  std::array<double, 2> lo = domain.front(), hi = domain.front();
  for (const auto& p : domain)
    for (std::size_t k = 0; k < 2; ++k) {
      lo[k] = std::min(lo[k], p[k]);
      hi[k] = std::max(hi[k], p[k]);
      extent = std::max(extent, hi[k] - lo[k]);
    }
  const double scale = extent > 0 ? size / extent : 1;
  std::vector<Point> points;
  for (const auto& [u, v] : domain)
    points.push_back({middle[0] + scale * (u - (lo[0] + hi[0]) / 2), middle[1],
                      middle[2] + scale * (v - (lo[1] + hi[1]) / 2)});
  return points;
}

/// The one surface that is asked for.
FeatureRow chosen_row(const FeatureRequest& request) {
  const RequestedFeatures requested = resolve(request);
  if (std::popcount(requested.set) != 1)
    throw UsageError(
        "name one surface that is a quadric: --features balanced-linear (or none), --magnitude S, "
        "--isotropicity ETA or --traceless");
  return requested.table.row(static_cast<Feature>(std::countr_zero(requested.set)));
}

ExitCode run_quadric(const QuadricRequest& request) {
  const FeatureRow row = chosen_row(request.features);
  if (!quadric_of(row)) throw UsageError(row.name + " is no quadric");
  const TensorField field = read_field(request.field, request.reading);
  if (request.tet >= field.mesh.tets.size())
    throw UsageError(fmt::format("--tet {}: there are only {} tets, from 0 on", request.tet,
                                 field.mesh.tets.size()));
  const QuadricSteps steps = quadric_steps(field, TetId{request.tet}, row, request.samples);
  LineSet tet, curves, domain, mesh;
  std::array<Point, 4> corner;
  for (std::size_t i = 0; i < 4; ++i)
    corner[i] = field.mesh.points[index(field.mesh.tets[request.tet][i])];
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) add_line(tet, {corner[i], corner[j]}, false);
  std::size_t triangles = 0, loops = 0;
  for (const QuadricPatchSteps& patch : steps.patches) {
    const std::vector<Point> plane = laid_out(patch.domain, corner);
    for (const auto& curve : patch.curves) add_line(curves, curve, true);
    add_edges(domain, plane, patch.triangles);
    add_edges(mesh, patch.points, patch.triangles);
    triangles += patch.triangles.size();
    loops += patch.curves.size();
  }
  StagedDirectory directory(request.output);
  write_lines(directory.stage("tet.vtp"), tet);
  write_lines(directory.stage("curves.vtp"), curves);
  write_lines(directory.stage("parameters.vtp"), domain);
  write_lines(directory.stage("triangles.vtp"), mesh);
  directory.commit();
  fmt::print("{} of tet {}: {}{}; {} patches, {} curves, {} triangles\n", row.name, request.tet,
             name_of(steps.type), steps.transverse ? "" : " (a contact)", steps.patches.size(),
             loops, triangles);
  return ExitCode::Certified;
}

}  // namespace

void add_quadric(CLI::App& program, Action& action) {
  auto request = std::make_shared<QuadricRequest>();
  CLI::App* const command = program.add_subcommand(
      "quadric", "Show how a quadric surface is found in one tet, step by step.");
  add_reading_options(*command, request->field, request->reading);
  command->add_option("-o,--output", request->output, "Directory for the lines (.vtp)")
      ->required()
      ->type_name("DIR");
  command->add_option("--tet", request->tet, "Its number, from 0 on")->capture_default_str();
  command->add_option("--samples", request->samples, "Segments of each arc on a face")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  add_feature_options(*command, request->features);
  command->footer(
      "Examples:\n"
      "  triplex quadric flow.vtu --tet 17 --magnitude 2.5 --features none -o steps\n"
      "  triplex quadric flow.vtu --tet 17 --features balanced-linear -o steps");
  command->callback([request, &action] { action = [request] { return run_quadric(*request); }; });
}

}  // namespace triplex::cli

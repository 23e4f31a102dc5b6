// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command.hpp"
#include "field_statistics.hpp"
#include "field_warnings.hpp"
#include "reading_options.hpp"
#include "triplex/io/read_field.hpp"

namespace triplex::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoRequest {
  std::string field;
  ReadOptions reading;
  bool json = false;
};

// In the order of Classification::number.
constexpr std::array<std::string_view, 6> kDomains = {
    "inner-complex-linear", "outer-complex-linear", "real-linear",
    "real-planar",          "outer-complex-planar", "inner-complex-planar"};

double percent(std::uint64_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

Json to_json(const Range& range) {
  if (range.is_empty()) return nullptr;
  return {range.lo, range.hi};
}

// The keys that are about domains.
Json domains_json(const FieldStatistics& s) {
  Json domains = Json::object();
  Json volumes = Json::object();
  for (std::size_t k = 0; k < kDomains.size(); ++k) {
    domains[std::string(kDomains[k])] = s.at_vertices.sectors[k];
    volumes[std::string(kDomains[k])] = s.in_cells.volume_share_approx[k];
  }
  volumes["on_features"] = s.in_cells.volume_share_approx.back();
  return {{"domains", domains},
          {"domain_volume_approx", volumes},
          {"on_features", s.at_vertices.on_pages + s.at_vertices.on_spine}};
}

Json make_json(const InfoRequest& request, const TensorField& field, const FieldStatistics& s) {
  const VertexStatistics& v = s.at_vertices;
  Json json;
  json["file"] = request.field;
  json["tets"] = s.tets;
  json["vertices"] = s.vertices;
  json["array"] = field.array_name;
  json["split"] = {{"hexahedra", field.split.hexahedra},
                   {"wedges", field.split.wedges},
                   {"pyramids", field.split.pyramids}};
  json["box"] = {to_json(s.box[0]), to_json(s.box[1]), to_json(s.box[2])};
  json["magnitude"] = to_json(v.magnitude);
  json["trace"] = to_json(v.trace);
  json["p"] = to_json(v.p);
  json["q"] = to_json(v.q);
  json["discriminant"] = to_json(v.discriminant);
  json["isotropicity"] = to_json(v.isotropicity);
  json["mode"] = to_json(v.mode);
  json["trace_at_rounding_level"] = s.trace_is_rounding();
  json.update(domains_json(s));
  json["exact_zeros"] = {{"tensor", v.zero_tensors},
                         {"trace", s.vertices - v.nonzero_traces},
                         {"p", v.zero_p},
                         {"q", v.zero_q},
                         {"discriminant", v.zero_discriminant}};
  json["exact_kinds"] = {{"symmetric", v.symmetric},
                         {"triple_degenerate", v.on_spine},
                         {"nodes", v.nodes},
                         {"rank_one_deviators", v.rank_one_deviators},
                         {"multiples_of_identity", v.multiples_of_identity}};
  json["constant"] = {{"tets", s.in_cells.constant_tets},
                      {"vanishing_tets", s.in_cells.vanishing_tets},
                      {"faces", s.in_cells.constant_faces}};
  json["warnings"] = field_warnings(s);
  return json;
}

void print_range(std::string_view name, const Range& range) {
  if (range.is_empty()) {
    fmt::print("  {:<22} {:>14}\n", name, "nowhere");
  } else {
    fmt::print("  {:<22} {:>14.7g} .. {:.7g}\n", name, range.lo, range.hi);
  }
}

void print_count(std::string_view name, std::uint64_t count, std::size_t whole) {
  fmt::print("  {:<22} {:>10} {:>8.2f} %\n", name, count, percent(count, whole));
}

void print_ranges(const FieldStatistics& s) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    print_range(std::array{"x", "y", "z"}[axis], s.box[axis]);
  }
  const VertexStatistics& v = s.at_vertices;
  fmt::print("Ranges over the vertices (A is the deviator of T)\n");
  print_range("magnitude |T|", v.magnitude);
  print_range("trace tr T", v.trace);
  print_range("p = minor A", v.p);
  print_range("q = det A", v.q);
  print_range("D = -4 p^3 - 27 q^2", v.discriminant);
  print_range("isotropicity", v.isotropicity);
  print_range("mode, where finite", v.mode);
}

void print_domain(std::string_view name, std::uint64_t count, std::size_t whole, double volume) {
  fmt::print("  {:<22} {:>10} {:>8.2f} % {:>8.2f} %\n", name, count, percent(count, whole),
             100 * volume);
}

void print_domains(const FieldStatistics& s) {
  const VertexStatistics& v = s.at_vertices;
  fmt::print("Vertices by domain (certified), and their share of the volume (sampled)\n");
  for (std::size_t k = 0; k < kDomains.size(); ++k) {
    print_domain(kDomains[k], v.sectors[k], s.vertices, s.in_cells.volume_share_approx[k]);
  }
  print_domain("on a feature", v.on_pages + v.on_spine, s.vertices,
               s.in_cells.volume_share_approx.back());
}

void print_exact(const FieldStatistics& s) {
  const VertexStatistics& v = s.at_vertices;
  fmt::print("Exactly zero at so many vertices (certified)\n");
  print_count("T", v.zero_tensors, s.vertices);
  print_count("tr T", s.vertices - v.nonzero_traces, s.vertices);
  print_count("p", v.zero_p, s.vertices);
  print_count("q", v.zero_q, s.vertices);
  print_count("D", v.zero_discriminant, s.vertices);
  fmt::print("Exactly so at so many vertices (certified)\n");
  print_count("symmetric", v.symmetric, s.vertices);
  print_count("p = q = 0", v.on_spine, s.vertices);
  print_count("node", v.nodes, s.vertices);
  print_count("deviator of rank one", v.rank_one_deviators, s.vertices);
  print_count("multiple of identity", v.multiples_of_identity, s.vertices);
  fmt::print("Where the field is exactly constant\n");
  print_count("tets", s.in_cells.constant_tets, s.tets);
  print_count("tets where T = 0", s.in_cells.vanishing_tets, s.tets);
  fmt::print("  {:<22} {:>10}\n", "faces", s.in_cells.constant_faces);
}

void print_text(const InfoRequest& request, const TensorField& field, const FieldStatistics& s) {
  fmt::print("{}: {} tets, {} vertices, array '{}'\n", request.field, s.tets, s.vertices,
             field.array_name);
  print_ranges(s);
  print_domains(s);
  print_exact(s);
  for (const std::string& warning : field_warnings(s)) fmt::print("warning: {}\n", warning);
}

ExitCode run_info(const InfoRequest& request) {
  InputRepairs repairs;
  const TensorField field = read_field(request.field, request.reading, &repairs);
  const FieldStatistics statistics = field_statistics(field);
  if (request.json) {
    fmt::print("{}\n", make_json(request, field, statistics).dump(2));
  } else {
    fmt::print("{}", describe_reading(field.split, repairs));
    print_text(request, field, statistics);
  }
  return ExitCode::Certified;
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
  auto request = std::make_shared<InfoRequest>();
  CLI::App* const command = program.add_subcommand(
      "info", "Check a tensor field and say what is in it: ranges, domains, exact zeros.");
  add_reading_options(*command, request->field, request->reading);
  command->add_flag("--json", request->json, "As JSON, for programs");
  command->footer(
      "Examples:\n"
      "  triplex info flow.vtu\n"
      "  triplex info flow.vtu --tensor gradient --json");
  command->callback([request, &action] { action = [request] { return run_info(*request); }; });
}

}  // namespace triplex::cli

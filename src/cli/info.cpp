// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command.hpp"
#include "field_statistics.hpp"
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

Json to_json(const Range& range) { return {range.lo, range.hi}; }

Json make_json(const InfoRequest& request, const TensorField& field, const FieldStatistics& s) {
  Json json;
  json["file"] = request.field;
  json["tets"] = s.tets;
  json["vertices"] = s.vertices;
  json["array"] = field.array_name;
  json["split"] = {{"hexahedra", field.split.hexahedra},
                   {"wedges", field.split.wedges},
                   {"pyramids", field.split.pyramids}};
  json["box"] = {to_json(s.box[0]), to_json(s.box[1]), to_json(s.box[2])};
  json["magnitude"] = to_json(s.magnitude);
  json["trace"] = to_json(s.trace);
  json["p"] = to_json(s.p);
  json["q"] = to_json(s.q);
  json["discriminant"] = to_json(s.discriminant);
  json["trace_at_rounding_level"] = s.trace_is_rounding();
  Json& domains = json["domains"] = Json::object();
  for (std::size_t k = 0; k < kDomains.size(); ++k) {
    domains[std::string(kDomains[k])] = s.sectors[k];
  }
  json["on_features"] = s.on_pages + s.on_spine;
  json["exact_zeros"] = {{"trace", s.vertices - s.nonzero_traces},
                         {"p", s.zero_p},
                         {"q", s.zero_q},
                         {"discriminant", s.zero_discriminant}};
  return json;
}

void print_range(std::string_view name, const Range& range) {
  fmt::print("  {:<22} {:>14.7g} .. {:.7g}\n", name, range.lo, range.hi);
}

void print_count(std::string_view name, std::uint64_t count, std::size_t whole) {
  fmt::print("  {:<22} {:>10} {:>8.2f} %\n", name, count, percent(count, whole));
}

void print_ranges(const FieldStatistics& s) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    print_range(std::array{"x", "y", "z"}[axis], s.box[axis]);
  }
  fmt::print("Ranges over the vertices (A is the deviator of T)\n");
  print_range("magnitude |T|", s.magnitude);
  print_range("trace tr T", s.trace);
  print_range("p = minor A", s.p);
  print_range("q = det A", s.q);
  print_range("D = -4 p^3 - 27 q^2", s.discriminant);
  if (s.trace_is_rounding()) {
    fmt::print(
        "  warning: the trace is at the level of rounding; what depends on its sign has no "
        "meaning\n");
  }
}

void print_text(const InfoRequest& request, const TensorField& field, const FieldStatistics& s) {
  fmt::print("{}: {} tets, {} vertices, array '{}'\n", request.field, s.tets, s.vertices,
             field.array_name);
  print_ranges(s);
  fmt::print("Vertices by domain (certified)\n");
  for (std::size_t k = 0; k < kDomains.size(); ++k) {
    print_count(kDomains[k], s.sectors[k], s.vertices);
  }
  print_count("on a feature", s.on_pages + s.on_spine, s.vertices);
  fmt::print("Exactly zero at so many vertices (certified)\n");
  print_count("tr T", s.vertices - s.nonzero_traces, s.vertices);
  print_count("p", s.zero_p, s.vertices);
  print_count("q", s.zero_q, s.vertices);
  print_count("D", s.zero_discriminant, s.vertices);
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

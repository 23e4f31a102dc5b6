// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "command.hpp"
#include "field_statistics.hpp"
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

double fraction(std::uint64_t part, std::size_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

Json to_json(const Range& range) { return {range.lo, range.hi}; }

Json make_json(const InfoRequest& request, const TensorField& field, const FieldStatistics& s) {
  Json json;
  json["field"] = {{"file", request.field},
                   {"tets", s.tets},
                   {"vertices", s.vertices},
                   {"array", field.array_name},
                   {"bounds", {to_json(s.box[0]), to_json(s.box[1]), to_json(s.box[2])}}};
  json["ranges"] = {{"magnitude", to_json(s.magnitude)},
                    {"trace", to_json(s.trace)},
                    {"p", to_json(s.p)},
                    {"q", to_json(s.q)},
                    {"discriminant", to_json(s.discriminant)}};
  json["trace_is_rounding"] = s.trace_is_rounding();
  Json& domains = json["domain_fractions"] = Json::object();
  for (std::size_t k = 0; k < kDomains.size(); ++k) {
    domains[std::string(kDomains[k])] = fraction(s.sectors[k], s.vertices);
  }
  json["exact_zeros"] = {{"p", s.zero_p},
                         {"q", s.zero_q},
                         {"discriminant", s.zero_discriminant},
                         {"on_surfaces", s.on_pages},
                         {"on_triple_curve", s.on_spine}};
  return json;
}

void print_range(std::string_view name, const Range& range) {
  fmt::print("  {:<22} {:>14.7g} .. {:<14.7g}\n", name, range.lo, range.hi);
}

void print_trace_note(const FieldStatistics& s) {
  if (s.nonzero_traces == 0) {
    fmt::print("  the trace is exactly zero at every vertex\n");
  } else if (s.trace_is_rounding()) {
    fmt::print(
        "  warning: the trace is at the level of rounding; the field is trace-free in all but the\n"
        "  last bits, so what depends on the sign of the trace has no meaning\n");
  }
}

void print_text(const InfoRequest& request, const TensorField& field, const FieldStatistics& s) {
  fmt::print("{}\n  {:<22} {}\n  {:<22} {}\n  {:<22} {}\n", request.field, "tets", s.tets,
             "vertices", s.vertices, "tensor array", field.array_name);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    print_range(std::array{"x", "y", "z"}[axis], s.box[axis]);
  }
  fmt::print("Ranges over the vertices (A is the deviator)\n");
  print_range("magnitude |T|", s.magnitude);
  print_range("trace tr T", s.trace);
  print_range("p = minor A", s.p);
  print_range("q = det A", s.q);
  print_range("D = -4 p^3 - 27 q^2", s.discriminant);
  print_trace_note(s);
  fmt::print("Vertices by domain (certified)\n");
  for (std::size_t k = 0; k < kDomains.size(); ++k) {
    fmt::print("  {:<22} {:>10} {:>8.2f} %\n", kDomains[k], s.sectors[k],
               100 * fraction(s.sectors[k], s.vertices));
  }
  fmt::print("  {:<22} {:>10} {:>8.2f} %\n", "on a feature surface", s.on_pages,
             100 * fraction(s.on_pages, s.vertices));
  fmt::print("  {:<22} {:>10} {:>8.2f} %\n", "on the triple curve", s.on_spine,
             100 * fraction(s.on_spine, s.vertices));
  fmt::print("Exact zeros (certified)\n  {:<22} {:>10}\n  {:<22} {:>10}\n  {:<22} {:>10}\n", "p = 0",
             s.zero_p, "q = 0", s.zero_q, "D = 0", s.zero_discriminant);
}

ExitCode run_info(const InfoRequest& request) {
  const TensorField field = read_field(request.field, request.reading);
  const FieldStatistics statistics = field_statistics(field);
  if (request.json) {
    fmt::print("{}\n", make_json(request, field, statistics).dump(2));
  } else {
    print_text(request, field, statistics);
  }
  return ExitCode::Certified;
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
  auto request = std::make_shared<InfoRequest>();
  CLI::App* const command = program.add_subcommand(
      "info", "Check a tensor field and say what is in it: ranges, domains, exact zeros.");
  command->add_option("FIELD", request->field, "Tensor field: .vtu, .pvtu or legacy .vtk")
      ->required();
  command->add_option("--tensor", request->reading.tensor_name,
                      "Name of the point array with 9 components; needed if there are several")
      ->type_name("NAME");
  command->add_flag("--merge-points", request->reading.merge_points,
                    "Make one point of points with equal coordinates and tensors");
  command->add_flag("--fix-orientation", request->reading.fix_orientation,
                    "Turn tets of negative volume around");
  command->add_flag("--json", request->json, "As JSON, for programs");
  command->footer(
      "Examples:\n"
      "  triplex info flow.vtu\n"
      "  triplex info flow.vtu --tensor gradient --json");
  command->callback([request, &action] { action = [request] { return run_info(*request); }; });
}

}  // namespace triplex::cli

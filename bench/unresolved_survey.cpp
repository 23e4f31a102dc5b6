// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the main job leaves unresolved, all six surfaces and the curve: random linear fields, white
// noise, the generated flows on regular and jittered grids, and files. Prints a Markdown table, one
// row per family of fields, and what stopped the unresolved tets. Everything but the times is the
// same in every run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/read_field.hpp"

namespace triplex {
namespace {

std::vector<std::string> all_parts() {
  return {"tet", "cube", "noise", "lorenz", "abc", "rayleigh-benard"};
}
constexpr double kJitter = 0.2;

struct SurveyOptions {
  std::vector<std::string> parts, files;
  std::vector<int> sizes;
  std::string tensor;
  std::uint64_t tet_fields = 10'000, cube_fields = 1'000;
  ExtractionOptions extraction;
};

/// Sums over the fields of one family.
struct Summary {
  std::uint64_t fields = 0, with_unresolved = 0, without_node = 0, tets = 0, unresolved = 0,
                leaves = 0;
  std::uint64_t bisections = 0, nodes = 0, tets_with_node = 0, nodes_undecided = 0;
  double seconds = 0;
  std::map<std::string, std::uint64_t> reasons;  // unresolved tets by what stopped them
  std::array<std::uint64_t, kStandardFeatures> by_feature{};

  void add(const TensorField& field, const ExtractionOptions& options);
};

/// The reason without the budget, which is the same everywhere.
std::string without_limit(const std::string& reason) { return reason.substr(0, reason.rfind(';')); }

void Summary::add(const TensorField& field, const ExtractionOptions& options) {
  const Extraction result = extract(field, options);
  ++fields;
  with_unresolved += !result.certified();
  without_node += !result.certified() && result.nodes.empty();
  tets += field.mesh.tets.size();
  unresolved += result.unresolved.size();
  leaves += result.refinement.tets;
  bisections += result.refinement.bisections;
  nodes += result.nodes.size();
  nodes_undecided += result.nodes_undecided.size();
  seconds += result.timing.refine_s + result.timing.nodes_s + result.timing.extract_s;
  for (const UnresolvedTet& tet : result.unresolved) {
    ++reasons[without_limit(tet.reason)];
    tets_with_node += tet.reason.starts_with("contains a node");
    for (std::size_t f = 0; f < by_feature.size(); ++f)
      by_feature[f] += contains(tet.features, static_cast<Feature>(f));
  }
}

void print_head() {
  fmt::print(
      "| fields | number | with unresolved | and no node | tets | unresolved tets | of these with "
      "a node | "
      "leaves | bisections | nodes | tets with nodes undecided | seconds |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
}

void print(const std::string& name, const Summary& s) {
  fmt::print("| {} | {} | {} | {} | {} | {} ({:.3g} %) | {} | {} | {} | {} | {} | {:.2f} |\n", name,
             s.fields, s.with_unresolved, s.without_node, s.tets, s.unresolved,
             100 * static_cast<double>(s.unresolved) / static_cast<double>(s.tets),
             s.tets_with_node, s.leaves, s.bisections, s.nodes, s.nodes_undecided, s.seconds);
  std::fflush(stdout);
}

void print_reasons(const std::vector<std::pair<std::string, Summary>>& rows) {
  fmt::print("\nWhat stopped the unresolved tets, and on which features:\n\n");
  for (const auto& [name, summary] : rows) {
    if (summary.unresolved == 0) continue;
    fmt::print("- {}\n", name);
    for (const auto& [reason, count] : summary.reasons) fmt::print("  - {}: {}\n", count, reason);
    std::string features;
    for (std::size_t f = 0; f < summary.by_feature.size(); ++f)
      if (summary.by_feature[f] > 0)
        features += fmt::format("{}{} {}", features.empty() ? "" : ", ",
                                standard_features().rows()[f].name, summary.by_feature[f]);
    fmt::print("  - {}\n", features);
  }
}

struct Family {
  std::string name;
  std::uint64_t fields = 1;
  std::function<TensorField(std::uint64_t seed)> make;
};

void add_generated(const SurveyOptions& options, const std::string& part,
                   std::vector<Family>& families) {
  const GeneratorRow* generator = generator_named(part);
  const std::vector<int> noise_sizes = {10, 20}, flow_sizes = {8, 9, 12, 16, 17, 24, 32};
  const bool noise = part == "noise";
  for (const int n : !options.sizes.empty() ? options.sizes : noise ? noise_sizes : flow_sizes)
    for (const double jitter : {0.0, kJitter}) {
      if (noise && jitter > 0) continue;  // invariants do not see the shapes of tets
      families.push_back({fmt::format("{}, n = {}{}", part, n, jitter > 0 ? ", jittered" : ""), 1,
                          [generator, n, jitter](std::uint64_t seed) {
                            GridOptions grid;
                            grid.n = n;
                            grid.jitter = jitter;
                            grid.seed = seed;
                            return generator->generate(grid);
                          }});
    }
}

std::vector<Family> families_of(const SurveyOptions& options) {
  std::vector<Family> families;
  for (const std::string& part : options.parts) {
    if (part == "tet") {
      families.push_back({"random, one tet", options.tet_fields, generate_noise_on_tet});
    } else if (part == "cube") {
      families.push_back(
          {"random linear, cube of 6 tets", options.cube_fields, [](std::uint64_t seed) {
             GridOptions grid;
             grid.n = 1;
             grid.seed = seed;
             return generate_random_linear(grid);
           }});
    } else {
      add_generated(options, part, families);
    }
  }
  for (const std::string& file : options.files)
    families.push_back({std::filesystem::path(file).stem().string(), 1,
                        [file, tensor = options.tensor](std::uint64_t) {
                          return read_field(file, {.tensor_name = tensor});
                        }});
  return families;
}

/// False if a field could not be made.
bool run(const SurveyOptions& options) {
  std::vector<std::pair<std::string, Summary>> rows;
  bool all = true;
  print_head();
  for (const Family& family : families_of(options)) {
    Summary summary;
    try {
      for (std::uint64_t seed = 1; seed <= family.fields; ++seed)
        summary.add(family.make(seed), options.extraction);
    } catch (const BadInput& e) {
      fmt::print(stderr, "{}: {}\n", family.name, e.what());
      all = false;
      continue;
    }
    print(family.name, summary);
    rows.emplace_back(family.name, std::move(summary));
  }
  print_reasons(rows);
  return all;
}

}  // namespace
}  // namespace triplex

int main(int argc, char** argv) {
  triplex::SurveyOptions options;
  options.extraction.threads = 1;
  CLI::App app("What extraction leaves unresolved");
  app.add_option("files", options.files, "fields to survey");
  app.add_option("--part", options.parts, "families of generated fields; all if no file is given")
      ->check(CLI::IsMember(triplex::all_parts()));
  app.add_option("--n", options.sizes, "cells per axis of generated fields")
      ->check(CLI::Range(1, 800));
  app.add_option("--tet-fields", options.tet_fields, "number of random fields on one tet")
      ->capture_default_str();
  app.add_option("--cube-fields", options.cube_fields, "number of random linear fields on a cube")
      ->capture_default_str();
  app.add_option("--tensor", options.tensor, "name of the point array of the tensors");
  app.add_option("--max-bisections", options.extraction.max_bisections,
                 "bisections that one tet may ask for");
  app.add_option("--threads", options.extraction.threads, "threads of each extraction; 0: all")
      ->capture_default_str();
  try {
    CLI11_PARSE(app, argc, argv);
    if (options.parts.empty() && options.files.empty()) options.parts = triplex::all_parts();
    return triplex::run(options) ? 0 : 1;
  } catch (const std::exception& e) {
    fmt::print(stderr, "unresolved_survey: {}\n", e.what());
    return 1;
  }
}

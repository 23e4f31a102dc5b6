// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floating-point A-patches: what an empty tet costs over its coefficients, and the seconds of each
// feature against those of the certified extraction, in one process and by turns. Prints Markdown
// tables. Reading is left out on both sides.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <exception>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "baseline/form_ranges.hpp"
#include "baseline/tet_coefficients.hpp"
#include "median.hpp"
#include "triplex/baseline/a_patches.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/read_field.hpp"

namespace triplex {
namespace {

struct BenchOptions {
  std::vector<std::string> files, generators = {"abc", "lorenz"};
  std::string tensor;
  std::vector<int> sizes = {13, 44, 63};
  int repeats = 5, max_depth = APatchOptions{}.max_depth;
  unsigned threads = 0;
};

template <class Run>
double seconds_of(const Run& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

using Tensors = std::array<Tensor<double>, 4>;

std::vector<Tensors> deviators_of(const TensorField& field) {
  std::vector<Tensors> tets;
  for (const auto& tet : field.mesh.tets) {
    Tensors a;
    for (std::size_t i = 0; i < 4; ++i) a[i] = triple_deviator(field.tensors[index(tet[i])]);
    tets.push_back(a);
  }
  return tets;
}

/// Keeps the optimiser from dropping what is timed.
template <class Value>
void keep(const Value& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Kept out of line, so that both sides of the comparison run the same code.
template <class Evaluate>
[[gnu::noinline]] auto evaluated(const Evaluate& evaluate, const Tensors& a) {
  return evaluate(a);
}

/// Nanoseconds per tet of `evaluate`, and of it with the test for one sign on what it returns.
template <class Evaluate>
std::array<double, 2> nanoseconds(const std::vector<Tensors>& tets, int repeats,
                                  const Evaluate& evaluate) {
  std::array<std::vector<double>, 2> times;
  for (int i = 0; i <= repeats; ++i) {
    const double plain = seconds_of([&] {
      for (const Tensors& a : tets) keep(evaluated(evaluate, a));
    });
    const double tested = seconds_of([&] {
      for (const Tensors& a : tets) keep(baseline::has_one_sign(evaluated(evaluate, a)));
    });
    if (i == 0) continue;
    times[0].push_back(plain * 1e9 / static_cast<double>(tets.size()));
    times[1].push_back(tested * 1e9 / static_cast<double>(tets.size()));
  }
  return {median(times[0]), median(times[1])};
}

void print_cost(const char* what, const std::array<double, 2>& ns) {
  fmt::print("| {} | {:.0f} | {:.0f} | {:.2f} |\n", what, ns[0], ns[1], ns[1] / ns[0]);
}

void print_empty_tets(int repeats) {
  GridOptions grid;
  grid.n = 20;
  const TensorField field = generate_constant(grid);
  const auto tets = deviators_of(field);
  const auto forms = [](const Tensors& a) { return forms_of<double, 4>(a); };
  fmt::print(
      "An empty tet, one core, nanoseconds per tet, medians.\n\n"
      "| | coefficients | and the test for one sign | ratio |\n|---|---:|---:|---:|\n");
  print_cost("degree 2 (10)", nanoseconds(tets, repeats, [](const Tensors& a) {
               std::array<double, 10> p;
               for (std::size_t n = 0; n < p.size(); ++n)
                 p[n] = minus_trace_of_product(a[pairs<4>()[n][0]], a[pairs<4>()[n][1]]);
               return p;
             }));
  print_cost("degree 3 (20, and the 10 of degree 2)",
             nanoseconds(tets, repeats, [&](const Tensors& a) { return forms(a).q; }));
  print_cost("degree 6 (84, and the 30 it is made of)",
             nanoseconds(tets, repeats, [&](const Tensors& a) {
               return baseline::sextic_coefficients(forms(a), {});
             }));
  std::vector<double> whole;
  APatchOptions options;
  options.threads = 1;
  for (int i = 0; i < repeats; ++i) whole.push_back(extract_a_patches(field, options).seconds);
  fmt::print(
      "\nAll seven features of a field without any, everything included: {:.0f} ns per tet.\n\n",
      median(whole) * 1e9 / static_cast<double>(tets.size()));
}

struct Row {
  std::string name;
  FeatureSet features;
};

std::vector<Row> rows() {
  std::vector<Row> result;
  for (const FeatureRow& row : standard_features().rows())
    result.push_back({row.name, bit(row.feature)});
  result.push_back({"all seven", kStandardSet});
  return result;
}

std::size_t tets_of(const std::vector<GivenUp>& places) {
  std::set<std::int64_t> cells;
  for (const GivenUp& place : places) cells.insert(place.source_cell);
  return cells.size();
}

void compare(const std::string& name, const TensorField& field, const BenchOptions& options) {
  for (const Row& row : rows()) {
    ExtractionOptions robust;
    APatchOptions growth;
    robust.features = growth.features = row.features;
    robust.threads = growth.threads = options.threads;
    growth.max_depth = options.max_depth;
    APatchOptions layers = growth;
    layers.patch_test = PatchTest::Layers;
    std::vector<double> robust_s, growth_s, layers_s;
    std::size_t unresolved = 0;
    std::array<std::size_t, 2> given_up{};
    for (int i = 0; i <= options.repeats; ++i) {
      const double r = seconds_of([&] { unresolved = extract(field, robust).unresolved.size(); });
      const double g =
          seconds_of([&] { given_up[0] = tets_of(extract_a_patches(field, growth).given_up); });
      const double l =
          seconds_of([&] { given_up[1] = tets_of(extract_a_patches(field, layers).given_up); });
      if (i == 0) continue;  // warms up both sides
      robust_s.push_back(r);
      growth_s.push_back(g);
      layers_s.push_back(l);
    }
    fmt::print("| {} | {} | {} | {:.3f} | {} | {:.3f} | {} | {:.3f} | {} | {:.2f} | {:.2f} |\n",
               name, field.mesh.tets.size(), row.name, median(robust_s), unresolved,
               median(growth_s), given_up[0], median(layers_s), given_up[1],
               median(robust_s) / median(growth_s), median(robust_s) / median(layers_s));
    std::fflush(stdout);
  }
}

int run(const BenchOptions& options) {
  print_empty_tets(options.repeats);
  fmt::print(
      "Seconds, medians; A-patches halve at most {} times. The ratios are certified / "
      "A-patches.\n\n"
      "| field | tets | features | certified | unresolved tets | A-patches | tets given up | "
      "A-patches, layers only | tets given up | ratio | ratio, layers only |\n"
      "|---|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      options.max_depth);
  for (const std::string& name : options.generators) {
    const GeneratorRow* generator = generator_named(name);
    if (generator == nullptr) throw BadInput("no generator is called " + name);
    for (const int n : options.sizes) {
      GridOptions grid;
      grid.n = n;
      compare(fmt::format("{}, n = {}", name, n), generator->generate(grid), options);
    }
  }
  for (const std::string& file : options.files)
    compare(std::filesystem::path(file).stem().string(),
            read_field(file, {.tensor_name = options.tensor}), options);
  return 0;
}

}  // namespace
}  // namespace triplex

int main(int argc, char** argv) {
  triplex::BenchOptions options;
  CLI::App app("Floating-point A-patches against the certified extraction");
  app.add_option("files", options.files, "fields to measure besides the generated ones");
  app.add_option("--tensor", options.tensor, "name of the point array of the tensors");
  app.add_option("--generate", options.generators, "generators of the fields of --n");
  app.add_option("--n", options.sizes, "cells per axis of generated fields");
  app.add_option("--repeats", options.repeats, "timed runs of each side")->check(CLI::Range(1, 99));
  app.add_option("--threads", options.threads, "0: all cores")->capture_default_str();
  app.add_option("--max-depth", options.max_depth, "halvings of a tet, at most")
      ->check(CLI::Range(0, 60));
  try {
    CLI11_PARSE(app, argc, argv);
    return triplex::run(options);
  } catch (const std::exception& e) {
    fmt::print(stderr, "baseline_bench: {}\n", e.what());
    return 1;
  }
}

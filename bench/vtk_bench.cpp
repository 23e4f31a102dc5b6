// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The main job, all six surfaces and the curve, against three uncertified contours of VTK (p, q and
// D = 0, sampled at the vertices), in one process and by turns. With --scaling: time, memory and
// decisions of the main job by size. Prints Markdown tables. Reading is left out on both sides.
#include <fmt/format.h>
#include <vtkSMP.h>  // not vtkSMPTools.h, which is not C++20

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "median.hpp"
#include "sampled_grid.hpp"
#include "scaling.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/io/read_field.hpp"
#include "vtk_contours.hpp"

namespace triplex {
namespace {

struct BenchOptions {
  std::vector<std::string> files;
  std::string tensor, generator = "abc";
  std::vector<int> sizes;
  int repeats = 5;
  bool scaling = false;
};

double seconds_of_sampling(const TensorField& field, vtkUnstructuredGrid& grid) {
  const auto start = std::chrono::steady_clock::now();
  sample_invariants(field, grid);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

void print_comparison_head() {
  fmt::print(
      "VTK's parallel backend: {}, {} cores. Seconds, medians; m: points merged, s: triangle "
      "soup.\n\n"
      "| field | tets | Triplex, 2 threads (refine + extract) | 1 thread | sampling p, q, D | VTK "
      "m "
      "| VTK s | VTK m, parallel | triangles, Triplex / VTK | 2 threads / VTK m | 1 thread / VTK "
      "m "
      "| best / best |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
      VTK_SMP_BACKEND, std::thread::hardware_concurrency());
}

std::size_t triangles_of(const Extraction& result) {
  std::size_t triangles = 0;
  for (const FeatureMesh& mesh : result.features) triangles += mesh.triangles.size();
  return triangles;
}

void compare(const BenchField& named, int repeats) {
  const TensorField field = named.load();
  const auto grid = contour_grid(field);
  std::vector<double> two, refine_two, extract_two, one, sampling, merged, soup, parallel;
  std::size_t ours = 0, theirs = 0;
  for (int i = 0; i <= repeats; ++i) {
    const double sampled = seconds_of_sampling(field, *grid);
    const Extraction with_two = extract(field, with_threads(2));
    const ContourRun m = run_contours(*grid, {});
    const ExtractionTiming with_one = extract(field, with_threads(1)).timing;
    const ContourRun s = run_contours(*grid, {.merge_points = false});
    const ContourRun mp = run_contours(*grid, {.sequential = false});
    ours = triangles_of(with_two);
    theirs = m.triangles;
    if (i == 0) continue;  // warms up both sides
    refine_two.push_back(with_two.timing.refine_s);
    extract_two.push_back(with_two.timing.extract_s);
    two.push_back(with_two.timing.refine_s + with_two.timing.extract_s);
    one.push_back(with_one.refine_s + with_one.extract_s);
    sampling.push_back(sampled);
    merged.push_back(m.seconds);
    soup.push_back(s.seconds);
    parallel.push_back(mp.seconds);
  }
  const auto least = [](const std::vector<double>& v) {
    return *std::min_element(v.begin(), v.end());
  };
  fmt::print(
      "| {} | {} | {:.3f} ({:.3f} + {:.3f}) | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | "
      "{} / {} | {:.1f} | {:.1f} | {:.1f} |\n",
      named.name, field.mesh.tets.size(), median(two), median(refine_two), median(extract_two),
      median(one), median(sampling), median(merged), median(soup), median(parallel), ours, theirs,
      median(two) / median(merged), median(one) / median(merged), least(two) / least(merged));
  std::fflush(stdout);
}

std::vector<BenchField> fields_of(const BenchOptions& options) {
  std::vector<BenchField> fields;
  const GeneratorRow* generator = generator_named(options.generator);
  if (generator == nullptr) throw BadInput("no generator is called " + options.generator);
  for (const int n : options.sizes)
    fields.push_back({fmt::format("{}, n = {}", generator->name, n), [generator, n] {
                        GridOptions grid;
                        grid.n = n;
                        return generator->generate(grid);
                      }});
  for (const std::string& file : options.files)
    fields.push_back({std::filesystem::path(file).stem().string(), [file, tensor = options.tensor] {
                        return read_field(file, {.tensor_name = tensor});
                      }});
  return fields;
}

int run(BenchOptions options) {
  if (options.sizes.empty() && options.files.empty())
    options.sizes = options.scaling ? std::vector{13, 26, 44, 63, 100} : std::vector{63};
  const auto fields = fields_of(options);
  if (!options.scaling) {
    print_comparison_head();
    for (const BenchField& field : fields) compare(field, options.repeats);
    return 0;
  }
  print_scaling_head();
  bool all = true;
  for (const BenchField& field : fields) all &= print_scaling_row(field, options.repeats);
  return all ? 0 : 1;
}

}  // namespace
}  // namespace triplex

int main(int argc, char** argv) {
  triplex::BenchOptions options;
  CLI::App app("Triplex against VTK's contours; time and memory by size");
  app.add_option("files", options.files, "fields to measure besides the generated ones");
  app.add_option("--tensor", options.tensor, "name of the point array of the tensors");
  app.add_option("--generate", options.generator, "generator of the fields of --n")
      ->capture_default_str();
  app.add_option("--n", options.sizes, "cells per axis of generated fields");
  app.add_option("--repeats", options.repeats, "timed runs of each side")->check(CLI::Range(1, 99));
  app.add_flag("--scaling", options.scaling, "time, memory and decisions by size, without VTK");
  try {
    CLI11_PARSE(app, argc, argv);
    return triplex::run(options);
  } catch (const std::exception& e) {
    fmt::print(stderr, "vtk_bench: {}\n", e.what());
    return 1;
  }
}

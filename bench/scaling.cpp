// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scaling.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "median.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/io/resident_memory.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

struct Row {
  double tets = 0, leaves = 0, bisections = 0, bisected = 0, unresolved = 0;
  double refine_s = 0, extract_s = 0, one_thread_s = 0, bytes = 0;
  SignStages stages;
};

/// Tets of the input that the refinement cut, by its own bisections or by those of neighbours.
double count_bisected(const TensorField& field) {
  RefineOptions options;
  options.max_tets = default_size_limit(field.mesh.tets.size());
  const RefinedComplex complex = refine(field, options);
  std::vector<std::uint8_t> parts(field.mesh.tets.size(), 0);
  for (const Leaf& leaf : complex.leaves)
    parts[index(leaf.input)] = static_cast<std::uint8_t>(std::min(2, parts[index(leaf.input)] + 1));
  return static_cast<double>(std::count(parts.begin(), parts.end(), 2));
}

Row measure(const TensorField& field, int repeats) {
  Row row;
  row.tets = static_cast<double>(field.mesh.tets.size());
  const bool peak_known = restart_memory_peak();
  const auto before = resident_memory();
  {
    const Extraction result = extract(field, with_threads(2));
    const auto after = resident_memory();
    row.bytes = peak_known && before && after ? static_cast<double>(after->peak - before->now)
                                              : std::nan("");
    row.leaves = static_cast<double>(result.refinement.tets);
    row.bisections = static_cast<double>(result.refinement.bisections);
    row.unresolved = static_cast<double>(result.unresolved.size());
    row.stages = result.sign_stages;
  }
  std::vector<double> refine_s, extract_s, one_thread_s;
  for (int i = 0; i < repeats; ++i) {
    const ExtractionTiming two = extract(field, with_threads(2)).timing;
    refine_s.push_back(two.refine_s);
    extract_s.push_back(two.extract_s);
    const ExtractionTiming one = extract(field, with_threads(1)).timing;
    one_thread_s.push_back(one.refine_s + one.extract_s);
  }
  row.refine_s = median(refine_s);
  row.extract_s = median(extract_s);
  row.one_thread_s = median(one_thread_s);
  row.bisected = count_bisected(field);
  return row;
}

void print(const std::string& name, const Row& r) {
  const double decisions =
      static_cast<double>(r.stages.filter + r.stages.interval + r.stages.exact);
  const auto share = [&](std::uint64_t n) { return 100 * static_cast<double>(n) / decisions; };
  fmt::print(
      "| {} | {:.0f} | {:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.0f} | {:.2f} | {:.0f} | "
      "{:.3f} | {:.0f} ({:.3g} %) | {:.2f} / {:.2g} / {:.2g} |\n",
      name, r.tets, r.refine_s, r.extract_s, r.one_thread_s,
      1e6 * (r.refine_s + r.extract_s) / r.tets, r.bytes / r.tets, r.leaves / r.tets, r.bisections,
      100 * r.bisected / r.tets, r.unresolved, 100 * r.unresolved / r.tets, share(r.stages.filter),
      share(r.stages.interval), share(r.stages.exact));
  std::fflush(stdout);
}

}  // namespace

void print_scaling_head() {
  fmt::print(
      "| field | tets | refine, s | extract, s | both, 1 thread, s | us/tet | bytes/tet | "
      "leaves/tet "
      "| bisections | tets cut, % | unresolved | filter / interval / exact, % |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n");
  std::fflush(stdout);
}

bool print_scaling_row(const BenchField& field, int repeats) {
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    int status = 0;
    try {
      const TensorField loaded = field.load();
      print(field.name, measure(loaded, repeats));
    } catch (const std::exception& e) {
      fmt::print(stderr, "{}: {}\n", field.name, e.what());
      status = 1;
    }
    std::_Exit(status);
  }
  int status = 0;
  return waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace triplex

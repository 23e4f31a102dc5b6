// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speed of the main job and of its innermost steps, on the ABC flow. Items are tets, so
// items_per_second is tets per second. `--large` adds the mesh of 1.5M tets.
#include <benchmark/benchmark.h>

#include <cstring>
#include <map>
#include <vector>

#include "triplex/arithmetic/interval.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/certify/cell.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {
namespace {

const TensorField& abc(int n) {
  static std::map<int, TensorField> fields;
  auto found = fields.find(n);
  if (found == fields.end()) {
    GridOptions grid;
    grid.n = n;
    found = fields.emplace(n, generate_abc(grid)).first;
  }
  return found->second;
}

void count_tets(benchmark::State& state, std::size_t tets) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(tets));
}

/// Arguments: grid cells per axis, threads.
void extract_abc(benchmark::State& state) {
  const TensorField& field = abc(static_cast<int>(state.range(0)));
  ExtractionOptions options;
  options.threads = static_cast<unsigned>(state.range(1));
  for (auto _ : state) benchmark::DoNotOptimize(extract(field, options));
  count_tets(state, field.mesh.tets.size());
}

/// Certificates of all features on every tet of the unrefined mesh, one thread.
void certify_cells(benchmark::State& state) {
  const TensorField& field = abc(13);
  RefineOptions unrefined;
  unrefined.max_bisections = 0;
  const RefinedComplex complex = refine(field, unrefined);
  for (auto _ : state) {
    SignStages stages;
    for (const Leaf& leaf : complex.leaves) {
      benchmark::DoNotOptimize(certify_cell(complex.field, leaf.vertices, complex.sectors,
                                            standard_features(), kStandardSet, nullptr,
                                            stages));
    }
  }
  count_tets(state, complex.leaves.size());
}

/// The 30 Bernstein coefficients of p and q on every tet, one thread.
template <class NT>
void forms_of_tets(benchmark::State& state) {
  const TensorField& field = abc(13);
  std::vector<std::array<Tensor<NT>, 4>> tets;
  for (const auto& tet : field.mesh.tets) {
    auto& vertices = tets.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const Tensor<double> a = triple_deviator(field.tensors[index(tet[i])]);
      for (int k = 0; k < 9; ++k) vertices[i][k] = NT(a[k]);
    }
  }
  for (auto _ : state) {
    for (const auto& vertices : tets) benchmark::DoNotOptimize(forms_of<NT, 4>(vertices));
  }
  count_tets(state, tets.size());
}

void interval_forms_of_tets(benchmark::State& state) {
  const IntervalRounding upward;
  forms_of_tets<Interval>(state);
}

void register_all(bool large) {
  for (const int n : {13, 44, 63}) {
    if (n == 63 && !large) continue;
    for (const int threads : {1, 2}) {
      benchmark::RegisterBenchmark("extract_abc", extract_abc)
          ->Args({n, threads})
          ->ArgNames({"n", "threads"})
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime();
    }
  }
  benchmark::RegisterBenchmark("certify_cells", certify_cells)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("forms_of_tets/double", forms_of_tets<double>)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("forms_of_tets/interval", interval_forms_of_tets)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("forms_of_tets/exact", forms_of_tets<Exact>)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace triplex

int main(int argc, char** argv) {
  bool large = false;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--large") == 0) {
      large = true;
    } else {
      argv[kept++] = argv[i];
    }
  }
  benchmark::Initialize(&kept, argv);
  if (benchmark::ReportUnrecognizedArguments(kept, argv)) return 1;
  triplex::register_all(large);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

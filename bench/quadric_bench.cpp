// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Speed of the quadric road: balanced surface of the ABC flow, level sets of the convection. Items
// are tets. Arguments: grid cells per axis, segments per arc, threads.
#include <benchmark/benchmark.h>

#include <map>

#include "triplex/field/generators.hpp"
#include "triplex/quadric/quadric_extraction.hpp"

namespace triplex {
namespace {

const TensorField& field_of(bool flow, int n) {
  static std::map<std::pair<bool, int>, TensorField> fields;
  const auto found = fields.find({flow, n});
  if (found != fields.end()) return found->second;
  GridOptions grid;
  grid.n = n;
  return fields
      .emplace(std::pair{flow, n}, flow ? generate_abc(grid) : generate_rayleigh_benard(grid))
      .first->second;
}

void run(benchmark::State& state, bool flow, const FeatureRow& row) {
  const TensorField& field = field_of(flow, static_cast<int>(state.range(0)));
  QuadricOptions options;
  options.samples = static_cast<int>(state.range(1));
  options.threads = static_cast<unsigned>(state.range(2));
  std::size_t triangles = 0, pieces = 0;
  for (auto _ : state) {
    const QuadricExtraction result = extract_quadric(field, row, options);
    triangles = result.mesh.triangles.size();
    pieces = result.pieces.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["active_tets"] = static_cast<double>(pieces);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(field.mesh.tets.size()));
}

void balanced(benchmark::State& state) {
  run(state, true, standard_features().row(Feature::BalancedLinear));
}
void magnitude(benchmark::State& state) {
  FeatureTable table;
  run(state, false, table.row(table.add_magnitude(2)));
}
void isotropicity(benchmark::State& state) {
  FeatureTable table;
  run(state, false, table.row(table.add_isotropicity(0.1)));
}

#define QUADRIC_BENCH(name)           \
  BENCHMARK(name)                     \
      ->Args({63, 2, 0})              \
      ->Args({63, 4, 0})              \
      ->Args({63, 4, 1})              \
      ->Unit(benchmark::kMillisecond) \
      ->UseRealTime()
QUADRIC_BENCH(balanced);
QUADRIC_BENCH(magnitude);
QUADRIC_BENCH(isotropicity);

}  // namespace
}  // namespace triplex

BENCHMARK_MAIN();

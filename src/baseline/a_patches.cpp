// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/baseline/a_patches.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "tet_worker.hpp"
#include "triplex/arithmetic/fp_environment.hpp"

namespace triplex {
namespace {

using baseline::Findings;
using baseline::MeshBuilder;
using baseline::SheetPlan;
using baseline::Task;

constexpr std::size_t kRun = 8192;  // tets per part; parts are joined in order

class Stopwatch {
 public:
  double seconds() const {
    const std::chrono::duration<double> d = std::chrono::steady_clock::now() - start_;
    return d.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void check(const APatchOptions& options) {
  if (options.max_depth < 0 || options.max_depth > 60)
    throw std::invalid_argument("max_depth must be in [0, 60]");
  if (options.samples < 1 || options.samples > 64)
    throw std::invalid_argument("samples must be in [1, 64]");
}

/// The exponent that takes the largest entry into [1/2, 1), so that sixth powers do not overflow.
int scale_exponent(const TensorField& field) {
  const double largest = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, field.tensors.size(), 1u << 14), 0.0,
      [&](const tbb::blocked_range<std::size_t>& range, double r) {
        for (std::size_t n = range.begin(); n < range.end(); ++n)
          for (const double entry : field.tensors[n]) r = std::max(r, std::fabs(entry));
        return r;
      },
      [](double a, double b) { return std::max(a, b); });
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::max(exponent, -1000);
}

class Extractor {
 public:
  Extractor(const TensorField& field, const APatchOptions& options)
      : field_(field), options_(options) {}

  Approximation run(APatchStatistics* statistics);

 private:
  void stop_if_interrupted() const {
    if (options_.interrupted && options_.interrupted->load()) throw Interrupted{};
  }
  void report(std::string_view step) const {
    stop_if_interrupted();
    if (options_.progress) options_.progress(step, 0);
  }
  std::vector<Findings> find(const Task& task) const;
  FeatureMesh join(std::size_t feature, const std::vector<Findings>& parts,
                   const baseline::WeldGrid& grid) const;
  void count(const std::vector<SheetPlan>& plans, const std::vector<Findings>& parts,
             APatchStatistics& statistics) const;

  const TensorField& field_;
  const APatchOptions& options_;
};

std::vector<Findings> Extractor::find(const Task& task) const {
  const std::size_t tets = field_.mesh.tets.size();
  std::vector<Findings> parts((tets + kRun - 1) / kRun);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t n) {
    if (options_.interrupted && options_.interrupted->load()) return;
    parts[n] = extract_run(task, n * kRun, std::min((n + 1) * kRun, tets));
  });
  return parts;
}

FeatureMesh Extractor::join(std::size_t feature, const std::vector<Findings>& parts,
                            const baseline::WeldGrid& grid) const {
  MeshBuilder whole(grid);
  for (const Findings& part : parts) whole.append(part.meshes[feature]);
  return whole.finish();
}

void Extractor::count(const std::vector<SheetPlan>& plans, const std::vector<Findings>& parts,
                      APatchStatistics& statistics) const {
  for (std::size_t i = 0; i < plans.size(); ++i)
    for (std::size_t f = 0; f < statistics.features.size(); ++f)
      if (plans[i].has(static_cast<Feature>(f)))
        for (const Findings& part : parts) statistics.features[f] += part.counts[i];
  for (const Findings& part : parts)
    statistics.features[index(Feature::TripleCurve)] += part.curve_counts;
}

Approximation Extractor::run(APatchStatistics* statistics) {
  const Stopwatch watch;
  Approximation result;
  result.table = options_.table;
  result.requested = options_.features & options_.table.all();
  const auto rows = static_cast<std::size_t>(options_.table.size());
  result.features.resize(rows);
  const int exponent = scale_exponent(field_);
  const double scale = std::ldexp(1.0, -exponent);
  const auto plans = baseline::plan_sheets(options_.table, result.requested, scale);
  const baseline::WeldGrid grid(field_.mesh);
  report("patches");
  const std::vector<Findings> parts =
      find({field_, plans, grid, exponent, scale, options_.max_depth, options_.samples,
            options_.patch_test, options_.table.size()});
  const double patches_s = watch.seconds();
  report("merge");
  tbb::parallel_for(std::size_t{0}, rows,
                    [&](std::size_t f) { result.features[f] = join(f, parts, grid); });
  for (const Findings& part : parts)
    result.given_up.insert(result.given_up.end(), part.given_up.begin(), part.given_up.end());
  std::sort(result.given_up.begin(), result.given_up.end());
  result.given_up.erase(std::unique(result.given_up.begin(), result.given_up.end()),
                        result.given_up.end());
  if (statistics) {
    *statistics = {std::vector<APatchCounts>(rows), patches_s, watch.seconds() - patches_s};
    count(plans, parts, *statistics);
  }
  result.seconds = watch.seconds();
  return result;
}

}  // namespace

APatchCounts& APatchCounts::operator+=(const APatchCounts& other) {
  excluded += other.excluded;
  three_sided += other.three_sided;
  four_sided += other.four_sided;
  subdivided += other.subdivided;
  excluded_parts += other.excluded_parts;
  given_up += other.given_up;
  return *this;
}

Approximation extract_a_patches(const TensorField& field, const APatchOptions& options,
                                APatchStatistics* statistics) {
  check(options);
  // The settings of floating point are the library's own, as in `extract`: the same bytes whatever
  // the host program has set.
  return with_fp_environment([&] {
    tbb::task_arena arena(options.threads > 0 ? static_cast<int>(options.threads)
                                              : tbb::task_arena::automatic);
    arena.initialize();
    return arena.execute([&] { return Extractor(field, options).run(statistics); });
  });
}

}  // namespace triplex

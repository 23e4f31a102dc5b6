// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/meshing/mesh_patches.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "assemble_meshes.hpp"
#include "meshed_patches.hpp"
#include "triplex/arithmetic/fp_environment.hpp"

namespace triplex {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Half of a patch's tolerance is for its boundary, by whose deviation d and value v it is off by
/// d + v / rise (`PatchMesher::at_boundary`). Of arcs of the curve, v is at most d times the
/// steepest. A patch that its cell keeps near enough asks for nothing.
struct ArcShares {
  ArcTarget of_surface, of_curve;
};
ArcShares shares_of(double tolerance, const std::optional<Chart>& chart, double cell_size) {
  if (cell_size <= tolerance) return {};
  const double quarter = tolerance / 4;
  if (!chart) return {{quarter}, {quarter}};
  return {{quarter, quarter * chart->rise},
          {tolerance / (2 * (1 + chart->steepest / chart->rise))}};
}

}  // namespace

class PatchMeshing::State {
 public:
  State(const TensorField& input, const PatchComplex& complex, const MeshingOptions& options)
      : input_(input),
        complex_(complex),
        options_(options),
        functions_(surface_functions(complex.table, complex.field->scale_exponent())),
        part_(complex.patches.size(), 1),
        share_(complex.patches.size(), 1),
        arcs_(complex_, functions_),
        patches_(complex.patches.size()),
        stale_(complex.patches.size(), true) {}

  MeshedPatches mesh() {
    for (int round = 0; round < kMostRounds; ++round) {
      report("arcs");
      const std::vector<bool> changed = arcs_.sample(arc_targets());
      for (std::size_t n = 0; n < patches_.size(); ++n)
        if (std::ranges::any_of(complex_.boundary(complex_.patches[n]),
                                [&](const ArcUse& use) { return changed[use.arc]; }))
          stale_[n] = true;
      mesh_stale();
      if (!ask_for_more()) break;
    }
    report("join");
    MeshedPatches result = assemble_meshes(complex_, arcs_, patches_);
    result.accuracy = accuracy();
    return result;
  }

  void refine(std::span<const std::uint32_t> patches) {
    for (const std::uint32_t n : patches) {
      if (patches_[n].is_tangled) continue;  // finer arcs were of no use
      part_[n] *= kFiner;
      stale_[n] = true;
    }
  }

 private:
  static constexpr std::size_t kSlice = 1u << 15;
  /// Each round makes the arcs of tangled patches finer by kFiner in deviation, with four times as
  /// many points. What is tangled still is pinched: its arcs touch, or nearly so.
  static constexpr int kMostRounds = 3;
  static constexpr double kFiner = 1.0 / 16;
  static constexpr double kLeastShare = kFiner;

  void report(std::string_view step, double done = 0) const {
    if (options_.interrupted && options_.interrupted->load()) throw Interrupted{};
    if (options_.progress) options_.progress(step, done);
  }

  /// What was asked for, and what patch n is meshed to.
  double wanted_in(TetId tet) const {
    return options_.tolerance ? options_.tolerance->at(longest_edge_approx(input_, tet))
                              : kInfinite;
  }
  double wanted_of(std::size_t n) const { return wanted_in(complex_.patches[n].input); }
  double tolerance_of(std::size_t n) const { return part_[n] * wanted_of(n); }

  /// In slices, so that an interrupt is seen.
  void mesh_stale() {
    std::vector<std::size_t> stale;
    for (std::size_t n = 0; n < patches_.size(); ++n)
      if (stale_[n]) stale.push_back(n);
    for (std::size_t start = 0; start < stale.size(); start += kSlice) {
      const std::size_t end = std::min(start + kSlice, stale.size());
      tbb::parallel_for(start, end, [&](std::size_t i) {
        const std::size_t n = stale[i];
        const Patch& patch = complex_.patches[n];
        patches_[n] = mesh_patch(complex_, arcs_, patch, functions_[index(patch.feature)],
                                 tolerance_of(n), options_.keep_tensors);
      });
      report("patches", static_cast<double>(end) / static_cast<double>(stale.size()));
    }
    stale_.assign(stale_.size(), false);
  }

  /// Patches whose polygons are tangled in their charts get finer arcs. False: there are none.
  bool ask_for_more() {
    bool any = false;
    for (std::size_t n = 0; n < patches_.size(); ++n) {
      if (!patches_[n].is_tangled || share_[n] < kLeastShare) continue;
      share_[n] *= kFiner;
      any = true;
    }
    return any;
  }

  /// What every arc has to satisfy: all that the patches that it bounds ask for.
  std::vector<ArcTarget> arc_targets() const {
    std::vector<ArcShares> shares(complex_.patches.size());
    tbb::parallel_for(std::size_t{0}, shares.size(), [&](std::size_t n) {
      const Patch& patch = complex_.patches[n];
      const SurfaceFunction& f = functions_[index(patch.feature)];
      const CellMap cell(*complex_.field, patch.cell, f.takes_trace());
      shares[n] =
          shares_of(share_[n] * tolerance_of(n), chart_of(complex_, patch, cell, f), cell.size());
    });
    std::vector<ArcTarget> targets(complex_.arcs.size());
    for (std::size_t n = 0; n < shares.size(); ++n)
      for (const ArcUse& use : complex_.boundary(complex_.patches[n]))
        targets[use.arc].include(complex_.arcs[use.arc].vertices == 3 ? shares[n].of_surface
                                                                      : shares[n].of_curve);
    for (const CurvePiece& piece : complex_.curve)
      targets[piece.use.arc].include({wanted_in(piece.input) / 2});
    for (std::uint32_t n = 0; n < complex_.arc_originals.size(); ++n)
      targets[complex_.arc_originals[n].arc].include(targets[n]);
    for (std::uint32_t n = 0; n < complex_.arc_originals.size(); ++n)
      targets[n] = targets[complex_.arc_originals[n].arc];
    return targets;
  }

  MeshAccuracy accuracy() const {
    MeshAccuracy accuracy;
    const auto add_vertices = [&](double error, std::uint64_t count) {
      if (count == 0) return;
      if (error < kInfinite)
        accuracy.largest_vertex_error = std::max(accuracy.largest_vertex_error, error);
      else
        accuracy.unproven_vertices += count;
    };
    for (std::size_t n = 0; n < patches_.size(); ++n) {
      const MeshedPatch& patch = patches_[n];
      ++accuracy.patches;
      ++(patch.error <= wanted_of(n) && patch.error < kInfinite ? accuracy.within
         : patch.error < kInfinite                              ? accuracy.beyond
                                                                : accuracy.unproven);
      if (patch.error < kInfinite)
        accuracy.largest_error = std::max(accuracy.largest_error, patch.error);
      add_vertices(patch.error < kInfinite ? patch.vertex_error : kInfinite, patch.inside.size());
    }
    for (std::uint32_t n = 0; n < complex_.corners.size(); ++n)
      add_vertices(arcs_.corner_position_error(n), 1);
    for (std::uint32_t n = 0; n < complex_.arcs.size(); ++n)
      add_vertices(arcs_[n].deviation < kInfinite ? arcs_[n].point_error + arcs_[n].position_error
                                                  : kInfinite,
                   arcs_[n].points.size());
    return accuracy;
  }

  const TensorField& input_;
  const PatchComplex& complex_;
  const MeshingOptions options_;
  const std::vector<SurfaceFunction> functions_;
  std::vector<double> part_;   // of the tolerance, that each patch is meshed to
  std::vector<double> share_;  // of that, that it gives its arcs
  MeshedArcs arcs_;
  std::vector<MeshedPatch> patches_;
  std::vector<bool> stale_;  // to be meshed
};

PatchMeshing::PatchMeshing(const TensorField& input, const PatchComplex& complex,
                           const MeshingOptions& options)
    : state_(std::make_unique<State>(input, complex, options)), threads_(options.threads) {}
PatchMeshing::~PatchMeshing() = default;

MeshedPatches PatchMeshing::mesh() {
  return with_fp_environment([&] {
    tbb::task_arena arena(threads_ > 0 ? static_cast<int>(threads_) : tbb::task_arena::automatic);
    arena.initialize();
    return arena.execute([&] { return state_->mesh(); });
  });
}

void PatchMeshing::refine(std::span<const std::uint32_t> patches) { state_->refine(patches); }

MeshedPatches mesh_patches(const TensorField& input, const PatchComplex& complex,
                           const MeshingOptions& options) {
  return PatchMeshing(input, complex, options).mesh();
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/extract/extraction.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "domain_cells.hpp"
#include "feature_mesh.hpp"
#include "patch_complex.hpp"
#include "triplex/arithmetic/fp_environment.hpp"
#include "triplex/extract/degenerate_curves.hpp"
#include "triplex/field/symmetric.hpp"
#include "triplex/refine/refine.hpp"
#include "unresolved.hpp"

namespace triplex {
namespace {

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - start_;
    start_ = now;
    return elapsed.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Opens the tets whose patches rest on something that could not be computed: the side of the spine
/// of one of their edges, or an enclosure of the triple degenerate point on one of their faces.
void open_unsettled(const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                    const std::vector<std::uint32_t>& active, FeatureSet features,
                    RefinedComplex& complex) {
  const FeatureSet level_sets = crossings.table().level_sets();
  const auto unsettled = [&](const Leaf& leaf) {
    const auto& v = leaf.vertices;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const CrossedEdge* edge = crossings.find(v[i], v[j]);
        if (edge != nullptr && edge->open) return true;
      }
    for (const auto& face : {std::array{v[1], v[2], v[3]},
                             {v[0], v[2], v[3]},
                             {v[0], v[1], v[3]},
                             {v[0], v[1], v[2]}}) {
      const int point = spine_points.find(face);
      if (point >= 0 && !spine_points.points()[static_cast<std::size_t>(point)].proven())
        return true;
    }
    return false;
  };
  const bool all_edges =
      std::ranges::none_of(crossings.edges(), [](const CrossedEdge& e) { return e.open; });
  const bool all_points = std::ranges::all_of(spine_points.points(), &SpinePoint::proven);
  if (all_edges && all_points) return;
  for (const std::uint32_t n : active) {
    Leaf& leaf = complex.leaves[n];
    if (!unsettled(leaf)) continue;
    leaf.graph &= level_sets;
    leaf.open |= features & ~level_sets;
    leaf.has_spine_proof = false;
    if (leaf.obstacle == Obstacle::None) leaf.obstacle = Obstacle::SpineFace;
  }
}

/// std::popcount is a library call where the instruction may be missing; most sets are empty.
unsigned count_bits(unsigned set) {
  unsigned n = 0;
  for (; set != 0; set &= set - 1) ++n;
  return n;
}

CertificateCounts count_certificates(const RefinedComplex& complex, FeatureSet features) {
  const auto add = [&](const auto& range, CertificateCounts counts) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      const Leaf& leaf = complex.leaves[n];
      const unsigned requested = features;
      counts.exclusion += count_bits(requested & ~static_cast<unsigned>(leaf.graph | leaf.open));
      counts.graph += count_bits(leaf.graph);
      counts.unresolved += count_bits(leaf.open);
      counts.spine += leaf.has_spine_proof;
      counts.radial +=
          !complex.nodes.empty() && leaf.open == 0 &&
          std::ranges::any_of(leaf.vertices, [&](VertexId v) { return complex.field.is_node(v); });
    }
    return counts;
  };
  const auto join = [](CertificateCounts a, const CertificateCounts& b) {
    a.exclusion += b.exclusion;
    a.graph += b.graph;
    a.spine += b.spine;
    a.radial += b.radial;
    a.unresolved += b.unresolved;
    return a;
  };
  return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, complex.leaves.size(), 1u << 14),
                              CertificateCounts{}, add, join);
}

SpineAccuracy accuracy_of(const FaceSpinePoints& spine_points) {
  SpineAccuracy accuracy;
  for (const SpinePoint& point : spine_points.points()) {
    ++(point.proven() ? accuracy.proven : accuracy.unproven);
    if (!point.proven()) continue;
    accuracy.error = std::max(accuracy.error, point.error);
    accuracy.coordinate_error = std::max(accuracy.coordinate_error, point.coordinate_error);
  }
  return accuracy;
}

std::vector<Point> isotropic_points(const RefinableField& field) {
  std::vector<Point> points;
  for (const VertexId v : field.isotropic_vertices()) points.push_back(field.position(v));
  std::ranges::sort(points);
  return points;
}

/// The features that are curves by nature: where tensors are symmetric, D >= 0 everywhere, and the
/// degenerate ones are no surfaces.
FeatureSet curves_of(const TensorField& field) {
  return is_symmetric(field) ? bit(Feature::DegenerateLinear) | bit(Feature::DegeneratePlanar) : 0;
}

/// Puts the degenerate curves asked for in the place of surfaces.
void add_degenerate_curves(const TensorField& field, const RefinedComplex& complex,
                           const ExtractionOptions& options, Extraction& result) {
  DegenerateCurves curves = find_degenerate_curves(field, complex, options);
  result.features[index(Feature::DegenerateLinear)] = std::move(curves.linear);
  result.features[index(Feature::DegeneratePlanar)] = std::move(curves.planar);
  result.curves_shifted = curves.shift == Shift::General;
  for (const CurvesUndecided& tet : curves.undecided) {
    UnresolvedTet open = whole_tet(field, tet.tet);
    open.features = tet.features;
    open.reason = describe(tet.obstacle);
    result.unresolved.push_back(std::move(open));
  }
  std::stable_sort(result.unresolved.begin(), result.unresolved.end(),
                   [](const auto& a, const auto& b) { return a.source_cell < b.source_cell; });
}

/// What is certified by refinement: what is asked for, and all that cuts the domain if that is.
FeatureSet certified_features(const ExtractionOptions& options, FeatureSet curves) {
  const FeatureSet all =
      options.domains ? options.features | book_of(options.table) : options.features;
  return all & ~curves;
}

std::size_t size_limit_of(const ExtractionOptions& options, const TensorField& field) {
  return options.max_tets.value_or(default_size_limit(field.mesh.tets.size()));
}

RefineOptions refine_options(const ExtractionOptions& options, FeatureSet certified,
                             const TensorField& field) {
  RefineOptions r;
  r.table = options.table;
  r.features = certified;
  r.periodic = options.periodic;
  r.max_bisections = options.max_bisections.value_or(kDefaultBudget);
  r.reserve = options.max_bisections ? 0 : kDefaultReserve;
  r.max_tets = size_limit_of(options, field);
  // Domains, arcs that are sampled, and sides of periodic domains want one crossing per edge.
  r.stacks = options.stacks && !options.domains && !options.keep_patches && !any(options.periodic);
  r.wish = options.wish;
  r.interrupted = options.interrupted;
  if (options.progress) r.progress = [&](double done) { options.progress("certify", done); };
  return r;
}

/// The steps of the main job.
Extraction run(const TensorField& field, const ExtractionOptions& options) {
  const auto report = [&](std::string_view step) {
    if (options.interrupted && options.interrupted->load()) throw Interrupted{};
    if (options.progress) options.progress(step, 0);
  };
  Extraction result;
  Stopwatch watch;
  result.curves = curves_of(field);
  const FeatureSet certified = certified_features(options, result.curves);
  RefinedComplex complex = refine(field, refine_options(options, certified, field));
  result.timing.refine_s = watch.lap();

  // Vertices, edges, faces, cells.
  report("extract");
  const VertexLabels labels = labels_of(complex, options.table);
  const std::vector<std::uint32_t> active = active_leaves(complex, labels);
  SignStages stages = complex.sign_stages;
  const EdgeCrossings crossings(complex, options.table, labels, active, certified, stages);
  const FaceSpinePoints spine_points(complex, labels, active, crossings);
  const StackedFaces stacks(complex, crossings, active, stages);
  open_unsettled(crossings, spine_points, active, certified, complex);
  open_collapsed_stacks(crossings, spine_points, stacks, active, complex);
  report("mesh");
  result.table = options.table;
  result.requested = options.features;
  // The sides of a periodic domain are to match point by point, and so are domains and surfaces.
  const bool contracted = options.contract && complex.copies.empty() && !options.domains;
  auto built =
      FeatureMeshBuilder(field, complex, crossings, spine_points, stacks, options.keep_tensors)
          .build(active, options.features & ~result.curves, contracted);
  result.features = std::move(built.meshes);
  result.contraction = built.contraction;
  if (options.domains) result.domains = domain_cells(field, complex, crossings, spine_points);

  result.timing.extract_s = watch.lap();

  report("nodes");
  NodeSearch search = find_nodes(field, complex, options.features & ~result.curves);
  result.nodes = std::move(search.nodes);
  result.nodes_undecided = std::move(search.undecided);
  result.isotropic_points = isotropic_points(complex.field);
  result.timing.nodes_s = watch.lap();

  result.sign_stages = stages;
  result.certificates = count_certificates(complex, certified);
  result.refinement = {complex.rounds, complex.bisections, complex.leaves.size(),
                       complex.budget.largest_limit(), size_limit_of(options, field)};
  result.identical = find_identical(field, complex.field);
  result.unresolved =
      unresolved_tets(field, complex, result.nodes, result.identical, options.table);
  result.open_cells = open_cells(field, complex);
  if (result.curves != 0) {
    result.timing.extract_s += watch.lap();
    report("curves");
    add_degenerate_curves(field, complex, options, result);
    result.timing.curves_s = watch.lap();
  }
  for (const Crossing& c : crossings.crossings())
    if (c.error < 1)
      result.largest_crossing_error = std::max(result.largest_crossing_error, c.error);
  result.spine_accuracy = accuracy_of(spine_points);
  if (options.keep_patches)
    result.patches = std::make_shared<const PatchComplex>(
        make_patch_complex(field, std::move(complex), crossings, spine_points, active,
                           options.features & ~result.curves));
  result.timing.extract_s += watch.lap();
  return result;
}

}  // namespace

Extraction extract(const TensorField& field, const ExtractionOptions& options) {
  // The filters need round-to-nearest and denormals in every thread, whatever the host program has
  // set: an arena hands the floating-point settings of its creation to its workers.
  return with_fp_environment([&] {
    tbb::task_arena arena(options.threads > 0 ? static_cast<int>(options.threads)
                                              : tbb::task_arena::automatic);
    arena.initialize();
    try {
      return arena.execute([&] { return run(field, options); });
    } catch (const RefinementInterrupted&) {
      throw Interrupted{};
    }
  });
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "triplex/arithmetic/sign.hpp"
#include "triplex/extract/domain_mesh.hpp"
#include "triplex/extract/identical.hpp"
#include "triplex/extract/nodes.hpp"
#include "triplex/extract/patch_complex.hpp"
#include "triplex/extract/unresolved.hpp"
#include "triplex/feature/feature_mesh.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/periodic.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {

/// What was proven, by kind: (leaf tet, page) pairs for exclusion, graph and unresolved; leaf tets
/// for spine, and for radial those around nodes.
struct CertificateCounts {
  std::uint64_t exclusion = 0, graph = 0, spine = 0, radial = 0, unresolved = 0;
};

/// The points of the triple degenerate curve on faces, and how far the proven ones may be from the
/// true ones. Faces with an unproven point are not certified. Source: proofs/spine_point.md.
struct SpineAccuracy {
  std::uint64_t proven = 0, unproven = 0;
  double error = 0;             ///< the largest, in units of length
  double coordinate_error = 0;  ///< the largest, in barycentric coordinates of the face
};

struct RefinementStatistics {
  std::uint64_t rounds = 0, bisections = 0, tets = 0;
  std::uint32_t max_bisections = 0;  ///< that one tet of the input may ask for
  std::uint64_t max_tets = 0;        ///< no round started with more; 0: no limit
};

/// Edges of the size of rounding that were contracted: how many vertices became others, an upper
/// bound of how far any of them is from what it became, and how far it might have been; in units of
/// length. Source: proofs/contraction.md.
struct ContractionStatistics {
  std::uint64_t vertices = 0;
  double moved = 0, reach = 0;
};

/// Seconds of wall time: refinement with certification, the search for nodes, the degenerate curves
/// of symmetric tensors, and extraction.
struct ExtractionTiming {
  double refine_s = 0, nodes_s = 0, curves_s = 0, extract_s = 0;
};

/// The bisections that one tet may ask for, and those that the tets left share when these are at
/// most 64. Source: docs/decisions/0014-budget-of-1024.md, 0020-few-tets-share-a-reserve.md.
inline constexpr std::uint32_t kDefaultBudget = 1024, kDefaultReserve = 64 * kDefaultBudget;

/// The tets that the refined mesh of so many tets may have: 10 million for 1.5 million, 4.5 GB at
/// 450 bytes each with all that is made of them. Source: docs/decisions/0014-budget-of-1024.md.
constexpr std::size_t default_size_limit(std::size_t tets) {
  constexpr std::size_t kGrowth = 4, kRoom = 4'000'000;
  return kGrowth * tets + kRoom;
}

struct ExtractionOptions {
  FeatureTable table;
  FeatureSet features = kStandardSet;  ///< rows of the table
  /// Opposite sides of the domain that are one: the meshes on them match point by point, and
  /// `FeatureMesh::identified` says which points are one. \throw BadInput if they do not
  /// correspond.
  PeriodicAxes periodic{};
  /// Contract edges of the size of rounding in the meshes of surfaces and of the triple degenerate
  /// curve, where that changes no topology; not in periodic domains, nor with `domains`. The cell
  /// that a triangle comes from then holds it up to `ContractionStatistics::moved`.
  bool contract = false;
  /// Fill `FeatureMesh::tensors`.
  bool keep_tensors = false;
  /// Fill `Extraction::patches`.
  bool keep_patches = false;
  /// Fill `Extraction::domains`. All pages of the table and the curve are certified then.
  bool domains = false;
  /// Certify cells that hold several discs of a degenerate surface (`RefineOptions::stacks`). Takes
  /// several times as long on hard fields. Not in periodic domains, nor with `domains` or
  /// `keep_patches`. Where cells stay open the mesh may have cracks beside such cells.
  bool stacks = false;
  /// Bisections that one tet of the input may ask for before it is reported as unresolved. Nothing:
  /// kDefaultBudget, and its share of kDefaultReserve if few tets are left.
  std::optional<std::uint32_t> max_bisections;
  /// Tets of the refined mesh: no round of bisections starts with more, and what is open then is
  /// reported as unresolved. Bounds memory; 0: no limit. Nothing: `default_size_limit`.
  std::optional<std::size_t> max_tets;
  /// Further refinement of what is certified (`RefineOptions::wish`). May be empty.
  LeafWish wish;
  /// 0: all cores.
  unsigned threads = 0;
  ProgressCallback progress;
  /// Set to true from anywhere (a signal handler) to stop; `extract` then throws `Interrupted`.
  const std::atomic<bool>* interrupted = nullptr;
};

struct Extraction {
  FeatureTable table;
  FeatureSet requested = 0;
  /// The surfaces of the table that are curves in this field: the degenerate ones, if all tensors
  /// are exactly symmetric. Their meshes have segments.
  FeatureSet curves = 0;
  /// These curves are those of the field shifted by rounding size, as T is not in general position
  /// (`Shift`).
  bool curves_shifted = false;
  std::vector<FeatureMesh> features;  ///< one per row of the table; empty where not asked for
  const FeatureMesh& mesh(Feature f) const { return features[index(f)]; }
  /// What the surfaces' triangles were made of. Null unless `ExtractionOptions::keep_patches`.
  std::shared_ptr<const PatchComplex> patches;
  /// The domain cut by all pages of the table. Empty unless `ExtractionOptions::domains`.
  DomainMesh domains;
  /// The nodes on the degenerate surfaces asked for, by position, and the tets of the input where
  /// some may be missing.
  std::vector<Node> nodes;
  std::vector<NodesUndecided> nodes_undecided;
  /// Points where the deviator is exactly zero, by position: all pages and the triple degenerate
  /// curve may meet there, as cones. Source: proofs/isotropic_vertex.md.
  std::vector<Point> isotropic_points;
  CertificateCounts certificates;
  RefinementStatistics refinement;
  ContractionStatistics contraction;
  SignStages sign_stages;
  std::vector<UnresolvedTet> unresolved;  ///< sorted by source cell
  OpenCells open_cells;                   ///< where `unresolved` is
  IdenticalSimplices identical;  ///< where invariants vanish identically: there is no surface there
  /// Largest certified distance of a vertex on a certified edge from the true zero on that edge, as
  /// a fraction of the edge.
  double largest_crossing_error = 0;
  SpineAccuracy spine_accuracy;
  ExtractionTiming timing;
  bool certified() const { return unresolved.empty(); }
};

/// The main job: the requested features of a field, with certified topology.
/// Guarantee: where `certified` is 1, the mesh (before contraction, which changes no topology of
/// the whole: proofs/contraction.md) is homeomorphic, cell by cell, to the feature of the piecewise
/// linear field perturbed by a fixed infinitesimal constant tensor (docs/guarantees.md). \pre the
/// field passed `check_input`. \throw Interrupted; BadInput for periodic sides that do not
/// correspond.
Extraction extract(const TensorField& field, const ExtractionOptions& options = {});

}  // namespace triplex

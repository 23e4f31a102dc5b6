// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "triplex/extract/patch_complex.hpp"
#include "triplex/feature/feature_mesh.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/field/tensor_field.hpp"
#include "triplex/meshing/tolerance.hpp"

namespace triplex {

struct MeshingOptions {
  /// How far mesh and surface may be from each other. Nothing: one flat polygon per patch.
  std::optional<Tolerance> tolerance;
  /// Fill `FeatureMesh::tensors`.
  bool keep_tensors = false;
  /// 0: all cores.
  unsigned threads = 0;
  ProgressCallback progress;
  const std::atomic<bool>* interrupted = nullptr;
};

/// How good the meshes are.
struct MeshAccuracy {
  std::uint64_t patches = 0;        ///< of surfaces, one per tet of the refined mesh
  std::uint64_t within = 0;         ///< proven to be within the tolerance
  std::uint64_t beyond = 0;         ///< with a proven bound that is larger
  std::uint64_t unproven = 0;       ///< without a bound
  double largest_error = 0;         ///< the largest proven bound, in units of length
  double largest_vertex_error = 0;  ///< of vertices whose error is proven, in units of length
  std::uint64_t unproven_vertices = 0;
};

struct MeshedPatches {
  std::vector<FeatureMesh>
      features;  ///< one per row of the table; empty where there are no patches
  /// Per row of the table and triangle: its patch in `PatchComplex::patches`.
  std::vector<std::vector<std::uint32_t>> patch_of;
  MeshAccuracy accuracy;
};

/// Meshes the patches of an extraction: arcs are sampled once and shared, patches become
/// constrained Delaunay triangulations over a plane, with `FeatureMesh::normals` and `error_bound`.
/// Guarantee: where `error_bound` is finite, every point of the triangles of the patch is within
/// that distance of the surface, and every point of the surface's patch within it of the triangles;
/// meshes are watertight like those of the extraction. The result does not depend on threads.
/// Source: proofs/mesh_accuracy.md. \throw Interrupted.
MeshedPatches mesh_patches(const TensorField& input, const PatchComplex& complex,
                           const MeshingOptions& options);

/// The same in steps, for patches that have to be finer than the tolerance says: where triangles
/// cross though the surfaces do not. Field and complex must outlive it.
class PatchMeshing {
 public:
  PatchMeshing(const TensorField& input, const PatchComplex& complex,
               const MeshingOptions& options);
  ~PatchMeshing();

  /// Meshes what has changed since the last time, everything at first. \throw Interrupted.
  MeshedPatches mesh();
  /// From now on these patches are meshed to a sixteenth of their tolerance: their edges become
  /// about a quarter as long.
  void refine(std::span<const std::uint32_t> patches);

 private:
  class State;
  std::unique_ptr<State> state_;
  unsigned threads_ = 0;
};

}  // namespace triplex

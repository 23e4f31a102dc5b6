// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/quadric/quadric_type.hpp"

namespace triplex {

struct QuadricOptions {
  /// Segments of each conic arc in a face, at least 2; patches are sampled about as densely.
  int samples = 4;
  unsigned threads = 0;  ///< 0: all cores
  /// Set to true from anywhere to stop; `Interrupted` is thrown then.
  const std::atomic<bool>* interrupted = nullptr;
};

/// What the surface is in one tet.
struct QuadricPiece {
  TetId tet{};
  QuadricType type = QuadricType::Empty;  ///< of the whole quadric
  std::uint32_t components = 0;
  std::int32_t euler = 0;
  std::uint32_t loops = 0;  ///< closed curves on the boundary of the tet

  friend bool operator==(const QuadricPiece&, const QuadricPiece&) = default;
};

/// A tet in which the quadric is singular, or tangent to a face or an edge, or through a vertex.
struct QuadricContact {
  TetId tet{};
  QuadricType type = QuadricType::Empty;

  friend bool operator==(const QuadricContact&, const QuadricContact&) = default;
};

struct QuadricExtraction {
  /// Points, triangles, source_cell and certified; of the balanced surface q, in doubles; the rest
  /// is empty. Oriented as the feature; both parts of the balanced surface as the linear one.
  FeatureMesh mesh;
  std::vector<QuadricPiece> pieces;      ///< tets that hold some, in the order of the mesh
  std::vector<QuadricContact> contacts;  ///< not meshed
  /// Tets of `pieces` with a patch of several loops that no chart could hold: not meshed.
  std::vector<TetId> unmeshed;
  /// Of the balanced surface, per triangle: 1 linear (q > 0), -1 planar (q < 0), proven; 0 where
  /// the split is not. Between triangles of different sides runs the triple degenerate curve.
  std::vector<std::int8_t> parts;
  /// Tets of `pieces` in which the triple degenerate curve meets an edge: not split.
  std::vector<QuadricContact> curve_contacts;
  /// Other tets of `pieces` whose split is not proven, or is and no chart holds it.
  std::vector<TetId> unsplit;
  /// Over pieces and contacts.
  std::array<std::uint64_t, kQuadricTypes> types{};
};

/// A surface as a quadric in each tet of the input, without refinement: a second road to balanced,
/// magnitude, isotropicity and traceless surfaces, which shares no decision with `extract`.
/// Guarantee: types, contacts and pieces are exact, for the field as it is (no perturbation); the
/// mesh has these pieces, neighbours share the points on their face, and its bytes do not depend on
/// the number of threads. Points are on the surface up to rounding, but where doubles could not
/// find one in its face or tet: then it is on a chord.
/// \pre the field passed `check_input`. \throw Interrupted; std::invalid_argument if the feature is
/// on no quadric. Source: proofs/quadric_patches.md.
QuadricExtraction extract_quadric(const TensorField& field, const FeatureRow& feature,
                                  const QuadricOptions& options = {});

/// The balanced surface cut into its linear (q > 0) and planar (q < 0) part: along the triple
/// degenerate curve, which is a constraint of the triangulation, where the split is proven, and
/// there `certified` is 1. In `curve_contacts` and `unsplit` triangles are cut along straight lines
/// where q, in doubles at their points, changes sign. Both parts have one list of points and meet
/// along the cuts. \throw std::invalid_argument for another surface.
struct BalancedParts {
  FeatureMesh linear, planar;
};
BalancedParts split_balanced(const QuadricExtraction& balanced);

}  // namespace triplex

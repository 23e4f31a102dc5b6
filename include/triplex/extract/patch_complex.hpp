// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "triplex/feature/feature_table.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// A point where patches have a corner: on an edge of the refined mesh, on a face of it (of the
/// triple degenerate curve), or at a vertex (a node).
struct PatchCorner {
  std::array<VertexId, 3> carrier{};  ///< the first `vertices`, ascending
  std::array<double, 3> weights{};    ///< barycentric, of the carrier
  std::uint8_t vertices = 0;          ///< 1: a node; 2: a crossing; 3: a point of the curve
  Point position{};
  double p = 0, q = 0;  ///< of the deviator there, in the units of the input
  /// Proven bound on the distance to the true point, in units of length; infinite where nothing is
  /// proven.
  double error = 0;
};

/// A curve between two corners: of a surface on a face, or of the triple degenerate curve in a tet,
/// where several pages end on it.
struct PatchArc {
  Feature feature{};                    ///< TripleCurve in a tet
  std::array<std::uint32_t, 2> ends{};  ///< corners, ascending
  std::array<VertexId, 4> carrier{};    ///< the first `vertices`, ascending
  std::uint8_t vertices = 0;            ///< 3 on a face, 4 in a tet
  bool certified = false;               ///< there is one such curve on its carrier, and no more
};

/// An arc as a patch or a curve runs along it.
struct ArcUse {
  std::uint32_t arc = 0;
  bool reversed = false;
};

/// The part of a surface in one tet of the refined mesh: a disc bounded by arcs.
struct Patch {
  Feature feature{};
  bool certified = false;
  std::array<VertexId, 4> cell{};     ///< ascending
  std::int64_t source_cell = 0;       ///< cell id in the input file
  TetId input{};                      ///< the tet of the input that holds the cell
  std::uint32_t first = 0, arcs = 0;  ///< its boundary in `PatchComplex::uses`
};

/// A part of the triple degenerate curve in one tet of the refined mesh.
struct CurvePiece {
  ArcUse use;
  TetId input{};  ///< the tet of the input that holds the cell
  std::int64_t source_cell = 0;
  bool certified = false;
};

/// The arc that one on a side of a periodic domain is a copy of.
struct ArcOriginal {
  std::uint32_t arc = 0;  ///< itself, if of none
  bool reversed = false;  ///< its ends correspond the other way round
  /// Where in the carrier of the original the vertex is that each of the carrier's is a copy of.
  std::array<std::uint8_t, 3> places = {0, 1, 2};
};

/// What extraction knows of the features before it makes triangles of them: corners, the arcs
/// between them, and the patches that these bound, with the refined field that they lie in. The
/// input field must outlive it.
struct PatchComplex {
  FeatureTable table;
  std::optional<RefinableField> field;  ///< always there
  std::vector<PatchCorner> corners;
  std::vector<PatchArc> arcs;
  std::vector<Patch> patches;  ///< by tet, then by feature; oriented like the triangles
  std::vector<ArcUse> uses;
  std::vector<CurvePiece> curve;  ///< if the triple degenerate curve was asked for
  /// Of a periodic domain, else empty. Per corner: the one that it is a copy of (itself, if of
  /// none). Originals lie on no high side, and all they are and have is that of their copies, but
  /// for the coordinate across the side. Only at a vertex no corner may lie on the low sides: the
  /// original is then the least of those that there are.
  std::vector<std::uint32_t> corner_originals;
  std::vector<ArcOriginal> arc_originals;  ///< the same per arc

  std::span<const ArcUse> boundary(const Patch& patch) const {
    return std::span(uses).subspan(patch.first, patch.arcs);
  }
};

}  // namespace triplex

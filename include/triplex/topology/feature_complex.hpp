// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "triplex/feature/feature_soup.hpp"
#include "triplex/feature/feature_table.hpp"

namespace triplex {

/// What lies on one side of a patch: a domain, for a page; for a level set, along which domains
/// vary, the inside or the outside of its convex set. The first six are those of `Domain`.
enum class PatchSide : std::uint8_t { Inside = 6, Outside = 7 };
constexpr PatchSide side_of(Domain d) { return static_cast<PatchSide>(d); }
/// "real-linear" and so on; "inside", "outside".
std::string_view name_of(PatchSide side);

/// A piece of one feature that no curve cuts: its triangles are joined through edges.
struct ComplexPatch {
  Feature feature{};
  PatchSide front{}, back{};  ///< front: where the normals of the triangles point
  std::uint64_t triangles = 0;
  std::uint64_t certified = 0;  ///< of the triangles
  /// Of the surface with boundary whose inside the patch is: points of curves, corners and nodes
  /// count once for each way in which the patch comes to them.
  std::int64_t euler = 0;
  double area = 0;  ///< rounded
};

enum class CurveKind : std::uint8_t {
  Segments,  ///< of a feature that is a curve: the triple curve, a degenerate curve
  Boundary,  ///< one triangle ends there
  Branch,    ///< any other number, or two that do not continue each other
};
/// "segments", "boundary", "branch".
std::string_view name_of(CurveKind kind);

/// A maximal chain of edges at which the same features meet in the same way.
struct ComplexCurve {
  CurveKind kind{};
  FeatureSet features = 0;      ///< of the triangles and segments there
  std::uint32_t triangles = 0;  ///< that meet at each edge
  std::uint64_t edges = 0;
  bool closed = false;
  double length = 0;  ///< rounded
};

/// All features as one complex of triangles, edges and vertices that they share.
struct FeatureComplex {
  std::vector<Point> points;  ///< distinct, all used
  // per triangle
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Feature> features;
  std::vector<std::uint32_t> patch_of;
  std::vector<std::int64_t> source_cell;
  std::vector<std::uint8_t> certified;
  // per edge that lies on a curve
  std::vector<std::array<std::uint32_t, 2>> lines;
  std::vector<std::uint32_t> curve_of;
  std::vector<std::int64_t> line_source_cell;  ///< of the segment there, -1 if there is none
  std::vector<std::uint8_t> line_certified;    ///< 1 if all cells at the edge are

  std::vector<std::uint32_t> corners;        ///< points, ascending
  std::vector<std::uint8_t> corner_is_node;  ///< per corner

  std::vector<ComplexPatch> patches;
  std::vector<ComplexCurve> curves;
  std::uint64_t edges = 0;       ///< all, of triangles and segments
  std::uint64_t components = 0;  ///< joined through shared vertices
  std::uint64_t collapsed = 0;   ///< cells that lost their extent as points are equal: left out

  std::int64_t euler() const {
    return static_cast<std::int64_t>(points.size()) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(triangles.size());
  }
};

/// Makes one complex of all features. Points with equal coordinates are one vertex; cells that then
/// use a vertex twice are left out and counted. An edge lies on a curve if it is a segment, or
/// unless exactly two triangles of one feature meet at it, one continuing the other. Corners are
/// nodes, ends of curves, points where curves meet or surfaces meet in that point only.
/// Guarantee: the patches partition the triangles, the curves the edges on curves; off the curves
/// every edge has two triangles of its patch; sides are those of the table. All by combinatorics;
/// it says nothing about triangles that cross. Cost: sorting. \pre `table` has the features.
/// \throw std::invalid_argument unless features, source cells and marks are one per cell.
/// Source: proofs/embedding.md.
FeatureComplex feature_complex(const FeatureSoup& soup, const FeatureTable& table);

}  // namespace triplex

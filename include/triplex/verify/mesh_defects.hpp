// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "triplex/verify/mesh_view.hpp"

namespace triplex {

/// What may be wrong with a triangle mesh at one place.
enum class DefectKind : std::uint8_t {
  OpenEdge,             ///< an edge of exactly one triangle, where no boundary is expected
  Crack,                ///< such an edge along which others with vertices of their own lie
  NonmanifoldEdge,      ///< an edge of three triangles or more
  NonmanifoldVertex,    ///< its triangles are not connected through its edges
  OrientationConflict,  ///< an edge that its two triangles pass through in the same direction
  DuplicateTriangle,    ///< it has the vertices of one before it
  DegenerateTriangle    ///< its corners lie on one line, exactly
};
inline constexpr std::size_t kDefectKinds = 7;

/// open-edge, crack, nonmanifold-edge and so on.
std::string_view name_of(DefectKind kind);

struct Defect {
  DefectKind kind = DefectKind::OpenEdge;
  std::uint8_t size = 1;                  ///< how many points: 1, 2 or 3
  std::array<std::uint32_t, 3> points{};  ///< ascending; the last one repeated to fill
  Point position{};                       ///< their mean, rounded
  friend bool operator==(const Defect&, const Defect&) = default;
};

struct DefectOptions {
  /// Edges of one triangle form a crack where they are nearer to each other than this, in units of
  /// length, and than a tenth of their triangles there. 0: cracks are those of zero width.
  double tolerance = 0;
  /// Says of a point whether surfaces may end there, as on the boundary of a domain. An edge of
  /// one triangle with both ends and its middle there is no defect. Absent: nowhere.
  std::function<bool(const Point&)> may_end = {};
};

/// Surfaces may end within `tolerance` of the sides of the box.
std::function<bool(const Point&)> on_boundary_of(const BoundingBox& box, double tolerance);

/// The defects of the triangles, by kind, then by points. Segments have none.
/// Guarantee: every kind but `Crack` is decided exactly, as defined above, from indices and, for
/// degenerate triangles, coordinates. Duplicates are left out before edges are looked at, and an
/// edge is either a crack or open. Cracks are found by distances in doubles: of an edge e of one
/// triangle, the points at 1/4, 1/2 and 3/4 must each be within min(tolerance, a/10, h/10), and
/// rounding, of other such edges, a the length of e, h the height of its triangle over it. So an
/// edge of a sliver at a crack wider than that counts as open, and so does one
/// of no extent, whose triangle is as small as rounding. Cost: n log n. \throw
/// std::invalid_argument as `check_mesh`.
std::vector<Defect> mesh_defects(const MeshView& mesh, const DefectOptions& options = {});

/// How many there are of each kind, by the number of the kind.
std::array<std::uint64_t, kDefectKinds> count_defects(std::span<const Defect> defects);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/verify/betti.hpp"
#include "triplex/verify/domain_boundary.hpp"
#include "triplex/verify/mesh_defects.hpp"

namespace triplex {

/// One feature as one method found it, in numbers.
struct RoadSummary {
  bool is_curve = false;
  std::uint64_t vertices = 0, cells = 0;  ///< triangles, or segments of a curve
  BettiNumbers betti;
  std::int64_t euler = 0;
  double measure = 0;  ///< area or length, in doubles
  /// By kind, then by points. Open edges and cracks are those inside the domain: edges of one
  /// triangle that lie neither on its boundary nor where pages end, on the triple curve of the same
  /// method or at an edge of the other page of the same zero set. Nodes, where the surface is a
  /// double cone, are no defects.
  std::vector<Defect> defects;
};

/// Of one row of the table. Coordinates of points that two meshes of one method have in common are
/// taken to be equal bit for bit. \pre triangles lie in their source cells.
RoadSummary summarize(const DomainBoundary& boundary, const FeatureTable& table,
                      std::span<const FeatureMesh> features, Feature f);

}  // namespace triplex

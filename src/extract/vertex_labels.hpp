// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// What extraction reads the surfaces off: at every vertex of the refined mesh a sector, and the
/// level sets in whose convex set it lies. Where certification left a label open the doubles choose
/// (a side: outside), once for all tets around, so the mesh stays watertight; these are open
/// anyway.
struct VertexLabels {
  std::vector<Sector> sectors;
  std::vector<FeatureSet> inside;  ///< empty: no level sets

  Sector sector(VertexId v) const { return sectors[index(v)]; }
  FeatureSet inside_of(VertexId v) const { return inside.empty() ? 0 : inside[index(v)]; }
  bool agree(VertexId a, VertexId b) const {
    return sector(a) == sector(b) && inside_of(a) == inside_of(b);
  }
  /// The edge, with a < b, holds crossings: its labels differ, or a page crosses it twice.
  bool crossed(VertexId a, VertexId b) const { return !agree(a, b) || doubles_on({a, b}) != 0; }
  /// The degenerate pages that cross an edge twice.
  FeatureSet doubles_on(const std::array<VertexId, 2>& edge) const;

  std::vector<DoubleCrossing> doubles;    ///< sorted
  std::vector<std::uint8_t> has_doubles;  ///< per vertex, as the lower end; empty: there are none
};

VertexLabels labels_of(const RefinedComplex& complex, const FeatureTable& table);

/// Tets with a crossed edge: only these can hold patches.
std::vector<std::uint32_t> active_leaves(const RefinedComplex& complex, const VertexLabels& labels);

}  // namespace triplex

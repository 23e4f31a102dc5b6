// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "triplex/certify/stacked_sheets.hpp"
#include "triplex/certify/variation.hpp"
#include "triplex/certify/vertex.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// The first certificate that a cell lacks, in the order in which they are tried.
enum class Obstacle : std::uint8_t {
  None,
  Vertex,     ///< a sign at a vertex stays open under the perturbation
  Cell,       ///< no direction certifies a sheet in the tet
  Face,       ///< no direction certifies a sheet on a face
  Edge,       ///< a sheet may cross an edge more than once
  SpineFace,  ///< (p, q) not proven injective on a face
  SpineCell,  ///< the triple degenerate curve not proven monotone, or more than one arc
  LevelSet,   ///< the tensors at outside vertices not separated from a level set's convex set
  Enclosed,   ///< a sign at the middle of an edge at a node stays open: see `add_midpoint`
};
std::string_view describe(Obstacle obstacle);
/// What a vertex without a label is to the tets around it; no bisection mends it.
Obstacle obstacle_at(const RefinableField& field, VertexId v);
inline bool is_at_vertex(Obstacle obstacle) {
  return obstacle == Obstacle::Vertex || obstacle == Obstacle::Enclosed;
}

/// What is proven about one tet, and where to bisect it if that is not enough.
struct CellCertificate {
  FeatureSet excluded = 0;  ///< requested features proven absent
  FeatureSet graph = 0;  ///< requested features proven to be discs (or one arc) fixed by the labels
  FeatureSet open = 0;   ///< requested features not proven
  bool has_spine_proof = false;
  Obstacle obstacle = Obstacle::None;
  std::array<VertexId, 2> edge{};  ///< to bisect, if `obstacle` is neither None nor at a vertex
  double variation = 0;            ///< of that edge; orders the bisections

  bool complete() const { return open == 0; }
};

/// The sector of every vertex of a field; `kOpenSector` where it stays undecided.
inline constexpr std::uint8_t kOpenSector = 0xff;
using SectorTable = std::span<const std::uint8_t>;

/// Certifies the requested pages and the curve on one tet with its faces and edges.
/// Guarantee: if `complete`, then in this tet each requested page is what vertex labels and edge
/// rotations say: per page nothing, one disc, or one half of a disc cut by the single arc of the
/// triple degenerate curve. If `stacks` is given, a degenerate page may also be several discs, as
/// the arcs on the faces say, and the edges that it crosses twice are appended there. Source:
/// proofs/cell.md, proofs/stacked_sheets.md.
/// \pre vertices ascending; `requested` holds no level sets.
CellCertificate certify_cell(const RefinableField& field, const std::array<VertexId, 4>& vertices,
                             SectorTable sectors, const FeatureTable& table, FeatureSet requested,
                             std::vector<DoubleCrossing>* stacks, SignStages& stages);

}  // namespace triplex

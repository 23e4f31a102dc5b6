// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cell_patches.hpp"
#include "face_regions.hpp"
#include "triplex/extract/domain_mesh.hpp"

namespace triplex {

/// Where the points of each kind begin in the one range of `PointNumber`: a vertex v is v, a
/// crossing c is crossings + c, a spine point s is spine_points + s.
struct PointRanges {
  PointNumber crossings = 0, spine_points = 0;
};

/// The cells of one tet that pages cross: its regions between the patches.
struct CutCell {
  Polygons pieces;                    ///< of the regions' boundaries, seen from outside of each
  std::vector<std::uint32_t> region;  ///< per piece, counted from 0
  std::uint32_t regions = 0;
};

/// Cuts tets along the patches of all pages, by combinatorics alone. A piece is a polygon of a face
/// or a triangle of a patch, taken once for each side; pieces in one sector that share an edge
/// bound one region. Guarantee: every piece inside the tet belongs to two regions, with opposite
/// orientations, every boundary is closed, and neighbouring tets cut their common face alike;
/// certified or not. Source: proofs/domains.md.
class CellCutter {
 public:
  CellCutter(const RefinableField& field, const EdgeCrossings& crossings,
             const FaceSpinePoints& spine_points, const PointRanges& ranges);

  /// \throw std::logic_error if a boundary is not closed, which cannot be.
  void cut(const Leaf& leaf, CutCell& cell);

 private:
  struct HalfEdge {  // of a piece
    std::array<PointNumber, 2> ends;
    Sector sector;
    std::uint32_t piece;
  };
  void cut_face(const Leaf& leaf, int face, Polygons& pieces);
  void add_patch(const Leaf& leaf, const PatchLoop& loop, Polygons& pieces);
  void join_pieces(CutCell& cell);
  PointNumber number(const PatchVertex& v) const {
    return (v.on_spine ? ranges_.spine_points : ranges_.crossings) + v.number;
  }
  std::uint32_t root(std::uint32_t piece);

  const RefinableField& field_;
  const EdgeCrossings& crossings_;
  const FaceSpinePoints& spine_points_;
  const StackedFaces no_stacks_;
  const PointRanges ranges_;
  FeatureSet pages_ = 0;
  CellPatches patches_;
  FaceCutter face_;
  std::vector<HalfEdge> forward_, backward_;
  std::vector<std::uint32_t> parent_;
};

/// The domain of the field cut by all pages of the table. A cell is certified if all pages and the
/// curve are in its tet. The result does not depend on the number of threads.
DomainMesh domain_cells(const TensorField& input, const RefinedComplex& complex,
                        const EdgeCrossings& crossings, const FaceSpinePoints& spine_points);

/// The pages of a table, and the curve in which they end: what a cell's certificate rests on.
FeatureSet book_of(const FeatureTable& table);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "triplex/quadric/quadric_extraction.hpp"
#include "triplex/topology/surface_topology.hpp"
#include "triplex/verify/audit.hpp"

namespace triplex {

/// The topology of one surface from two roads: as quadrics of the input's tets, and as a mesh.
struct QuadricComparison {
  std::uint64_t compared = 0;  ///< cells of the input in which either road has the surface
  std::uint64_t left_out = 0;  ///< cells with a contact or an unmeshed patch, or open in the mesh
  std::vector<std::int64_t> differing;  ///< cells compared that differ, ascending
  SurfaceTopology quadrics, mesh;       ///< of the whole surfaces
  /// Nothing was left out: then the two must agree as a whole, too.
  bool complete() const { return left_out == 0; }
  bool agree() const {
    return differing.empty() && (!complete() || (quadrics.components == mesh.components &&
                                                 quadrics.euler == mesh.euler &&
                                                 quadrics.boundary_loops == mesh.boundary_loops));
  }
};

/// Compares components, Euler number and boundary loops cell by cell of the input, and as a whole.
/// `open`: the cells, in any order, that the mesh does not vouch for. A perturbation that is small
/// enough changes nothing in a tet without contact, so a mesh of the field T + eps B must agree.
/// Source: proofs/quadric_patches.md. \pre triangles lie in their source cells.
QuadricComparison compare_quadrics(const TensorField& field, const QuadricExtraction& quadrics,
                                   const FeatureMesh& mesh, std::span<const std::int64_t> open);

/// The same for the linear or the planar part of a balanced surface: `quadrics` with the part as
/// its mesh. Cells in which the curve meets an edge or the split is not proven are left out, too.
QuadricComparison compare_part(const TensorField& field, const QuadricExtraction& quadrics,
                               const FeatureMesh& mesh, std::span<const std::int64_t> open);

struct MergedMesh {
  FeatureMesh mesh;                     ///< points, triangles, source_cell and certified only
  std::vector<std::int64_t> ambiguous;  ///< cells, ascending, where points could not be paired
};

/// Two meshes as one, with a point of each as one where they have the same coordinates: the linear
/// and planar part of a surface, which share their common curve. Where more than two points
/// coincide (the curve passes within rounding of a vertex) they stay apart, and the cells are
/// named.
MergedMesh merged(const FeatureMesh& a, const FeatureMesh& b);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/quadric/quadric_type.hpp"
#include "triplex/quadric/tet_cut.hpp"

namespace triplex::detail {

/// A tet that a filter in doubles could not call empty; vertices, and so edges and faces, ascend.
struct CutTet {
  TetId tet{};
  std::array<VertexId, 4> vertices{};
  bool flipped = false;  ///< the ascending order is negatively oriented
  std::array<std::uint32_t, 6> edges{};
  std::array<std::uint32_t, 4> faces{};
  TetCut cut;
  QuadricType type = QuadricType::Empty;  ///< where the cut has patches or is not transverse

  bool reported() const { return !cut.transverse || !cut.patches.empty(); }
};
struct CutMeshEdge {
  std::array<VertexId, 2> vertices{};
  EdgeCut cut;
};
struct CutMeshFace {
  std::array<VertexId, 3> vertices{};
  std::array<std::uint32_t, 3> edges{};
  FaceCut cut;
};

/// What a quadric surface is on the simplices of a mesh: every edge and face decided once, exactly.
struct CutMesh {
  std::vector<CutMeshEdge> edges;  ///< by vertices
  std::vector<CutMeshFace> faces;
  std::vector<CutTet> tets;  ///< in the order of the mesh
};

/// Runs in the caller's task arena; the result does not depend on the number of threads.
CutMesh cut_mesh(const TensorField& field, const QuadricSurface& surface);

template <int N>
std::array<EdgeCut, N> cuts_of(const std::vector<CutMeshEdge>& edges,
                               const std::array<std::uint32_t, N>& chosen) {
  std::array<EdgeCut, N> cuts;
  for (int k = 0; k < N; ++k) cuts[k] = edges[chosen[k]].cut;
  return cuts;
}

}  // namespace triplex::detail

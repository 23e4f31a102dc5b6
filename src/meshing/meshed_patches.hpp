// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshed_arcs.hpp"
#include "triangulate_patch.hpp"

namespace triplex {

/// A vertex along the boundary of patches: a corner, or a point between the ends of an arc.
struct OutlineVertex {
  static constexpr std::uint32_t kNone = 0xffffffff;
  std::uint32_t number = 0;     ///< of the arc, or of the corner
  std::uint32_t point = kNone;  ///< of the arc; none at a corner

  bool is_corner() const { return point == kNone; }
};

/// What a patch says of each of its vertices.
struct VertexValues {
  Vector normal;
  double p = 0, q = 0;  ///< of the deviator, in the units of the input
};

/// One patch with its triangles: vertices are the outline's, then those inside.
struct MeshedPatch {
  std::vector<OutlineVertex> outline;
  std::vector<Point> inside;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<VertexValues> values;
  std::vector<Tensor<double>> tensors;  ///< T; empty unless asked for
  double error = 0;                     ///< see `FeatureMesh::error_bound`
  double vertex_error = 0;              ///< of the vertices inside
  bool is_tangled = false;              ///< see `PatchTriangles`
};

/// The chart of a patch: across the mean gradient at its corners, else the best one.
std::optional<Chart> chart_of(const PatchComplex& complex, const Patch& patch, const CellMap& cell,
                              const SurfaceFunction& f);

MeshedPatch mesh_patch(const PatchComplex& complex, const MeshedArcs& arcs, const Patch& patch,
                       const SurfaceFunction& f, double tolerance, bool keep_tensors);

}  // namespace triplex

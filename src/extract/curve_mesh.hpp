// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/certify/degenerate_arc.hpp"
#include "triplex/extract/extraction.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {

/// Puts the polylines of degenerate curves together, tet by tet: first the points on faces, shared
/// by both tets, then those inside.
class CurveMeshBuilder {
 public:
  CurveMeshBuilder(const TensorField& input, const RefinedComplex& complex,
                   const std::vector<std::array<VertexId, 3>>& faces,
                   const std::vector<FacePoints>& points, bool keep_tensors);

  /// The arcs of a tet; they number the points of its faces, one face after the other.
  void add(TetId tet, const std::array<VertexId, 4>& vertices,
           const std::array<std::uint32_t, 4>& faces, const std::vector<DegenerateArc>& arcs);

  /// All of one feature.
  FeatureMesh take(Feature feature);

 private:
  FeatureMesh& mesh(Feature feature) { return meshes_[feature == Feature::DegeneratePlanar]; }
  std::uint32_t add_vertex(FeatureMesh& mesh, std::span<const VertexId> corners,
                           std::span<const double> weights) const;
  void identify_copies();

  const TensorField& input_;
  const RefinedComplex& complex_;
  const std::vector<std::array<VertexId, 3>>& faces_;
  const std::vector<FacePoints>& points_;
  const bool keep_tensors_;
  std::vector<std::uint32_t> point_of_;             // vertex of the complex -> point of the input
  std::vector<std::vector<std::uint32_t>> number_;  // face, point on it -> vertex of its mesh
  std::array<FeatureMesh, 2> meshes_;               // linear, planar
};

}  // namespace triplex

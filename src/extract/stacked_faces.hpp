// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "face_arcs.hpp"
#include "triplex/certify/stacked_sheets.hpp"

namespace triplex {

/// How arcs join the crossings on the faces with an edge that a page crosses twice, the same for
/// the tets on both sides.
class StackedFaces {
 public:
  StackedFaces() = default;  ///< no edge is crossed twice
  StackedFaces(const RefinedComplex& complex, const EdgeCrossings& crossings,
               const std::vector<std::uint32_t>& active_leaves, SignStages& stages);

  /// Nothing where the page crosses no edge of the face twice, or no pairing is proven: then two
  /// crossings of one edge are joined to each other. \pre the vertices ascend.
  const FacePairing* find(const std::array<VertexId, 3>& face, Feature page) const;
  bool empty() const { return faces_.empty(); }

 private:
  struct Face {
    std::array<VertexId, 3> vertices;
    Feature page;
    FacePairing pairing;
  };
  std::vector<Face> faces_;  // sorted
};

/// Opens the tets around edges crossed twice where a pairing is missing, or where the triangles
/// drawn are not the surface of the patches. A patch with two corners is drawn as the segment
/// between them, which is right if both are corners of other patches, and if no more than two
/// triangles meet along any segment. Source: proofs/stacked_sheets.md.
void open_collapsed_stacks(const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                           const StackedFaces& stacks,
                           const std::vector<std::uint32_t>& active_leaves,
                           RefinedComplex& complex);

}  // namespace triplex

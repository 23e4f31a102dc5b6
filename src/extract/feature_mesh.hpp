// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cell_patches.hpp"
#include "joined_crossings.hpp"
#include "triplex/extract/extraction.hpp"

namespace triplex {

/// The patches of all active tets joined to one indexed mesh per requested feature.
/// Vertices are numbered by edge, then by face; loops become fans (quadrilaterals along the
/// diagonal between those opposite edges of the tet whose middles are nearer).
class FeatureMeshBuilder {
 public:
  FeatureMeshBuilder(const TensorField& input, const RefinedComplex& complex,
                     const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                     const StackedFaces& stacks, bool keep_tensors);

  struct Built {
    std::vector<FeatureMesh> meshes;  ///< one per row of the table
    ContractionStatistics contraction;
  };
  /// `contracted`: without edges of the size of rounding, where that changes no topology.
  Built build(const std::vector<std::uint32_t>& active_leaves, FeatureSet features,
              bool contracted) const;

 private:
  struct Cell {  // a triangle or, with two vertices, a segment
    std::array<PatchVertex, 3> vertices;
    std::int64_t source;
    bool certified;
  };
  using Cells = std::vector<std::vector<Cell>>;  // per row of the table

  void add_leaf(const Leaf& leaf, FeatureSet features, CellPatches& patches, Cells& cells) const;
  void add_fan(const PatchLoop& loop, const Leaf& leaf, std::vector<Cell>& out) const;
  /// Vertices over all features: those on edges, then those on faces.
  std::uint32_t common_number(const PatchVertex& v) const {
    return v.on_spine ? static_cast<std::uint32_t>(crossings_.crossings().size()) + v.number
                      : v.number;
  }
  std::vector<std::uint32_t> ends_of_short_edges(const std::vector<Cells>& parts,
                                                 double reach) const;
  /// Source: proofs/contraction.md.
  ContractionStatistics contract(std::vector<Cells>& parts) const;
  void drop_collapsed(std::vector<Cells>& parts) const;
  FeatureMesh assemble(Feature feature, const std::vector<Cells>& parts) const;
  Point position(const PatchVertex& v) const;
  void add_vertex(Feature feature, const PatchVertex& v, FeatureMesh& mesh) const;
  std::array<double, 3> invariants(Feature feature, const PatchVertex& v) const;
  Tensor<double> tensor(const PatchVertex& v) const;
  PatchVertex lowest_copy(Feature feature, const PatchVertex& v) const;
  std::vector<std::uint32_t> copies_of_vertex(std::uint32_t crossing) const;

  const TensorField& input_;
  const RefinedComplex& complex_;
  const FeatureTable& table_;
  const EdgeCrossings& crossings_;
  const FaceSpinePoints& spine_points_;
  const StackedFaces& stacks_;
  const bool keep_tensors_;
  const JoinedCrossings joined_;
};

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/verify/audit.hpp"

namespace triplex::detail {

/// The triangles (or segments) of a mesh, grouped by the cell of the input they lie in.
class SourcePieces {
 public:
  explicit SourcePieces(const FeatureMesh& mesh);

  bool is_curve() const { return mesh_->triangles.empty() && !mesh_->segments.empty(); }
  const FeatureMesh& mesh() const { return *mesh_; }
  /// The cells that hold some, ascending.
  const std::vector<std::int64_t>& cells() const { return cells_; }
  /// Those in a cell: numbers of triangles or segments. Empty for a cell that holds none.
  std::span<const std::uint32_t> in(std::int64_t cell) const;
  PieceTopology topology_in(std::int64_t cell) const;

 private:
  const FeatureMesh* mesh_;
  std::vector<std::uint32_t> order_;  // by cell
  std::vector<std::int64_t> cells_;
  std::vector<std::size_t> begin_;  // per cell, and the end
};

}  // namespace triplex::detail

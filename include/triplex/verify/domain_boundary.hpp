// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// The boundary of the domain of a field, where surfaces may end.
class DomainBoundary {
 public:
  /// \pre the field passed `check_input`; it must outlive this object. Cost: that of sorting the
  /// faces of the tets.
  explicit DomainBoundary(const TensorField& field);

  /// The edges of a mesh that lie on it: pairs of points, ascending, sorted. An edge counts if both
  /// its ends are within 1e-9, in barycentric coordinates, of one boundary face of the cell of the
  /// input that its triangle lies in; in doubles. \pre triangles lie in their source cells.
  std::vector<std::array<std::uint32_t, 2>> edges_of(const FeatureMesh& mesh) const;

 private:
  struct BoundaryTet {
    std::int64_t source_cell;
    TetId tet;
    std::uint8_t faces;  ///< bit i: the one opposite to vertex i
  };
  const TensorField* field_;
  std::vector<BoundaryTet> tets_;  ///< with faces on the boundary, by cell
};

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// Ids are opaque so that a vertex is never taken for a tet; `index` gives the array subscript.
enum class VertexId : std::uint32_t {};
enum class TetId : std::uint32_t {};
constexpr std::size_t index(VertexId v) { return static_cast<std::size_t>(v); }
constexpr std::size_t index(TetId t) { return static_cast<std::size_t>(t); }

/// A conforming tetrahedral mesh. Tets are positively oriented: (b-a) x (c-a) . (d-a) > 0.
struct TetMesh {
  std::vector<Point> points;
  std::vector<std::array<VertexId, 4>> tets;
};

/// How many cells of a file that were no tets were cut into tets.
struct SplitCounts {
  std::size_t hexahedra = 0;  ///< voxels too
  std::size_t wedges = 0;
  std::size_t pyramids = 0;
  std::size_t total() const { return hexahedra + wedges + pyramids; }
};

/// A tensor at every vertex of a tet mesh, interpolated linearly in each tet.
/// Guarantee for the layers above: it passed `check_input` (finite, conforming, oriented, no
/// duplicates). Doubles are exact dyadic rationals, so this *is* the exact field.
struct TensorField {
  TetMesh mesh;
  std::vector<Tensor<double>> tensors;  ///< one per point, row-major
  std::string array_name;               ///< name of the point array the tensors came from
  /// Cell id in the input file of each tet (they differ where cells were skipped or split; the tets
  /// of a split cell are neighbours in the list). Empty: identity.
  std::vector<std::int64_t> source_cells;
  SplitCounts split;

  /// Cell id in the input file of a tet.
  std::int64_t source_cell(TetId tet) const {
    return source_cells.empty() ? static_cast<std::int64_t>(index(tet)) : source_cells[index(tet)];
  }
};

}  // namespace triplex

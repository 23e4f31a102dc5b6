// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// The faces of a tet, seen from outside counter-clockwise; face i is opposite to vertex i.
inline constexpr int kTetFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// A face as one tet sees it. Its lowest vertex is known from the place in the table.
struct HalfFace {
  std::uint32_t middle;  ///< second lowest vertex
  std::uint32_t high;    ///< highest vertex
  std::uint64_t
      code;  ///< 8 tet + 2 face + (outward order is an even permutation of the sorted one)

  std::size_t tet() const { return code >> 3; }
  int face() const { return static_cast<int>(code >> 1 & 3); }
  bool even() const { return (code & 1) != 0; }
  bool same_face(const HalfFace& other) const {
    return middle == other.middle && high == other.high;
  }
};

/// All half faces of a mesh, grouped by their lowest vertex; in a group sorted by the other
/// vertices and then by tet, so that half faces of one face are neighbours.
class HalfFaceTable {
 public:
  /// \pre vertex ids are in range and differ within each tet.
  explicit HalfFaceTable(const TetMesh& mesh);
  std::size_t groups() const { return begin_.size() - 1; }
  std::span<const HalfFace> group(std::size_t vertex) const {
    return {faces_.data() + begin_[vertex], begin_[vertex + 1] - begin_[vertex]};
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<HalfFace> faces_;
};

/// A face that belongs to one tet only.
struct BoundaryFace {
  std::array<std::uint32_t, 3> vertices;  ///< ascending
  std::size_t tet;
};

/// Checks the combinatorics of the faces of a mesh whose tets are positively oriented: no tet
/// twice, at most two tets per face, on opposite sides. Returns the boundary faces in ascending
/// order of their vertices. \throw BadInput.
std::vector<BoundaryFace> check_faces(const TensorField& field);

/// Checks that any two boundary faces meet in the simplex of their common vertices and nowhere
/// else. Exact. \throw BadInput naming the first vertex found in a face, or the first two faces
/// that cross.
void check_boundary(const TensorField& field, const std::vector<BoundaryFace>& boundary);

}  // namespace triplex::detail

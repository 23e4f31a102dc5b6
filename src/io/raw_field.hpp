// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex::detail {

/// A field as it stands in a file: not checked beyond types, sizes and ranges of ids.
struct RawField {
  TensorField field;
  /// One per point if the tensors are to be their gradient; then there are no tensors yet.
  std::vector<Point> vectors;
  /// 1 for points that another piece owns. Empty if no point is flagged.
  std::vector<std::uint8_t> copies;
  bool pieces = false;  ///< it consists of pieces, with points of their own
};

/// 1 for points that tets use.
std::vector<std::uint8_t> used_points(const TetMesh& mesh);

/// For every point that a tet uses, the point that stands for all used points with its coordinates:
/// the first of those that their piece owns, else the first. Unused points stand for themselves.
/// \throw BadInput if `agree(a, b)` is false for two of them, unless only one is owned; `what` is
/// what they differ in, in the plural.
std::vector<VertexId> joined_points(const RawField& raw,
                                    const std::function<bool(std::size_t, std::size_t)>& agree,
                                    std::string_view what);

/// Makes one mesh of the pieces of a partitioned file: joins points with equal coordinates and
/// tensors, leaves out repeated cells. Points that no tet uses stay in the list, so that ids are
/// those of the file, but without meaning. \throw BadInput if tensors differ.
TensorField join_pieces(RawField raw);

/// Gives points that no tet uses finite coordinates and tensors.
void clear_unused_points(TensorField& field);

}  // namespace triplex::detail

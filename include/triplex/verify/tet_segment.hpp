// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "triplex/feature/feature_table.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// A point of a tet by four weights that add up to 2^kWeightBits: its barycentric coordinates are
/// dyadic rationals, so the tensor there is known exactly.
using TetWeights = std::array<std::int64_t, 4>;
inline constexpr int kWeightBits = 40;

/// The point with nearly these barycentric coordinates; what is outside the tet is moved into it.
TetWeights weights_near(const std::array<double, 4>& barycentric);
/// Its position; rounded.
Point position_of(const TensorField& field, TetId tet, const TetWeights& weights);

/// A segment between two points of a tet.
struct TetSegment {
  TetId tet{};
  std::array<TetWeights, 2> ends{};
};

struct SegmentCrossing {
  double t = 0;        ///< in (0,1) along the segment; rounded
  bool rises = false;  ///< the function whose zero set the sheet is grows there
};

/// Where a surface of the table crosses a segment, in order. The function is p, q, 2 P^3 + 3 Q^2
/// (times -4 the discriminant, of the mapped invariants on a mode page), |T|^2 - s^2, tr^2 - 3
/// eta^2 |T|^2 or tr.
/// Guarantee: exact, by isolation of all roots of that function on the segment and the sign of the
/// other invariant at each. Nothing is returned where the answer hangs on a tie: a root at an end,
/// a multiple root, a root on the triple degenerate curve, a function that vanishes throughout.
/// It shares no code with the certificates but the evaluation of the invariants' coefficients.
/// \pre f is a surface.
std::optional<std::vector<SegmentCrossing>> crossings_on(const TensorField& field,
                                                         const FeatureTable& table, Feature f,
                                                         const TetSegment& segment);

/// How often (p, q) turns around the origin along the boundary of the triangle: where that is not
/// zero the triple degenerate curve meets the triangle, and generically its parity is that of
/// the number of points. Nothing on a tie. Source: degree theory, proofs/winding.md.
std::optional<int> winding_on(const TensorField& field, TetId tet,
                              const std::array<TetWeights, 3>& triangle);

}  // namespace triplex

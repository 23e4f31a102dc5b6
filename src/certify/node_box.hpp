// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {

/// (x_1, x_2, x_3, l) in doubles.
using NodePoint = std::array<double, 4>;

/// Newton's iteration for the four minors through the largest entry of A - l I, in doubles. What it
/// returns is a guess.
std::optional<NodePoint> newton_approx(const std::array<Tensor<double>, 4>& tensors,
                                       NodePoint start);

/// Proves a node of a linear field near a guess, by Krawczyk's operator in intervals.
/// Guarantee: the domain holds exactly one node, and that is in the box. Source: proofs/node.md.
class NodeProof {
 public:
  explicit NodeProof(const std::array<Tensor<Exact>, 4>& tensors);

  /// The largest domain that the operator can prove, of half widths 2^-k (k >= 0) and 2^-k times
  /// the variation of the field; the box is tightened to rounding level.
  std::optional<IsolatedNode> prove(const NodePoint& guess) const;

 private:
  std::array<std::array<Range, 9>, 4> tensors_;  // A_0 and the differences A_k - A_0
  std::array<Tensor<double>, 4> approximate_;
  double variation_ = 0;
};

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/sign.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {

/// A part of a tet: the tripled deviators at its corners, in doubles with bounds, and the corners'
/// barycentric coordinates in the whole, exact.
struct NodeCell {
  std::array<Tensor<double>, 4> tensors;
  EntryBounds bounds;
  std::array<std::array<double, 3>, 4> corners;
  std::array<int, 4> bits{};  ///< corner i is a multiple of 2^-bits[i]
  int level = 0;              ///< bisections
};

/// The eigenvalues l that a node in the cell may have, of one sign: -6 l^2 is in the range of P.
/// Nothing if there can be no node. \pre bounds.usable().
std::optional<Range> eigenvalue_range(const NodeCell& cell, Sign sign);

/// Proves that the cell holds no node with an eigenvalue in the range: a plane through the origin
/// has all Bernstein coefficients of adj(A - l I) strictly on one side.
/// Source: proofs/node.md. \pre bounds.usable().
bool excludes_node(const NodeCell& cell, const Range& eigenvalue);

}  // namespace triplex

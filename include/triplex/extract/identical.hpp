// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// What may hold at all points of a simplex of the input. The first four exclude each other.
enum class Identity : std::uint8_t {
  TripleDegenerate,  ///< p = q = 0
  Degenerate,        ///< D = 0, p and q not
  Balanced,          ///< p = 0, q not
  Neutral,           ///< q = 0, p not
  BlockX,            ///< the tensor splits into x and the yz-plane: entries xy, xz, yx, zx are zero
  BlockY,
  BlockZ,
  Symmetric,
};
inline constexpr int kIdentities = 8;
using IdentitySet = std::uint8_t;
constexpr IdentitySet bit(Identity i) {
  return static_cast<IdentitySet>(1u << static_cast<unsigned>(i));
}
/// triple-degenerate, degenerate, balanced, neutral, block-x, block-y, block-z, symmetric.
std::string_view name_of(Identity identity);

/// A tet, a face or an edge of the input on which something holds that does not hold on a larger
/// simplex around it.
struct IdenticalSimplex {
  std::array<std::uint32_t, 4> points{};  ///< of `IdenticalSimplices::points`, the first `vertices`
  std::uint8_t vertices = 0;              ///< 4, 3 or 2
  IdentitySet holds = 0;                  ///< what holds here and on no larger simplex
  bool on_boundary = false;               ///< of the mesh; false for tets
};

/// How many simplices of one dimension, and their length, area or volume in units of the points
/// (rounded, not certified).
struct IdenticalTally {
  std::uint64_t count = 0, on_boundary = 0;
  double measure = 0, measure_on_boundary = 0;
};

struct IdenticalSimplices {
  std::vector<Point> points;
  /// Tets, then faces, then edges, each by the coordinates of their vertices; without those on
  /// which the tensors are symmetric and nothing else holds.
  std::vector<IdenticalSimplex> simplices;
  /// By identity and dimension. Blocks are counted on tets and faces, symmetry on tets only. In
  /// dimension 0: vertices where the invariants vanish, on no larger such simplex.
  std::array<std::array<IdenticalTally, 4>, kIdentities> tallies{};
  /// Per point of the input: what holds on the simplices listed around it.
  std::vector<IdentitySet> at_points;

  const IdenticalTally& tally(Identity identity, int dimension) const {
    return tallies[static_cast<std::size_t>(identity)][static_cast<std::size_t>(dimension)];
  }
};

/// The simplices of the input on which p, q or D vanish identically or the tensor splits along a
/// coordinate axis.
/// Guarantee: exact, for the field as it is (not perturbed); all and only those. Costs a filter per
/// vertex and a look at each tet where no vertex has an exact zero. Does not depend on threads.
/// Source: proofs/identical.md. \pre `field` was made from `input`.
IdenticalSimplices find_identical(const TensorField& input, const RefinableField& field);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace triplex {

/// A surface of the field that is the preimage of the boundary of an open convex set K of tensors.
/// A linear field takes a simplex to a flat simplex in tensor space, so K meets it in a convex set:
/// all that the certificate of these features rests on (proofs/level_set.md).
struct LevelSet {
  enum class Kind : std::uint8_t {
    Magnitude,     ///< K: |T| < value, value > 0, in tensor units
    Isotropicity,  ///< K: sign(value) tr(T) > sqrt(3) |value| |T|, 0 < |value| < 1
    Traceless,     ///< K: tr(T) > 0; isotropicity zero
  };
  Kind kind = Kind::Traceless;
  double value = 0;

  friend bool operator==(const LevelSet&, const LevelSet&) = default;
};

}  // namespace triplex

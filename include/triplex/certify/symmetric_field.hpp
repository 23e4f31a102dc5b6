// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// Which field of symmetric tensors is meant: T as it is, or T + delta (B + 2^-20 B_v), which is in
/// general position. B is the symmetric tensor of the upper triangle of `kPerturbation`, B_v that
/// of `own_shift` at the vertex v, linear between vertices; delta = 2^-96, in units of the power of
/// two above the largest entry of the field (`RefinableField::scale_exponent`). Source:
/// proofs/symmetric_curve.md.
enum class Shift : std::uint8_t { None, General };
inline constexpr int kShiftExponent = -96, kOwnShiftBits = 20;

/// Integers in [-512, 511], a symmetric tensor, from the number of a vertex.
std::array<int, 9> own_shift(VertexId v);

/// A field of symmetric tensors with its shift. \pre it outlives this, and all tensors are
/// symmetric.
class SymmetricField {
 public:
  /// `representatives`: per vertex of the input, one that stands for it and all its periodic
  /// copies. Empty: no copies.
  explicit SymmetricField(const RefinableField& field, Shift shift = Shift::None,
                          std::span<const VertexId> representatives = {})
      : field_(&field), shift_(shift), representatives_(representatives) {}

  const RefinableField& field() const { return *field_; }
  Shift shift() const { return shift_; }
  VertexId representative(VertexId v) const {
    return representatives_.empty() ? v : representatives_[index(v)];
  }

 private:
  const RefinableField* field_;
  Shift shift_;
  std::span<const VertexId> representatives_;
};

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "triplex/arithmetic/sign.hpp"
#include "triplex/feature/feature.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// The six domains as sectors of the (p, q) plane, counter-clockwise; sector k lies between page k
/// and page k + 1 (mod 6).
enum class Sector : std::uint8_t {
  InnerComplexLinear = 0,  ///< p > 0, q > 0
  OuterComplexLinear = 1,  ///< p < 0, q > 0, D < 0
  RealLinear = 2,          ///< p < 0, q > 0, D > 0
  RealPlanar = 3,          ///< p < 0, q < 0, D > 0
  OuterComplexPlanar = 4,  ///< p < 0, q < 0, D < 0
  InnerComplexPlanar = 5,  ///< p > 0, q < 0
};
constexpr int index(Sector s) { return static_cast<int>(s); }
constexpr Sign sign_p(Sector s) {
  return s == Sector::InnerComplexLinear || s == Sector::InnerComplexPlanar ? Sign::Positive
                                                                            : Sign::Negative;
}
constexpr Sign sign_q(Sector s) { return index(s) <= 2 ? Sign::Positive : Sign::Negative; }

/// The sector of the perturbed field T + eps B at a vertex: the signs of p, q and, for p < 0, of D.
/// Guarantee: exact. Nothing is returned if the perturbation leaves one of these signs open.
/// Laws: A -> A^T keeps it; A -> -A maps sector k to 5 - k (for nonzero signs); scaling keeps it.
/// Source: proofs/vertex.md.
std::optional<Sector> sector_at(const RefinableField& field, VertexId v, SignStages& stages);

}  // namespace triplex

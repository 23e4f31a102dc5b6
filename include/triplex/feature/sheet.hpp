// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "triplex/arithmetic/sign.hpp"

namespace triplex {

/// The map (P, Q) -> (p_factor P, q_factor Q). It takes a mode page to a degenerate one: with mu =
/// n/d and the factors -sign(p) n^2 and d n^2, the page 3 d^2 Q^2 = 2 n^2 |P|^3 becomes
/// 3 Q^2 = -2 P^3. Integers below 2^53, so exact in every ring. Source: proofs/mode_page.md.
struct ModeMap {
  double p_factor = 1, q_factor = 1;

  bool is_identity() const { return p_factor == 1 && q_factor == 1; }
  friend bool operator==(const ModeMap&, const ModeMap&) = default;
};

/// A smooth sheet that carries pages: a C^1 level set f = 0. For a curved sheet, seen through its
/// map, f is G = q - s 2 v^3, s = sign(q), v = sqrt(max(0,-p)/3); where the page ends, at p = 0, it
/// goes on as a neutral surface.
struct Sheet {
  enum class Kind : std::uint8_t { Balanced, Neutral, Curved };
  Kind kind = Kind::Balanced;
  Sign sign_p = Sign::Zero, sign_q = Sign::Zero;  ///< of the page on a curved sheet
  ModeMap map{};                                  ///< of a curved sheet
};
inline constexpr int kFlatSheets = 2;  ///< Balanced and Neutral, first in every table
inline constexpr int kBalancedSheet = 0, kNeutralSheet = 1;

}  // namespace triplex

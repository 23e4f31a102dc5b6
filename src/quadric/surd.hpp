// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/exact.hpp"

namespace triplex::detail {

/// The sign of u + v sqrt(d). \pre d > 0.
inline Sign sign_of_surd(const Exact& u, const Exact& v, const Exact& d) {
  const Sign su = sign(u), sv = sign(v);
  if (su == Sign::Zero || su == sv) return sv == Sign::Zero ? su : sv;
  if (sv == Sign::Zero) return su;
  return su * sign(u * u - v * v * d);  // opposite signs: the larger one wins
}

}  // namespace triplex::detail

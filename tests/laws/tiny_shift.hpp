// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex::test {

/// The tripled deviator of eps B, in the units of the input, with eps = 2^-1000 times the size of
/// the field: far beyond the bits of what decides anything, which are at most sixteenth powers of
/// dyadic numbers of some fifty bits.
inline Tensor<Exact> tiny_shift(const RefinableField& field) {
  Exact eps(0x1p-1000);
  int exponent = -field.scale_exponent();
  for (; exponent > 1000; exponent -= 1000) eps = eps * Exact(0x1p1000);
  for (; exponent < -1000; exponent += 1000) eps = eps * Exact(0x1p-1000);
  eps = eps * Exact(std::ldexp(1.0, exponent));
  Tensor<Exact> shift;
  for (std::size_t k = 0; k < 9; ++k) shift[k] = Exact(kPerturbation[k]) * eps;
  return triple_deviator(shift);
}

}  // namespace triplex::test

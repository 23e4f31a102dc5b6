// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/arithmetic/exact.hpp"

namespace triplex {

/// Power series in a positive infinitesimal eps, kept modulo eps^K: c_0 + c_1 eps + ... .
/// Truncation is a ring homomorphism, so the kept coefficients of sums and products are exact.
/// Laws: sign(x) is the sign of the lowest nonzero coefficient, that is the sign of x for every
/// small enough eps > 0; `Zero` means that all K kept coefficients vanish and says nothing more.
template <int K>
class Series {
 public:
  Series() = default;
  Series(int c) { c_[0] = Exact(c); }     // NOLINT: ring constants
  Series(double c) { c_[0] = Exact(c); }  // NOLINT
  Series(const Exact& c) { c_[0] = c; }   // NOLINT
  Series(const Exact& c, const Exact& first_order) {
    c_[0] = c;
    c_[1] = first_order;
  }

  const Exact& coefficient(int k) const { return c_[static_cast<std::size_t>(k)]; }

  friend Series operator+(Series a, const Series& b) {
    for (int k = 0; k < K; ++k) a.c_[k] = a.c_[k] + b.c_[k];
    return a;
  }
  friend Series operator-(Series a, const Series& b) {
    for (int k = 0; k < K; ++k) a.c_[k] = a.c_[k] - b.c_[k];
    return a;
  }
  friend Series operator-(const Series& a) { return Series() - a; }
  friend Series operator*(const Series& a, const Series& b) {
    Series r;
    for (int i = 0; i < K; ++i) {
      if (a.c_[i].is_zero()) continue;
      for (int j = 0; i + j < K; ++j) {
        if (!b.c_[j].is_zero()) r.c_[i + j] = r.c_[i + j] + a.c_[i] * b.c_[j];
      }
    }
    return r;
  }
  friend Sign sign(const Series& x) {
    for (const Exact& c : x.c_) {
      if (!c.is_zero()) return triplex::sign(c);
    }
    return Sign::Zero;
  }

 private:
  std::array<Exact, K> c_;
};

/// Enough coefficients for every test on a simplex with N vertices to be kept whole: tests have
/// degree six in the tensor (the discriminant), on an edge sixteen (q at the root of p).
template <int N>
using Perturbed = Series<N == 2 ? 17 : 7>;

/// The direction B of the perturbation T + eps B. Translations by a constant tensor act
/// transitively on tensors, so for almost every B the perturbed field is transverse to all strata
/// on every simplex; this one was drawn once (integers below 2^10) and is part of the meaning of
/// the output. It has no symmetry and a trace. Source: proofs/perturbation.md.
inline constexpr std::array<int, 9> kPerturbation = {617, -283, 431, 149, -907,
                                                     761, -359, 523, 211};

}  // namespace triplex

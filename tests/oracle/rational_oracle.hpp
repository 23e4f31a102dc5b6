// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include "triplex/arithmetic/sign.hpp"
#include "triplex/bernstein/tensor_array.hpp"

/// Exact rational oracle for the invariants of a single tensor, straight from their definitions.
namespace triplex::oracle {

template <class NT>
Sign sign_of(const NT& x) {
  return x > 0 ? Sign::Positive : x < 0 ? Sign::Negative : Sign::Zero;
}

struct RationalInvariants {
  mpq_class p, q, d;
};

inline Tensor<mpq_class> rational(const Tensor<double>& t) {
  Tensor<mpq_class> r;
  for (int i = 0; i < 9; ++i) r[i] = mpq_class(t[i]);
  return r;
}

/// Sum of the principal minors, determinant and discriminant of T - tr(T)/3 I.
inline RationalInvariants rational_invariants(const Tensor<mpq_class>& t) {
  const mpq_class mean = (t[0] + t[4] + t[8]) / 3;
  Tensor<mpq_class> a = t;
  for (const int i : {0, 4, 8}) a[i] -= mean;
  RationalInvariants r;
  r.p = a[0] * a[4] - a[1] * a[3] + a[4] * a[8] - a[5] * a[7] + a[8] * a[0] - a[2] * a[6];
  r.q = a[0] * a[4] * a[8] + a[1] * a[5] * a[6] + a[2] * a[3] * a[7] - a[2] * a[4] * a[6] -
        a[1] * a[3] * a[8] - a[0] * a[5] * a[7];
  r.d = -4 * r.p * r.p * r.p - 27 * r.q * r.q;
  return r;
}
inline RationalInvariants rational_invariants(const Tensor<double>& t) {
  return rational_invariants(rational(t));
}

}  // namespace triplex::oracle

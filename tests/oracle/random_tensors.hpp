// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <random>

#include "triplex/bernstein/tensor_array.hpp"

/// Random tensors for tests, generic ones and ones on a stratum by construction. Seeds are the
/// caller's, so every run is the same.
namespace triplex::oracle {

using Random = std::mt19937_64;

inline double integer(Random& random, int range) {
  return std::uniform_int_distribution<int>(-range, range)(random);
}

inline Tensor<double> integer_tensor(Random& random, int range) {
  Tensor<double> t;
  for (double& x : t) x = integer(random, range);
  return t;
}

inline Tensor<double> double_tensor(Random& random) {
  Tensor<double> t;
  for (double& x : t) x = std::uniform_real_distribution<double>(-1, 1)(random);
  return t;
}

inline Tensor<double> product(const Tensor<double>& a, const Tensor<double>& b) {
  Tensor<double> c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) c[3 * i + j] += a[3 * i + k] * b[3 * k + j];
  return c;
}

inline Tensor<double> scaled(Tensor<double> t, int exponent) {
  for (double& x : t) x = std::ldexp(x, exponent);
  return t;
}

inline Tensor<double> transposed(const Tensor<double>& t) {
  return {t[0], t[3], t[6], t[1], t[4], t[7], t[2], t[5], t[8]};
}

inline Tensor<double> negated(Tensor<double> t) {
  for (double& x : t) x = -x;
  return t;
}

/// S T S^-1 with S a product of three elementary integer shears: exact as long as entries stay
/// small.
inline Tensor<double> similar(Random& random, Tensor<double> t, int range = 3) {
  for (int n = 0; n < 3; ++n) {
    const int i = std::uniform_int_distribution<int>(0, 2)(random);
    const int j = (i + std::uniform_int_distribution<int>(1, 2)(random)) % 3;
    Tensor<double> s = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    Tensor<double> inverse = s;
    s[3 * i + j] = integer(random, range);
    inverse[3 * i + j] = -s[3 * i + j];
    t = product(product(s, t), inverse);
  }
  return t;
}

/// The kinds of exactly degenerate tensors.
enum class Kind {
  Zero,        ///< T = 0
  Isotropic,   ///< a multiple of the identity
  Nilpotent,   ///< p = q = 0, rank 1 or 2
  Degenerate,  ///< a double eigenvalue, p < 0, one eigenvector
  Derogatory,  ///< a double eigenvalue with a two-dimensional eigenspace
  Neutral,     ///< q = 0
  Balanced,    ///< p = 0
  Symmetric,
  Antisymmetric,  ///< q = 0, p > 0
  RepeatedRows,
  FewDistinct,  ///< entries from {-1, 0, 1}: all strata at once
};
inline constexpr int kKinds = 11;

/// A tensor of the kind, with small integer entries, conjugated by integer shears where it has to
/// leave its normal form, plus a random integer multiple of the identity.
inline Tensor<double> degenerate_tensor(Random& random, Kind kind) {
  const auto d = [&](int range = 5) { return integer(random, range); };
  Tensor<double> t{};
  switch (kind) {
    case Kind::Zero:
      return t;
    case Kind::Isotropic:
      break;
    case Kind::Nilpotent:
      t = similar(random, {0, d(2), d(2), 0, 0, d(2), 0, 0, 0});
      break;
    case Kind::Degenerate: {
      const double a = d();
      t = similar(random, {a, d(2), d(2), 0, a, d(2), 0, 0, -2 * a});
      break;
    }
    case Kind::Derogatory: {
      const double a = d();
      t = similar(random, {a, 0, d(2), 0, a, d(2), 0, 0, -2 * a});
      break;
    }
    case Kind::Neutral: {
      const double a = d();
      t = similar(random, {a, d(), d(), d(), -a, d(), 0, 0, 0});
      break;
    }
    case Kind::Balanced: {
      // [[a, b], [c, e]] with bc = -(a^2 + ae + e^2): p = ae - bc - (a+e)^2 = 0.
      const double a = d();
      const double e = d();
      const double norm = a * a + a * e + e * e;
      t = similar(random, {a, norm, d(2), -1, e, d(2), 0, 0, -a - e});
      break;
    }
    case Kind::Symmetric: {
      t = integer_tensor(random, 5);
      t[3] = t[1];
      t[6] = t[2];
      t[7] = t[5];
      break;
    }
    case Kind::Antisymmetric: {
      const double x = d(), y = d(), z = d();
      t = {0, x, y, -x, 0, z, -y, -z, 0};
      break;
    }
    case Kind::RepeatedRows: {
      t = integer_tensor(random, 5);
      for (int j = 0; j < 3; ++j) t[3 + j] = t[j];
      return t;
    }
    case Kind::FewDistinct:
      return integer_tensor(random, 1);
  }
  const double trace = d(9);
  for (const int i : {0, 4, 8}) t[i] += trace;
  return t;
}

inline Tensor<double> degenerate_tensor(Random& random) {
  return degenerate_tensor(
      random, static_cast<Kind>(std::uniform_int_distribution<int>(0, kKinds - 1)(random)));
}

}  // namespace triplex::oracle

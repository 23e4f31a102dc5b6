// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <span>
#include <vector>

#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/integer_polynomial.hpp"
#include "triplex/arithmetic/sign.hpp"

namespace triplex {

/// A closed interval [lo, hi] / 2^exponent that holds exactly one root. A point if lo = hi: then
/// the root is that dyadic number. Otherwise the root lies strictly inside.
struct RootInterval {
  mpz_class lo;
  mpz_class hi;
  unsigned exponent = 0;
  int multiplicity = 1;

  bool is_point() const { return lo == hi; }
  /// The end points and the middle as doubles, each with relative error below 2^-52.
  double lo_approx() const;
  double hi_approx() const;
  double middle_approx() const;
};

/// The roots on [0,1] of a polynomial given by its Bernstein coefficients there.
///
/// Laws: (1) the intervals are sorted, pairwise disjoint as closed sets, inside [0,1]; (2) each
/// holds exactly one root, of the stated multiplicity; (3) no root on [0,1] lies outside; (4)
/// nothing depends on the scale of the coefficients; (5) it always ends, multiple roots included.
/// Source: proofs/root_isolation.md.
class RootIsolation {
 public:
  /// Isolates the roots. Shape: degree n = size - 1 >= 0, any n; meant for n <= 6.
  explicit RootIsolation(std::vector<mpz_class> bernstein);
  explicit RootIsolation(std::span<const Exact> bernstein);
  /// \pre the coefficients are finite.
  explicit RootIsolation(std::span<const double> bernstein);

  /// All coefficients vanish: every t is a root and `roots` is empty.
  bool identically_zero() const { return polynomial_.empty(); }
  const std::vector<RootInterval>& roots() const { return roots_; }
  /// The polynomial in the power basis.
  const IntegerPolynomial& polynomial() const { return polynomial_; }

  /// Shrinks interval i until it is no wider than 2^-bits. It may become a point. Keeps all laws.
  void refine(std::size_t i, unsigned bits);

  /// The certified sign of another polynomial g, in the power basis of the same t, at root i.
  /// Zero only if the root is shared. May refine interval i.
  Sign sign_at_root(const IntegerPolynomial& g, std::size_t i);

  /// -1, 0 or 1 as root i of this lies before, at or after root j of the other. May refine both.
  friend int compare_roots(RootIsolation& a, std::size_t i, RootIsolation& b, std::size_t j);

 private:
  void bisect(std::size_t i);
  void make_disjoint();
  bool isolate_plainly(std::vector<mpz_class> bernstein, unsigned max_depth);

  IntegerPolynomial polynomial_;
  IntegerPolynomial separating_;  // has the same roots on [0,1], those with an interval all simple
  std::vector<RootInterval> roots_;
  std::vector<Sign> sign_after_lo_;  // of separating_, just to the right of each interval's lo
};

int compare_roots(RootIsolation& a, std::size_t i, RootIsolation& b, std::size_t j);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/arithmetic/root_isolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "triplex/arithmetic/exact_conversion.hpp"

namespace triplex {
namespace {

// Bisections of [0,1] after which a polynomial is suspected of a multiple root and made
// square-free. Any value is right; roots closer than this, 2^-32, are rarer than exact multiple
// ones.
constexpr unsigned kPlainDepth = 32;
constexpr unsigned kNoLimit = std::numeric_limits<unsigned>::max();

// Descartes' bound on the roots in the open interval: sign changes among the nonzero coefficients.
int sign_changes(const std::vector<mpz_class>& b) {
  int changes = 0;
  int last = 0;
  for (const mpz_class& c : b) {
    const int s = sgn(c);
    if (s == 0) continue;
    changes += static_cast<int>(last == -s);
    last = s;
  }
  return changes;
}

Sign first_sign(const std::vector<mpz_class>& b) {
  for (const mpz_class& c : b) {
    if (sgn(c) != 0) return static_cast<Sign>(sgn(c));
  }
  return Sign::Zero;
}

int leading_zeros(const std::vector<mpz_class>& b) {
  return static_cast<int>(
      std::find_if(b.begin(), b.end(), [](const mpz_class& c) { return sgn(c) != 0; }) - b.begin());
}

int trailing_zeros(const std::vector<mpz_class>& b) {
  return static_cast<int>(
      std::find_if(b.rbegin(), b.rend(), [](const mpz_class& c) { return sgn(c) != 0; }) -
      b.rbegin());
}

// De Casteljau at 1/2 without the halvings: both halves' coefficients times 2^n. The right half
// replaces b.
std::vector<mpz_class> split_off_left(std::vector<mpz_class>& b) {
  const std::size_t n = b.size() - 1;
  std::vector<mpz_class> left(n + 1);
  for (std::size_t k = 0; k <= n; ++k) {
    // b[0 .. n-k] is row k of the triangle, times 2^k; b[n-k+1 .. n] is already the right half
    mpz_mul_2exp(left[k].get_mpz_t(), b[0].get_mpz_t(), n - k);
    for (std::size_t i = 0; i + k < n; ++i) b[i] += b[i + 1];
    mpz_mul_2exp(b[n - k].get_mpz_t(), b[n - k].get_mpz_t(), n - k);
  }
  return left;
}

double approx(const mpz_class& numerator, unsigned exponent) {
  signed long e = 0;
  const double mantissa = mpz_get_d_2exp(&e, numerator.get_mpz_t());
  return std::ldexp(mantissa, static_cast<int>(e) - static_cast<int>(exponent));
}

// a / 2^i <=> b / 2^j
int compare(const mpz_class& a, unsigned i, const mpz_class& b, unsigned j) {
  mpz_class x = a;
  mpz_class y = b;
  if (i < j) mpz_mul_2exp(x.get_mpz_t(), x.get_mpz_t(), j - i);
  if (j < i) mpz_mul_2exp(y.get_mpz_t(), y.get_mpz_t(), i - j);
  return cmp(x, y);
}

bool touch(const RootInterval& a, const RootInterval& b) {
  return compare(a.hi, a.exponent, b.lo, b.exponent) >= 0 &&
         compare(b.hi, b.exponent, a.lo, a.exponent) >= 0;
}

struct Piece {
  std::vector<mpz_class> bernstein;
  mpz_class number;  // the piece is [number, number + 1] / 2^depth
  unsigned depth;
};

}  // namespace

double RootInterval::lo_approx() const { return approx(lo, exponent); }
double RootInterval::hi_approx() const { return approx(hi, exponent); }
double RootInterval::middle_approx() const { return approx(lo + hi, exponent + 1); }

RootIsolation::RootIsolation(std::vector<mpz_class> bernstein)
    : polynomial_(from_bernstein(bernstein)), separating_(polynomial_) {
  if (identically_zero()) return;
  if (!isolate_plainly(std::move(bernstein), kPlainDepth)) {
    // Suspected multiple root: separate the roots of the square-free part, then tell
    // multiplicities.
    const std::vector<IntegerPolynomial> factors = square_free_factors(polynomial_);
    separating_ = quotient(polynomial_, gcd(polynomial_, derivative(polynomial_)));
    isolate_plainly(to_bernstein(separating_, 0, 1, 0), kNoLimit);
    make_disjoint();
    for (RootInterval& root : roots_) {
      for (std::size_t m = 0; m < factors.size(); ++m) {
        const Sign at_lo = sign_at(factors[m], {root.lo, root.exponent});
        const Sign at_hi = sign_at(factors[m], {root.hi, root.exponent});
        if (at_lo == Sign::Zero || at_lo != at_hi) root.multiplicity = static_cast<int>(m) + 1;
      }
    }
    return;
  }
  make_disjoint();
}

RootIsolation::RootIsolation(std::span<const Exact> bernstein)
    : RootIsolation(to_integers(bernstein)) {}
RootIsolation::RootIsolation(std::span<const double> bernstein)
    : RootIsolation(to_integers(bernstein)) {}

// Bisects [0,1], left pieces first, until every open piece has at most one sign change. Returns
// false, with no roots, if a piece of max_depth bisections still has more.
bool RootIsolation::isolate_plainly(std::vector<mpz_class> bernstein, unsigned max_depth) {
  roots_.clear();
  sign_after_lo_.clear();
  const auto add = [&](mpz_class lo, mpz_class hi, unsigned exponent, int multiplicity,
                       Sign after) {
    roots_.push_back({std::move(lo), std::move(hi), exponent, multiplicity});
    sign_after_lo_.push_back(after);
  };
  const int at_one = trailing_zeros(bernstein);
  if (const int m = leading_zeros(bernstein); m > 0) add(0, 0, 0, m, Sign::Zero);
  std::vector<Piece> stack;
  stack.push_back({std::move(bernstein), 0, 0});
  while (!stack.empty()) {
    Piece piece = std::move(stack.back());
    stack.pop_back();
    // The left end of a right half is the middle of a piece: if it is a root, a point. Left halves
    // have even numbers; what begins at their left end was seen before.
    if (mpz_odd_p(piece.number.get_mpz_t())) {
      if (const int m = leading_zeros(piece.bernstein); m > 0) {
        add(piece.number, piece.number, piece.depth, m, Sign::Zero);
      }
    }
    const int changes = sign_changes(piece.bernstein);
    if (changes == 0) continue;
    if (changes == 1) {
      add(piece.number, piece.number + 1, piece.depth, 1, first_sign(piece.bernstein));
      continue;
    }
    if (piece.depth == max_depth) {
      roots_.clear();
      sign_after_lo_.clear();
      return false;
    }
    std::vector<mpz_class> left = split_off_left(piece.bernstein);
    stack.push_back({std::move(piece.bernstein), 2 * piece.number + 1, piece.depth + 1});
    stack.push_back({std::move(left), 2 * piece.number, piece.depth + 1});
  }
  if (at_one > 0) add(1, 1, 0, at_one, Sign::Zero);
  return true;
}

// Halves interval i at its middle; a point stays as it is.
void RootIsolation::bisect(std::size_t i) {
  RootInterval& root = roots_[i];
  if (root.is_point()) return;
  const mpz_class middle = root.lo + root.hi;
  const Sign s = sign_at(separating_, {middle, root.exponent + 1});
  root.exponent += 1;
  if (s == Sign::Zero) {
    root.lo = root.hi = middle;
  } else if (s == sign_after_lo_[i]) {
    root.lo = middle;
    root.hi *= 2;
  } else {
    root.lo *= 2;
    root.hi = middle;
  }
}

// After isolation neighbours may share an end point, which may be a root that has its own point.
void RootIsolation::make_disjoint() {
  for (std::size_t i = 0; i + 1 < roots_.size(); ++i) {
    while (touch(roots_[i], roots_[i + 1])) {
      bisect(i);
      bisect(i + 1);
    }
  }
}

void RootIsolation::refine(std::size_t i, unsigned bits) {
  const RootInterval& root = roots_[i];
  const auto wide = [&] {
    const mpz_class width = root.hi - root.lo;  // <= 2^(exponent - bits)?
    return compare(width, root.exponent, 1, bits) > 0;
  };
  while (!root.is_point() && wide()) bisect(i);
}

Sign RootIsolation::sign_at_root(const IntegerPolynomial& g, std::size_t i) {
  const RootInterval& root = roots_[i];
  if (g.empty()) return Sign::Zero;
  constexpr int kTriesBeforeGcd =
      8;  // a common root is rare: look for it once bisection seems stuck
  for (int tries = 0;; ++tries) {
    if (root.is_point()) return sign_at(g, {root.lo, root.exponent});
    const std::vector<mpz_class> b = to_bernstein(g, root.lo, root.hi, root.exponent);
    // Without sign changes g is zero at most at the ends, and the root is strictly inside.
    if (sign_changes(b) == 0) return first_sign(b);
    if (tries == kTriesBeforeGcd) {
      // A common divisor has at most this one root in the interval, a simple one: it changes sign.
      const IntegerPolynomial common = gcd(separating_, g);
      if (sign_at(common, {root.lo, root.exponent}) != sign_at(common, {root.hi, root.exponent})) {
        return Sign::Zero;
      }
    }
    bisect(i);
  }
}

int compare_roots(RootIsolation& a, std::size_t i, RootIsolation& b, std::size_t j) {
  const RootInterval& x = a.roots_[i];
  const RootInterval& y = b.roots_[j];
  const auto separated = [&] {
    if (compare(x.hi, x.exponent, y.lo, y.exponent) < 0) return -1;
    return static_cast<int>(compare(y.hi, y.exponent, x.lo, x.exponent) < 0);
  };
  if (const int order = separated(); order != 0) return order;
  // b's polynomial vanishes at a's root: it is b's root j as soon as no other interval of b holds
  // it.
  if (a.sign_at_root(b.separating_, i) == Sign::Zero) {
    if (x.is_point() && y.is_point()) return compare(x.lo, x.exponent, y.lo, y.exponent);
    // The roots differ only if a's root is another root of b; their closed intervals are disjoint.
    while (true) {
      if (const int order = separated(); order != 0) return order;
      bool elsewhere = false;
      for (std::size_t k = 0; k < b.roots_.size(); ++k) {
        elsewhere = elsewhere || (k != j && touch(x, b.roots_[k]));
      }
      if (!elsewhere) return 0;
      a.bisect(i);
      b.bisect(j);
    }
  }
  while (separated() == 0) {
    a.bisect(i);
    b.bisect(j);
  }
  return separated();
}

}  // namespace triplex

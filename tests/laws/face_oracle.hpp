// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "tiny_shift.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex::test {

/// A polynomial in x, constant term first.
using Univariate = std::vector<Exact>;

inline Univariate operator+(const Univariate& a, const Univariate& b) {
  Univariate r(std::max(a.size(), b.size()), Exact(0));
  for (std::size_t n = 0; n < a.size(); ++n) r[n] = r[n] + a[n];
  for (std::size_t n = 0; n < b.size(); ++n) r[n] = r[n] + b[n];
  return r;
}
inline Univariate operator*(const Univariate& a, const Univariate& b) {
  if (a.empty() || b.empty()) return {};
  Univariate r(a.size() + b.size() - 1, Exact(0));
  for (std::size_t n = 0; n < a.size(); ++n)
    for (std::size_t m = 0; m < b.size(); ++m) r[n + m] = r[n + m] + a[n] * b[m];
  return r;
}
inline Univariate operator-(const Univariate& a) { return Univariate{Exact(-1)} * a; }

/// How many points of a face have p = q = 0: all common roots of the conic and the cubic by
/// elimination of one coordinate; where that has ties, for T + eps B with a tiny eps.
class FaceOracle {
 public:
  FaceOracle(const RefinableField& field, const std::array<VertexId, 3>& vertices)
      : field_(field), vertices_(vertices) {}

  /// Nothing if T + eps B with a tiny eps has ties of its own.
  std::optional<int> spine_points() {
    if (misses_by_doubles()) return 0;
    ++eliminations_;
    std::array<Tensor<Exact>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = field_.exact(vertices_[i]);
    if (const auto found = count_somehow(corners)) return found;
    const Tensor<Exact> shift = tiny_shift(field_);
    for (auto& t : corners)
      for (std::size_t k = 0; k < 9; ++k) t[k] = t[k] + shift[k];
    if (corners[0] == corners[1] && corners[0] == corners[2]) return count_of_constant(corners);
    return count_somehow(corners);
  }
  std::size_t eliminations() const { return eliminations_; }

 private:
  /// All Bernstein coefficients of p, or all of q, have one sign.
  bool misses_by_doubles() const {
    EntryBounds entries;
    std::array<Tensor<double>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = field_.approximate(vertices_[i]).a;
      entries.include(field_.approximate(vertices_[i]).bounds);
    }
    if (!entries.usable()) return false;
    const auto forms = forms_of<double, 3>(corners);
    const FormBounds bounds(entries);
    const auto uniform = [](const auto& c, double error) {
      return std::ranges::all_of(c, [&](double x) { return x > error; }) ||
             std::ranges::all_of(c, [&](double x) { return x < -error; });
    };
    return uniform(forms.p, bounds.p_error) || uniform(forms.q, bounds.q_error);
  }

  /// By powers of y, with the corners at (0,0), (1,0) and (0,1).
  using Bivariate = std::vector<Univariate>;
  static Bivariate times(const Bivariate& a, const Bivariate& b) {
    Bivariate r(a.size() + b.size() - 1);
    for (std::size_t n = 0; n < a.size(); ++n)
      for (std::size_t m = 0; m < b.size(); ++m) r[n + m] = r[n + m] + a[n] * b[m];
    return r;
  }
  static void add(Bivariate& sum, const Exact& factor, const Bivariate& term) {
    if (sum.size() < term.size()) sum.resize(term.size());
    for (std::size_t n = 0; n < term.size(); ++n) sum[n] = sum[n] + Univariate{factor} * term[n];
  }

  /// Two points of equal x are no tie when the coordinates are others.
  static std::optional<int> count_somehow(std::array<Tensor<Exact>, 3> corners) {
    for (int turn = 0; turn < 3; ++turn) {
      if (const auto found = count(corners)) return found;
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    return std::nullopt;
  }
  /// Elimination has nothing to eliminate: p and q vanish everywhere or nowhere.
  static std::optional<int> count_of_constant(const std::array<Tensor<Exact>, 3>& corners) {
    const auto forms = forms_of<Exact, 3>(corners);
    if (forms.P(0, 0).is_zero() && forms.Q(0, 0, 0).is_zero()) return std::nullopt;
    return 0;
  }
  static bool vanishes(const Univariate& f) {
    return std::ranges::all_of(f, [](const Exact& x) { return x.is_zero(); });
  }
  /// On p = a y^2 + b y + c, a constant, a^2 q = alpha y + beta; both vanish where
  /// a beta^2 - b alpha beta + c alpha^2 = 0 and y = -beta / alpha. If a = 0, y = -c / b in q.
  static std::optional<int> count(const std::array<Tensor<Exact>, 3>& corners) {
    const auto forms = forms_of<Exact, 3>(corners);
    const std::array<Bivariate, 3> coordinate = {Bivariate{{Exact(1), Exact(-1)}, {Exact(-1)}},
                                                 Bivariate{{Exact(0), Exact(1)}},
                                                 Bivariate{{}, {Exact(1)}}};
    Bivariate p(3), q(4);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Bivariate ij = times(coordinate[i], coordinate[j]);
        add(p, forms.P(i, j), ij);
        for (int k = 0; k < 3; ++k) add(q, forms.Q(i, j, k), times(ij, coordinate[k]));
      }
    const Univariate &a = p[2], &b = p[1], &c = p[0];
    if (vanishes(a)) {
      const Univariate resultant =
          q[0] * b * b * b + -(q[1] * c * b * b) + q[2] * c * c * b + -(q[3] * c * c * c);
      return count_inside(resultant, b, c);
    }
    const Univariate alpha = q[3] * (b * b + -(a * c)) + -(q[2] * a * b) + q[1] * a * a;
    const Univariate beta = q[3] * b * c + -(q[2] * a * c) + q[0] * a * a;
    const Univariate resultant = a * beta * beta + -(b * alpha * beta) + c * alpha * alpha;
    return count_inside(resultant, alpha, beta);
  }
  static IntegerPolynomial integers(const Univariate& f) {
    IntegerPolynomial r = to_integers(std::span<const Exact>(f));
    while (!r.empty() && r.back() == 0) r.pop_back();
    return r;
  }
  /// Roots x in (0, 1) with y > 0 and x + y < 1.
  static std::optional<int> count_inside(const Univariate& resultant, const Univariate& alpha,
                                         const Univariate& beta) {
    const IntegerPolynomial f = integers(resultant);
    if (f.empty()) return std::nullopt;
    RootIsolation roots(to_bernstein(f, 0, 1, 0));
    const IntegerPolynomial a = integers(alpha), b = integers(beta);
    const IntegerPolynomial rest = integers(alpha * Univariate{Exact(1), Exact(-1)} + beta);
    if (a.empty() || b.empty() || rest.empty()) return std::nullopt;
    int inside = 0;
    for (std::size_t i = 0; i < roots.roots().size(); ++i) {
      const RootInterval& root = roots.roots()[i];
      const bool at_end =
          root.is_point() && (root.lo == 0 || root.lo == mpz_class(1) << root.exponent);
      if (root.multiplicity > 1 || at_end) return std::nullopt;
      const Sign s = roots.sign_at_root(a, i), t = roots.sign_at_root(b, i),
                 u = roots.sign_at_root(rest, i);
      if (s == Sign::Zero || t == Sign::Zero || u == Sign::Zero) return std::nullopt;
      inside += t == -s && u == s;
    }
    return inside;
  }

  const RefinableField& field_;
  std::array<VertexId, 3> vertices_;
  std::size_t eliminations_ = 0;
};

}  // namespace triplex::test

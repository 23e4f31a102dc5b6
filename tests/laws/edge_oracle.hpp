// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "tiny_shift.hpp"
#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/discriminant.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex::test {

/// How often each page crosses an edge, by isolation of all roots of p, q and D on it; where a root
/// is multiple, at an end of the edge or on the triple degenerate curve, by isolation for
/// T + eps B with a tiny eps.
class EdgeOracle {
 public:
  EdgeOracle(const RefinableField& field, VertexId a, VertexId b) : field_(field), ends_{a, b} {
    EntryBounds entries;
    std::array<Tensor<double>, 2> tensors;
    for (std::size_t i = 0; i < 2; ++i) {
      tensors[i] = field.approximate(ends_[i]).a;
      entries.include(field.approximate(ends_[i]).bounds);
    }
    const auto forms = forms_of<double, 2>(tensors);
    const FormBounds bounds(entries);
    if (!entries.usable()) return;
    p_ = Signs(forms.p, bounds.p_error);
    q_ = Signs(forms.q, bounds.q_error);
    // A Bernstein coefficient of 2 P^3 + 3 Q^2 is 2 times a mean of products of three P plus 3
    // times a mean of products of two Q: errors of the factors by the largest factors, and at most
    // 25 roundings on the way.
    auto d = minus_discriminant(forms);
    for (std::size_t n = 0; n < d.size(); ++n) d[n] /= kMonomials<2, 6>.multinomial[n];
    const double P = bounds.p_magnitude + bounds.p_error, Q = bounds.q_magnitude + bounds.q_error;
    const double error = 6 * P * P * bounds.p_error + 6 * Q * bounds.q_error +
                         gamma(25) * (2 * P * P * P + 3 * Q * Q);
    d_ = Signs(d, error);
  }

  /// The number of crossings of a page. Nothing if T + eps B with a tiny eps has ties of its own.
  std::optional<int> crossings(Feature page) {
    const FeatureRow& row = standard_features().row(page);
    switch (page) {
      case Feature::BalancedLinear:
      case Feature::BalancedPlanar:
        return count(
            p_, q_, row.sign_q, [](const auto& e) { return e.p; },
            [](const auto& e) { return e.q; });
      case Feature::NeutralReal:
      case Feature::NeutralComplex:
        return count(
            q_, p_, row.sign_p, [](const auto& e) { return e.q; },
            [](const auto& e) { return e.p; });
      default:  // on D = 0 p is negative wherever q is not zero
        return count(
            d_, q_, row.sign_q, [](const auto& e) { return e.d; },
            [](const auto& e) { return e.q; });
    }
  }
  std::size_t isolations() const { return isolations_; }
  std::size_t ties() const { return ties_; }

 private:
  /// What doubles know of the signs of Bernstein coefficients.
  struct Signs {
    bool known = false;  ///< all of them
    int changes = 0;     ///< of sign
    Sign first = Sign::Zero;

    Signs() = default;
    Signs(std::span<const double> c, double error) {
      known = std::ranges::all_of(c, [&](double x) { return std::fabs(x) > error; });
      for (std::size_t n = 0; n + 1 < c.size(); ++n) changes += (c[n] < 0) != (c[n + 1] < 0);
      first = c[0] < 0 ? Sign::Negative : Sign::Positive;
    }
    bool uniform() const { return known && changes == 0; }
  };
  struct ExactForms {
    std::array<Exact, 3> p;
    std::array<Exact, 4> q;
    std::array<Exact, 7> d;
  };

  /// Roots of f at which g has the wanted sign.
  template <class F, class G>
  std::optional<int> count(const Signs& f, const Signs& g, Sign wanted, const F& f_of,
                           const G& g_of) {
    if (f.uniform() || (g.uniform() && g.first != wanted)) return 0;
    if (f.known && f.changes == 1 && g.uniform()) return 1;  // Descartes' rule
    ++isolations_;
    const auto n = count_exactly(exact(), wanted, f_of, g_of);
    if (n) return n;
    ++ties_;
    return count_exactly(perturbed(), wanted, f_of, g_of);
  }
  template <class F, class G>
  static std::optional<int> count_exactly(const ExactForms& forms, Sign wanted, const F& f_of,
                                          const G& g_of) {
    const auto coefficients = f_of(forms);
    RootIsolation roots{std::span<const Exact>(coefficients)};
    if (roots.identically_zero()) return std::nullopt;
    const auto other = g_of(forms);
    const RootIsolation sides{std::span<const Exact>(other)};
    if (sides.identically_zero()) return std::nullopt;
    int n = 0;
    for (std::size_t i = 0; i < roots.roots().size(); ++i) {
      if (roots.roots()[i].multiplicity > 1 || at_end(roots.roots()[i])) return std::nullopt;
      const Sign side = roots.sign_at_root(sides.polynomial(), i);
      if (side == Sign::Zero) return std::nullopt;
      n += side == wanted;
    }
    return n;
  }
  static bool at_end(const RootInterval& root) {
    return root.is_point() && (root.lo == 0 || root.lo == mpz_class(1) << root.exponent);
  }
  static ExactForms forms_at(const std::array<Tensor<Exact>, 2>& ends) {
    const auto forms = forms_of<Exact, 2>(ends);
    ExactForms f{forms.p, forms.q, minus_discriminant(forms)};
    // Bernstein coefficients times 60, the least common multiple of 1, 6, 15 and 20.
    for (std::size_t n = 0; n < f.d.size(); ++n)
      f.d[n] = f.d[n] * Exact(60 / kMonomials<2, 6>.multinomial[n]);
    return f;
  }
  const ExactForms& exact() {
    if (!exact_) exact_ = forms_at({field_.exact(ends_[0]), field_.exact(ends_[1])});
    return *exact_;
  }
  const ExactForms& perturbed() {
    if (perturbed_) return *perturbed_;
    const Tensor<Exact> shift = tiny_shift(field_);
    std::array<Tensor<Exact>, 2> ends = {field_.exact(ends_[0]), field_.exact(ends_[1])};
    for (auto& t : ends)
      for (std::size_t k = 0; k < 9; ++k) t[k] = t[k] + shift[k];
    return perturbed_.emplace(forms_at(ends));
  }

  const RefinableField& field_;
  std::array<VertexId, 2> ends_;
  Signs p_, q_, d_;
  std::optional<ExactForms> exact_, perturbed_;
  std::size_t isolations_ = 0, ties_ = 0;
};

}  // namespace triplex::test

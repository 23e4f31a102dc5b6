// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_root.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <optional>

#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/bernstein/discriminant.hpp"

namespace triplex {
namespace {

double quadratic(const Forms<double, 2>& f, double t) {
  const double s = 1 - t;
  return s * s * f.p[0] + 2 * s * t * f.p[1] + t * t * f.p[2];
}
double cubic(const Forms<double, 2>& f, double t) {
  const double s = 1 - t;
  return s * s * s * f.q[0] + 3 * s * s * t * f.q[1] + 3 * s * t * t * f.q[2] + t * t * t * f.q[3];
}
/// 12 v^3 on the degenerate pages, v = sqrt(max(0, -P) / 6).
double page_height(double P) {
  const double v = std::sqrt(std::fmax(0, -P) / 6);
  return 12 * v * v * v;
}

/// The function of a page, positive where the angle of (p, q) is beyond the page.
class PageFunction {
 public:
  PageFunction(const Simplex<2>& edge, Feature page)
      : f_(edge.approximate()), bounds_(edge.bounds()), page_(page) {}

  double operator()(double t) const {
    switch (page_) {
      case Feature::NeutralComplex:
        return cubic(f_, t);
      case Feature::NeutralReal:
        return -cubic(f_, t);
      case Feature::BalancedLinear:
        return -quadratic(f_, t);
      case Feature::BalancedPlanar:
        return quadratic(f_, t);
      case Feature::DegenerateLinear:
        return page_height(quadratic(f_, t)) - cubic(f_, t);
      case Feature::DegeneratePlanar:
        return -page_height(quadratic(f_, t)) - cubic(f_, t);
      case Feature::TripleCurve:
        break;
    }
    return 0;
  }

  /// The proven sign at t (1 - t is exact up to one rounding, covered by the evaluation's bound).
  Certainty sign_at(double t) const {
    // Bernstein sums: coefficient errors pass through with weight one; every term takes at most
    // 8 roundings, weights included, and the terms add up to the largest coefficient.
    const double p_error = bounds_.p_error + gamma(8) * bounds_.p_magnitude;
    const double q_error = bounds_.q_error + gamma(9) * bounds_.q_magnitude;
    switch (page_) {
      case Feature::BalancedLinear:
      case Feature::BalancedPlanar:
        return certainty((*this)(t), p_error);
      case Feature::NeutralReal:
      case Feature::NeutralComplex:
        return certainty((*this)(t), q_error);
      default:
        break;
    }
    // The height is monotone in P; square root, quotient and products take 6 roundings each side.
    const double P = quadratic(f_, t), q = cubic(f_, t);
    const double highest = page_height(P - p_error) * (1 + 2 * gamma(8));
    const double lowest = page_height(P + p_error) * (1 - 2 * gamma(8));
    const double slack = q_error + gamma(2) * (highest + bounds_.q_magnitude);
    const double sign = page_ == Feature::DegenerateLinear ? 1 : -1;
    const double a = sign * highest - q, b = sign * lowest - q;
    if (std::fmin(a, b) > slack) return Certainty::Positive;
    if (std::fmax(a, b) < -slack) return Certainty::Negative;
    return Certainty::Unknown;
  }

  /// No sign can be proven nearer to a root than this: up to rounding, the evaluation's bound over
  /// the largest slope. Saves questions; decides nothing.
  double hopeless_distance(double t) const {
    double dp = 0, dq = 0;
    for (int i = 0; i < 2; ++i) dp = std::max(dp, 2 * std::fabs(f_.p[i + 1] - f_.p[i]));
    for (int i = 0; i < 3; ++i) dq = std::max(dq, 3 * std::fabs(f_.q[i + 1] - f_.q[i]));
    const Sheet sheet = row(page_).sheet;
    const double bound = sheet == Sheet::Balanced ? bounds_.p_error : bounds_.q_error;
    double slope = sheet == Sheet::Balanced ? dp : dq;
    if (sheet != Sheet::Balanced && sheet != Sheet::Neutral) {
      const double least = std::min({f_.p[0], f_.p[1], f_.p[2]});
      slope += 3 * std::sqrt(std::max(0.0, -least) / 6) * dp;
    }
    return (bound - std::fabs((*this)(t))) / (2 * slope);
  }

 private:
  const Forms<double, 2>& f_;
  const FormBounds& bounds_;
  Feature page_;
};

/// A root in doubles of a function that should change sign on [low, high]; an end point if rounding
/// hides the change.
template <class F>
double solve(const F& f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low == 0) return low;
  if (at_high == 0) return high;
  if ((at_low < 0) == (at_high < 0)) return std::fabs(at_low) < std::fabs(at_high) ? low : high;
  std::uintmax_t steps = 80;  // bisection alone needs 53
  const auto bracket = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(52), steps);
  return std::fabs(f(bracket.first)) < std::fabs(f(bracket.second)) ? bracket.first
                                                                    : bracket.second;
}

/// The part of the edge on which p has the page's sign.
std::array<double, 2> part_of(const Simplex<2>& edge, Feature page) {
  const Sign wanted = row(page).sign_p;
  const auto& f = edge.approximate();
  if (wanted == Sign::Zero || (f.p[0] < 0) == (f.p[2] < 0)) return {0, 1};
  const double t = solve([&](double x) { return quadratic(f, x); }, 0.0, 1.0);
  const bool first_part = (f.p[0] < 0) == (wanted == Sign::Negative);
  return first_part ? std::array{0.0, t} : std::array{t, 1.0};
}

/// The smallest power-of-two distance at which the filter sees the sign change around t.
double certified_error(const PageFunction& f, double t, bool rising) {
  const Certainty before = rising ? Certainty::Negative : Certainty::Positive;
  const Certainty after = rising ? Certainty::Positive : Certainty::Negative;
  double error = 0x1p-50;
  const double hopeless = std::min(f.hopeless_distance(t), kWidestBracket / 4);
  while (error < hopeless) error *= 4;
  for (; error <= kWidestBracket; error *= 4) {
    const bool left = t - error <= 0 || f.sign_at(t - error) == before;
    if (left && (t + error >= 1 || f.sign_at(t + error) == after)) return error;
  }
  return 1;
}

/// Exact isolation of the page's polynomial on the unperturbed edge: the root on the page next to
/// t.
std::optional<EdgeRoot> isolate(const Simplex<2>& edge, Feature page, double t) {
  const auto forms = forms_of<Exact, 2>(edge.exact_tensors());
  const RootIsolation p(std::span<const Exact>(forms.p)), q(std::span<const Exact>(forms.q));
  const auto sextic = [&] {
    auto d = minus_discriminant(forms);
    // Bernstein coefficients times 60, the least common multiple of the multinomials 1, 6, 15, 20.
    for (std::size_t n = 0; n < d.size(); ++n)
      d[n] = d[n] * Exact(60 / kMonomials<2, 6>.multinomial[n]);
    return RootIsolation(std::span<const Exact>(d));
  };
  const Sheet sheet = row(page).sheet;
  RootIsolation roots = sheet == Sheet::Balanced ? p : sheet == Sheet::Neutral ? q : sextic();
  if (roots.identically_zero()) return std::nullopt;

  const auto allows = [&](const RootIsolation& other, Sign wanted, std::size_t i) {
    if (wanted == Sign::Zero || other.identically_zero()) return true;
    const Sign found = roots.sign_at_root(other.polynomial(), i);
    return found == wanted || found == Sign::Zero;
  };
  std::optional<EdgeRoot> nearest;
  for (std::size_t i = 0; i < roots.roots().size(); ++i) {
    if (!allows(p, row(page).sign_p, i) || !allows(q, row(page).sign_q, i)) continue;
    roots.refine(i, 54);
    const EdgeRoot root{roots.roots()[i].middle_approx(), 0x1p-52};
    if (!nearest || std::fabs(root.t - t) < std::fabs(nearest->t - t)) nearest = root;
  }
  return nearest;
}

}  // namespace

EdgeRoot find_crossing(const Simplex<2>& edge, Feature page, bool rising) {
  const PageFunction f(edge, page);
  const auto [low, high] = part_of(edge, page);
  EdgeRoot root{solve(f, low, high), 1};
  if (edge.filter_usable()) root.error = certified_error(f, root.t, rising);
  if (root.error > kWidestBracket) {
    if (const auto exact = isolate(edge, page, root.t)) root = *exact;
  }
  return root;
}

}  // namespace triplex

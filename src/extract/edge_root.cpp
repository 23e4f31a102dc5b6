// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_root.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bracket.hpp"
#include "triplex/arithmetic/root_isolation.hpp"
#include "triplex/certify/isolate_discriminant.hpp"
#include "triplex/certify/mode_page.hpp"

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
  PageFunction(const Simplex<2>& edge, const FeatureRow& page, const Sheet& sheet)
      : f_(mapped(edge.approximate(), sheet.map)), bounds_(edge.bounds()), kind_(sheet.kind) {
    if (!sheet.map.is_identity()) bounds_ = mapped(bounds_, sheet.map);
    const double p = static_cast<int>(page.sign_p), q = static_cast<int>(page.sign_q);
    height_ = q;
    switch (kind_) {
      case Sheet::Kind::Balanced:
        sense_ = -q;
        break;
      case Sheet::Kind::Neutral:
        sense_ = p;
        break;
      case Sheet::Kind::Curved:
        sense_ = -p;
    }
  }

  double operator()(double t) const {
    switch (kind_) {
      case Sheet::Kind::Balanced:
        return sense_ * quadratic(f_, t);
      case Sheet::Kind::Neutral:
        return sense_ * cubic(f_, t);
      case Sheet::Kind::Curved:
        return sense_ * (height_ * page_height(quadratic(f_, t)) - cubic(f_, t));
    }
    return 0;
  }

  /// The proven sign at t (1 - t is exact up to one rounding, covered by the evaluation's bound).
  Certainty sign_at(double t) const {
    // Bernstein sums: coefficient errors pass through with weight one; every term takes at most
    // 8 roundings, weights included, and the terms add up to the largest coefficient.
    const double p_error = bounds_.p_error + gamma(8) * bounds_.p_magnitude;
    const double q_error = bounds_.q_error + gamma(9) * bounds_.q_magnitude;
    if (kind_ == Sheet::Kind::Balanced) return certainty((*this)(t), p_error);
    if (kind_ == Sheet::Kind::Neutral) return certainty((*this)(t), q_error);
    // The height is monotone in P; square root, quotient and products take 6 roundings each side.
    const double P = quadratic(f_, t), q = cubic(f_, t);
    const double highest = page_height(P - p_error) * (1 + 2 * gamma(8));
    const double lowest = page_height(P + p_error) * (1 - 2 * gamma(8));
    const double slack = q_error + gamma(2) * (highest + bounds_.q_magnitude);
    const double a = sense_ * (height_ * highest - q), b = sense_ * (height_ * lowest - q);
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
    const bool balanced = kind_ == Sheet::Kind::Balanced;
    const double bound = balanced ? bounds_.p_error : bounds_.q_error;
    double slope = balanced ? dp : dq;
    if (kind_ == Sheet::Kind::Curved) {
      const double least = std::min({f_.p[0], f_.p[1], f_.p[2]});
      slope += 3 * std::sqrt(std::max(0.0, -least) / 6) * dp;
    }
    return (bound - std::fabs((*this)(t))) / (2 * slope);
  }

 private:
  Forms<double, 2> f_;
  FormBounds bounds_;
  Sheet::Kind kind_;
  double sense_ = 1;   // of the sheet's function against the angle
  double height_ = 1;  // side of q on which the page stands
};

/// The part of the edge on which p has the page's sign.
std::array<double, 2> part_of(const Simplex<2>& edge, const FeatureRow& page) {
  const Sign wanted = page.sign_p;
  const auto& f = edge.approximate();
  if (wanted == Sign::Zero || (f.p[0] < 0) == (f.p[2] < 0)) return {0, 1};
  const double t = bracketed_root([&](double x) { return quadratic(f, x); }, 0.0, 1.0);
  const bool first_part = (f.p[0] < 0) == (wanted == Sign::Negative);
  return first_part ? std::array{0.0, t} : std::array{t, 1.0};
}

/// Exact isolation of the page's polynomial on the unperturbed edge: the root on the page next to
/// t.
std::optional<EdgeRoot> isolate(const Simplex<2>& edge, const FeatureRow& page, const Sheet& sheet,
                                double t) {
  const auto forms = mapped(forms_of<Exact, 2>(edge.exact_tensors()), sheet.map);
  const RootIsolation p(std::span<const Exact>(forms.p)), q(std::span<const Exact>(forms.q));
  RootIsolation roots = sheet.kind == Sheet::Kind::Balanced  ? p
                        : sheet.kind == Sheet::Kind::Neutral ? q
                                                             : isolate_discriminant(forms);
  if (roots.identically_zero()) return std::nullopt;

  const auto allows = [&](const RootIsolation& other, Sign wanted, std::size_t i) {
    if (wanted == Sign::Zero || other.identically_zero()) return true;
    const Sign found = roots.sign_at_root(other.polynomial(), i);
    return found == wanted || found == Sign::Zero;
  };
  const Sign wanted_p = sheet.map.p_factor < 0 ? -page.sign_p : page.sign_p;
  std::optional<EdgeRoot> nearest;
  for (std::size_t i = 0; i < roots.roots().size(); ++i) {
    if (!allows(p, wanted_p, i) || !allows(q, page.sign_q, i)) continue;
    roots.refine(i, 54);
    const EdgeRoot root{roots.roots()[i].middle_approx(), 0x1p-52};
    if (!nearest || std::fabs(root.t - t) < std::fabs(nearest->t - t)) nearest = root;
  }
  return nearest;
}

}  // namespace

EdgeRoot find_crossing(const Simplex<2>& edge, const FeatureTable& table, Feature page,
                       bool rising) {
  const FeatureRow& row = table.row(page);
  const PageFunction f(edge, row, table.sheet(page));
  const auto [low, high] = part_of(edge, row);
  EdgeRoot root{bracketed_root(f, low, high), 1};
  if (edge.filter_usable())
    root.error = certified_error([&](double t) { return f.sign_at(t); }, root.t, rising,
                                 f.hopeless_distance(root.t));
  // Where an end is known by an enclosure only, what the filter leaves open stays open.
  if (root.error > kWidestBracket && !edge.has_enclosed_vertex()) {
    if (const auto exact = isolate(edge, row, table.sheet(page), root.t)) root = *exact;
  }
  if (root.error == 1 && edge.filter_usable())  // a wide bracket is better than none
    root.error =
        certified_error([&](double t) { return f.sign_at(t); }, root.t, rising, kWidestBracket, 1);
  // Not an end that doubles have no reason to prefer: others may lie there too.
  if (root.error == 1 && f(low) * f(high) > 0) root.t = (low + high) / 2;
  return root;
}

}  // namespace triplex

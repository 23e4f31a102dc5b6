// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/edge_cut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "triplex/arithmetic/exact_conversion.hpp"

namespace triplex {
namespace {

/// Entries and b^2 - a c of a r^0 + 2 b r + c r^2, scaled by powers of two.
struct Quadratic {
  double a, b, c, discriminant;
};

Quadratic exactly(const QuadraticForm<Exact, 2>& f) {
  int exponent = std::numeric_limits<int>::min();
  for (const Exact& x : f.entries)
    if (sign(x) != Sign::Zero) exponent = std::max(exponent, binary_exponent(x));
  const auto scaled = [&](const Exact& x) {
    return sign(x) == Sign::Zero ? 0.0 : to_double_approx(x, -exponent);
  };
  const Exact d = f(0, 1) * f(0, 1) - f(0, 0) * f(1, 1);
  return {scaled(f(0, 0)), scaled(f(0, 1)), scaled(f(1, 1)), to_double_approx(d, -2 * exponent)};
}

/// In doubles if each number is known to 2^-34 of itself, so that its root and quotients are to
/// 2^-32.
Quadratic quadratic_of(const SimplexForm<2>& form) {
  const auto sharp = [](const Interval& x) {
    return x.sup() - x.inf() <= 0x1p-34 * std::fmin(std::fabs(x.inf()), std::fabs(x.sup()));
  };
  {
    const IntervalRounding rounding;
    const auto& f = form.enclosure();
    const Interval d = f(0, 1) * f(0, 1) - f(0, 0) * f(1, 1);
    // b may be anything beside the root of the discriminant
    const bool b_small = f(0, 1).sup() - f(0, 1).inf() <= 0x1p-34 * std::sqrt(std::fabs(d.inf()));
    const double size = std::fabs(f(0, 0).inf()) + std::fabs(f(1, 1).inf());
    if (sharp(f(0, 0)) && sharp(f(1, 1)) && sharp(d) && (b_small || sharp(f(0, 1))) &&
        size > 0x1p-400 && size < 0x1p400)
      return {f(0, 0).inf(), f(0, 1).inf(), f(1, 1).inf(), d.inf()};
  }
  return exactly(form.exact());
}

/// The roots r = t / (1 - t) of a + 2 b r + c r^2, without cancellation.
void place_roots(const Quadratic& q, EdgeCut& cut) {
  const double s = -(q.b + std::copysign(std::sqrt(q.discriminant), q.b));
  // r is s / c or a / s; t = r / (1 + r), for both as quotients of what is not small
  const auto weight = [](double numerator, double denominator) {
    return numerator / (numerator + denominator);
  };
  std::array<double, 2> t = {weight(s, q.c), weight(q.a, s)};
  if (cut.roots == 1) t[0] = s * q.c > 0 ? t[0] : t[1];
  if (cut.roots == 2 && t[1] < t[0]) std::swap(t[0], t[1]);
  constexpr double kEnd = 0x1p-60;
  for (int k = 0; k < cut.roots; ++k)
    cut.place[k] = std::clamp(t[k], kEnd, 1 - std::numeric_limits<double>::epsilon() / 2);
}

}  // namespace

EdgeCut cut_edge(const SimplexForm<2>& form) {
  EdgeCut cut;
  cut.ends[0] = form.sign_of([](const auto& f) { return f(0, 0); });
  cut.ends[1] = form.sign_of([](const auto& f) { return f(1, 1); });
  if (cut.ends[0] == Sign::Zero || cut.ends[1] == Sign::Zero) {
    cut.transverse = false;
    return cut;
  }
  if (cut.ends[0] != cut.ends[1]) {
    cut.roots = 1;
  } else if (form.sign_of([](const auto& f) { return f(0, 1); }) == -cut.ends[0]) {
    const Sign d =
        form.sign_of([](const auto& f) { return f(0, 1) * f(0, 1) - f(0, 0) * f(1, 1); });
    cut.transverse = d != Sign::Zero;
    cut.roots = d == Sign::Positive ? 2 : 0;
  }
  if (cut.roots > 0) place_roots(quadratic_of(form), cut);
  return cut;
}

}  // namespace triplex

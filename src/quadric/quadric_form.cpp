// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/quadric_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/filter.hpp"

namespace triplex {

std::optional<QuadricSurface> quadric_of(const FeatureRow& row) {
  using Kind = QuadricSurface::Kind;
  if (row.feature == Feature::BalancedLinear || row.feature == Feature::BalancedPlanar)
    return QuadricSurface{Kind::Balanced, 0};
  if (row.kind != FeatureKind::LevelSet) return std::nullopt;
  switch (row.level.kind) {
    case LevelSet::Kind::Magnitude:
      return QuadricSurface{Kind::Magnitude, row.level.value};
    case LevelSet::Kind::Isotropicity:
      return QuadricSurface{Kind::Isotropicity, row.level.value};
    case LevelSet::Kind::Traceless:
      break;
  }
  return QuadricSurface{Kind::Traceless, 0};
}

// With M = magnitude, along the longest chain of roundings and with the sum of the absolute values
// of all products:
//   balanced      entries of 3A: 2 roundings, at most 4 M; 9 products of two, 1 rounding, 8 sums:
//                 2 + 2 + 1 + 8 = 13, 9 * 16 M^2
//   magnitude     9 products, 8 sums, 1 difference: 10, 9 M^2 + s^2
//   isotropicity  tr tr: 2 + 2 + 1; 3 eta^2 T:T: 1 + 1 + 9 + 1; 1 difference: 13, (9 + 27) M^2
//   traceless     5 sums in a tree of depth 3: 3, 6 M
// Products below 2^-1022 lose at most 2^-1074 each; M^2 >= 2^-300 times 2^-50 covers that.
double quadric_polar_error(const QuadricSurface& surface, double magnitude) {
  constexpr double kSlack = 1 + 0x1p-20;
  const double m = magnitude;
  if (!(m >= kSmallestFiltered)) return std::numeric_limits<double>::infinity();
  switch (surface.kind) {
    case QuadricSurface::Kind::Balanced:
      return gamma(13) * 144 * m * m * kSlack;
    case QuadricSurface::Kind::Magnitude:
      return gamma(10) * (9 * m * m + surface.value * surface.value) * kSlack;
    case QuadricSurface::Kind::Isotropicity:
      return gamma(13) * 36 * m * m * kSlack;
    case QuadricSurface::Kind::Traceless:
      break;
  }
  return gamma(3) * 6 * m * kSlack;
}

template <int N>
QuadraticForm<double, N> form_approx(const SimplexForm<N>& form) {
  QuadraticForm<double, N> r;
  double largest = 0, width = 0;
  for (std::size_t n = 0; n < r.entries.size(); ++n) {
    const Interval& x = form.enclosure().entries[n];
    r.entries[n] = x.inf() / 2 + x.sup() / 2;
    largest = std::fmax(largest, std::fabs(r.entries[n]));
    width = std::fmax(width, x.sup() - x.inf());
  }
  if (largest > 0x1p-900 && largest < 0x1p900 && width <= 0x1p-36 * largest) {
    const int exponent = std::ilogb(largest);
    for (double& x : r.entries) x = std::ldexp(x, -exponent);
    return r;
  }
  const auto& exact = form.exact().entries;
  std::optional<int> exponent;
  for (const Exact& x : exact)
    if (sign(x) != Sign::Zero)
      exponent = std::max(exponent.value_or(INT32_MIN), binary_exponent(x));
  for (std::size_t n = 0; n < exact.size(); ++n)
    r.entries[n] = sign(exact[n]) == Sign::Zero ? 0 : to_double_approx(exact[n], -*exponent);
  return r;
}

template QuadraticForm<double, 2> form_approx(const SimplexForm<2>&);
template QuadraticForm<double, 3> form_approx(const SimplexForm<3>&);
template QuadraticForm<double, 4> form_approx(const SimplexForm<4>&);

}  // namespace triplex

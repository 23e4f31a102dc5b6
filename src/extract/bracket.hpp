// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "edge_root.hpp"

namespace triplex {

/// A root in doubles of a function that should change sign on [low, high]; an end point if rounding
/// hides the change.
template <class F>
double bracketed_root(const F& f, double low, double high) {
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

/// The smallest power-of-two distance at which the filter `sign_at` sees the sign change around t;
/// 1 if that is beyond `widest`. Below `hopeless` the filter is known to see nothing.
template <class SignAt>
double certified_error(const SignAt& sign_at, double t, bool rising, double hopeless = 0,
                       double widest = kWidestBracket) {
  const Certainty before = rising ? Certainty::Negative : Certainty::Positive;
  const Certainty after = rising ? Certainty::Positive : Certainty::Negative;
  double error = 0x1p-50;
  while (error < std::min(hopeless, widest / 4)) error *= 4;
  for (; error <= widest; error *= 4) {
    const bool left = t - error <= 0 || sign_at(t - error) == before;
    if (left && (t + error >= 1 || sign_at(t + error) == after)) return error;
  }
  return 1;
}

}  // namespace triplex

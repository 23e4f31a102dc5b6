// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/exact.hpp"

namespace triplex {

/// A closed interval.
struct Range {
  double lo = 0, hi = 0;

  bool contains(double x) const { return lo <= x && x <= hi; }
  bool contains(const Range& r) const { return lo <= r.lo && r.hi <= hi; }
  bool meets(const Range& r) const { return lo <= r.hi && r.lo <= hi; }
  double middle() const { return lo + (hi - lo) / 2; }
  friend bool operator==(const Range&, const Range&) = default;
};

/// The double that x is, or two neighbouring doubles between which it lies.
Range enclosure(const Exact& x);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/enclosure.hpp"

#include "triplex/arithmetic/interval.hpp"

namespace triplex {

[[gnu::noinline]] Range enclosure(const Exact& x) {
  const IntervalRounding protect;
  const auto [lo, hi] = CGAL::to_interval(x);
  return (x - Exact(lo)).is_zero() ? Range{lo, lo} : Range{lo, hi};
}

}  // namespace triplex

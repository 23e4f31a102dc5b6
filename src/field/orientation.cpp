// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/orientation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace triplex {

namespace {
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_3 exact(const Point& p) { return {p[0], p[1], p[2]}; }
}  // namespace

Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return static_cast<Sign>(
      static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c), exact(d))));
}

}  // namespace triplex

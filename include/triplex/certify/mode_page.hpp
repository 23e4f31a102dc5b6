// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "triplex/certify/simplex.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex {

/// Mode pages are degenerate pages of the mapped forms (feature/sheet.hpp), so one set of
/// certificates serves them all: a test made for the degenerate page is asked of the mapped forms,
/// on every rung. Source: proofs/mode_page.md.

template <class NT, int N>
Forms<NT, N> mapped(const Forms<NT, N>& f, const ModeMap& map) {
  const NT a(map.p_factor), b(map.q_factor);
  Forms<NT, N> r;
  for (int n = 0; n < kPairs<N>; ++n) r.p[n] = a * f.p[n];
  for (int n = 0; n < kTriples<N>; ++n) r.q[n] = b * f.q[n];
  return r;
}
/// One rounding per coefficient on top of the scaled errors.
inline FormBounds mapped(const FormBounds& bounds, const ModeMap& map) {
  const double a = std::fabs(map.p_factor), b = std::fabs(map.q_factor);
  constexpr double kSlack = 1 + 0x1p-20;
  FormBounds r;
  r.p_magnitude = a * bounds.p_magnitude * kSlack;
  r.q_magnitude = b * bounds.q_magnitude * kSlack;
  r.p_error = (a * bounds.p_error + gamma(1) * a * bounds.p_magnitude) * kSlack;
  r.q_error = (b * bounds.q_error + gamma(1) * b * bounds.q_magnitude) * kSlack;
  return r;
}

/// A test for a degenerate page, asked about a mode page.
template <class Test>
struct Mapped {
  const ModeMap& map;
  Test test;

  template <class NT, int N>
  Verdict operator()(const Forms<NT, N>& f, const FormBounds& bounds) const {
    if (map.is_identity()) return test(f, bounds);
    return test(mapped(f, map), mapped(bounds, map));
  }
};

/// Calls `use(forms, bounds)` with the mapped doubles of a simplex: for the search of witnesses.
template <int N, class Use>
decltype(auto) with_mapped_doubles(const Simplex<N>& simplex, const ModeMap& map, const Use& use) {
  if (map.is_identity()) return use(simplex.approximate(), simplex.bounds());
  return use(mapped(simplex.approximate(), map), mapped(simplex.bounds(), map));
}

}  // namespace triplex

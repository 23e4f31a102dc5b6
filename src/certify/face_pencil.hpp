// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "degenerate_conic.hpp"
#include "triplex/arithmetic/exact.hpp"

namespace triplex {

/// A form of degree four in (s, t): coefficients of s^4, s^3 t, ..., t^4.
template <class NT>
using Quartic = std::array<NT, 5>;

/// The axes n of degenerate tensors on a face lie on two conics. One conic of their pencil passes
/// through a point chosen beforehand; lines through that point parametrise it, n = n(s, t).
template <class NT>
struct FacePencil {
  std::array<Direction<NT>, 3> axis;  ///< n = axis[0] s^2 + axis[1] s t + axis[2] t^2
  Quartic<NT> f;                      ///< the other conic at n(s, t): zero where n is such an axis
  std::array<Quartic<NT>, 3> place;   ///< there proportional to the barycentric coordinates
};

/// Points that conics are made to pass through. Any will do; no coordinate is zero, so that the
/// axes x and y complete a basis.
inline constexpr std::array<std::array<int, 3>, 6> kPoles = {
    {{3, -5, 7}, {-4, 3, 5}, {5, 7, 2}, {2, 3, -7}, {-7, 2, 3}, {11, 5, -3}}};

/// How a pencil is written down.
struct PencilChoice {
  Columns<3> columns{};
  std::size_t pole = 0;
  bool other_is_second = true;  ///< the conic that f comes from
};

/// The form Q at n(s, t).
template <class NT>
Quartic<NT> pulled_back(const Conic<NT>& q, const std::array<Direction<NT>, 3>& n) {
  const NT two(2);
  return {q.at(n[0]), two * q.polar(n[0], n[1]), q.at(n[1]) + two * q.polar(n[0], n[2]),
          two * q.polar(n[1], n[2]), q.at(n[2])};
}

/// The lines through the pole meet C, which passes through it, a second time in
/// (d.Cd) pole - 2 (pole.Cd) d, d = (s, t, 0).
template <class NT>
std::array<Direction<NT>, 3> parametrised(const Conic<NT>& c, const Direction<NT>& pole) {
  const NT two(2);
  const Direction<NT> b = c.times(pole);
  const NT &xx = c.rows[0][0], &xy = c.rows[0][1], &yy = c.rows[1][1];
  std::array<Direction<NT>, 3> n;
  for (std::size_t k = 0; k < 3; ++k) {
    n[0][k] = xx * pole[k];
    n[1][k] = two * xy * pole[k];
    n[2][k] = yy * pole[k];
  }
  n[0][0] = n[0][0] - two * b[0];
  n[1][1] = n[1][1] - two * b[0];
  n[1][0] = n[1][0] - two * b[1];
  n[2][1] = n[2][1] - two * b[1];
  return n;
}

/// The two conics of a face.
template <class NT>
std::array<Conic<NT>, 2> conics_of(const std::array<Components<NT>, 3>& m, const Columns<3>& j) {
  std::array<Conic<NT>, 2> r;
  std::size_t n = 0;
  const NT det = minor_of(m, j);
  for (std::size_t k = 0; k < 5; ++k)
    if (k != j[0] && k != j[1] && k != j[2]) r[n++] = conic_of(relation(m, j, det, k));
  return r;
}

template <class NT>
Direction<NT> pole_of(const PencilChoice& choice) {
  const auto& p = kPoles[choice.pole];
  return {NT(p[0]), NT(p[1]), NT(p[2])};
}

/// The conic of the pencil that passes through the pole.
template <class NT>
Conic<NT> conic_through(const std::array<Conic<NT>, 2>& q, const Direction<NT>& pole) {
  return combination(q[1].at(pole), q[0], NT(0) - q[0].at(pole), q[1]);
}

template <class NT>
FacePencil<NT> pencil_of(const std::array<Components<NT>, 3>& m, const PencilChoice& choice) {
  FacePencil<NT> r;
  const auto q = conics_of(m, choice.columns);
  const Direction<NT> pole = pole_of<NT>(choice);
  r.axis = parametrised(conic_through(q, pole), pole);
  r.f = pulled_back(q[choice.other_is_second ? 1 : 0], r.axis);
  const auto g = place_forms(m, choice.columns);
  for (std::size_t i = 0; i < 3; ++i) r.place[i] = pulled_back(g[i], r.axis);
  return r;
}

}  // namespace triplex

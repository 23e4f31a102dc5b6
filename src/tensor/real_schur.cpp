// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/real_schur.hpp"

#include <array>
#include <cmath>

#include "exact_kernel.hpp"
#include "linear_algebra.hpp"
#include "triplex/tensor/eigenvalues.hpp"
#include "unit_schur.hpp"

namespace triplex {
namespace {

using Frame = std::array<Direction, 3>;

double entry(const Tensor<double>& a, const Direction& left, const Direction& right) {
  return dot(left, times(a, right));
}

// v1 and v2 with fixed signs, v3 completes the rotation.
Frame right_handed(const Direction& v1, const Direction& v2) {
  return {v1, v2, normalized(cross(v1, v2))};
}

Frame frame_in_plane(const Direction& v1, const Direction& normal) {
  const Direction v2 = with_fixed_sign(normalized(cross(normal, v1)));
  return right_handed(with_fixed_sign(v1), v2);
}

// Upper triangular in the frame; the diagonal is known better than by multiplying out.
Tensor<double> triangular(const Tensor<double>& a, const Frame& v,
                          const std::array<double, 3>& diagonal) {
  return {diagonal[0],
          entry(a, v[0], v[1]),
          entry(a, v[0], v[2]),
          0,
          diagonal[1],
          entry(a, v[1], v[2]),
          0,
          0,
          diagonal[2]};
}

// A = x y^T: in the frame x, y, x cross y only one entry is left.
Frame frame_of_rank_one(const Tensor<Exact>& a) {
  const Direction x = exact_kernel(transpose(a)).normal;
  const Direction y = exact_kernel(a).normal;
  return right_handed(with_fixed_sign(x), with_fixed_sign(y));
}

Frame degenerate_frame(const Tensor<double>& t, bool on_spine) {
  const DegeneratePencil pencil = degenerate_pencil(t);
  const ExactKernel kernel = exact_kernel(pencil.repeating);
  if (kernel.dimension == 3) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (kernel.dimension == 2 && on_spine) return frame_of_rank_one(pencil.repeating);
  // The plane is orthogonal to the left eigenvector of the dominant eigenvalue, or of the only one.
  const ExactKernel left = exact_kernel(transpose(on_spine ? pencil.repeating : pencil.dominant));
  return frame_in_plane(kernel.first, left.first);
}

// The first eigenvalue's direction within the plane, from the 2x2 block on the basis z.
Direction direction_in_plane(const Tensor<double>& a, const Direction& z0, const Direction& z1,
                             double l) {
  const double m00 = entry(a, z0, z0) - l;
  const double m01 = entry(a, z0, z1);
  const double m10 = entry(a, z1, z0);
  const double m11 = entry(a, z1, z1) - l;
  const double upper = std::hypot(m00, m01);
  const double lower = std::hypot(m10, m11);
  if (upper == 0 && lower == 0) return z0;
  return upper >= lower ? combination(-m01 / upper, z0, m00 / upper, z1)
                        : combination(-m11 / lower, z0, m10 / lower, z1);
}

UnitSchur real_form(const Tensor<double>& a, const std::array<double, 3>& l) {
  const Direction normal = null_vector(transpose(shifted(a, l[2])));
  const Direction z0 = any_orthogonal(normal);
  const Direction z1 = cross(normal, z0);
  const Frame v = frame_in_plane(normalized(direction_in_plane(a, z0, z1, l[0])), normal);
  return {v, triangular(a, v, l)};
}

// The block on z is turned so that its symmetric part is diagonal. With h = (a-b)/2 the eigenvalues
// are re +- i sqrt(c^2 - h^2): c is taken from h and the known imaginary part.
UnitSchur complex_form(const Tensor<double>& a, const Eigenvalues& l) {
  const Direction normal = null_vector(transpose(shifted(a, l.real[0])));
  const Direction z0 = any_orthogonal(normal);
  const Direction z1 = cross(normal, z0);
  const double b01 = entry(a, z0, z1);
  const double b10 = entry(a, z1, z0);
  const double twice_h = entry(a, z0, z0) - entry(a, z1, z1);
  const double h = std::hypot(twice_h, b01 + b10) / 2;
  const double c = std::hypot(h, l.im);
  const double angle = h == 0 ? 0 : std::atan2(b01 + b10, twice_h) / 2;
  const Direction v1 =
      with_fixed_sign(normalized(combination(std::cos(angle), z0, std::sin(angle), z1)));
  const Direction turned = normalized(cross(normal, v1));
  const bool positive = b10 - b01 > 0;  // then c > 0 with v2 = turned
  const Direction v2 = positive ? turned : Direction{-turned[0], -turned[1], -turned[2]};
  const Frame v = right_handed(v1, v2);
  return {v,
          {l.re + h, -c, entry(a, v[0], v[2]), c, l.re - h, entry(a, v[1], v[2]), 0, 0, l.real[0]}};
}

// The order of the diagonal.
std::array<double, 3> dominant_last(const std::array<double, 3>& l, Sign sign_q) {
  if (sign_q == Sign::Positive) return {l[1], l[2], l[0]};
  if (sign_q == Sign::Zero) return {l[0], l[2], l[1]};
  return l;
}

UnitSchur degenerate_form(const Tensor<double>& t, const Tensor<double>& a, const Invariants& i,
                          const Eigenvalues& l) {
  UnitSchur f;
  f.v = degenerate_frame(t, i.sign_p == Sign::Zero);
  f.s = triangular(a, f.v, dominant_last(l.real, i.sign_q));
  const int n = exact_kernel(degenerate_pencil(t).repeating).dimension;
  if (n > 1) f.s[1] = i.sign_p == Sign::Zero && n == 2 ? f.s[1] : 0;
  if (n > 1 && i.sign_p == Sign::Zero) f.s[2] = f.s[5] = 0;
  return f;
}

}  // namespace

UnitSchur unit_schur(const Tensor<double>& t, const Invariants& i) {
  const UnitDeviator unit = unit_deviator(t);
  const Eigenvalues l = deviator_eigenvalues(i, -unit.exponent);
  UnitSchur form = i.sign_discriminant == Sign::Zero ? degenerate_form(t, unit.a, i, l)
                   : l.all_real ? real_form(unit.a, dominant_last(l.real, i.sign_q))
                                : complex_form(unit.a, l);
  form.exponent = unit.exponent;
  form.im = l.im;
  return form;
}

Tensor<double> RealSchur::form() const {
  Tensor<double> s = deviator;
  for (const int i : {0, 4, 8}) s[i] += mean;
  return s;
}

RealSchur real_schur(const Tensor<double>& t) {
  const UnitSchur unit = unit_schur(t, invariants(t, kEigenvalueAccuracy));
  RealSchur r;
  for (int k = 0; k < 9; ++k) r.rotation[k] = unit.v[k % 3][k / 3];
  for (int k = 0; k < 9; ++k) r.deviator[k] = std::ldexp(unit.s[k], unit.exponent);
  r.mean = trace_approx(t) / 3;
  return r;
}

}  // namespace triplex

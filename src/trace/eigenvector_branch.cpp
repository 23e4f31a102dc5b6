// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "eigenvector_branch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "triplex/tensor/dominant_eigenvector.hpp"
#include "triplex/tensor/eigenvectors.hpp"

namespace triplex::detail {
namespace {

/// The branch's root of l^3 + p l - q, by the trigonometric and hyperbolic formulas.
double root_approx(double p, double q, Branch branch) {
  const double w = std::sqrt(std::fabs(p) / 3);
  const double w3 = 2 * w * w * w;
  const double side = q < 0 ? -1 : 1;
  if (p >= 0) {  // one real root; from p = 0 on w is too small to divide by
    if (!(w3 > 1e-8 * std::fabs(q))) return std::cbrt(q) - p / (3 * std::cbrt(q));
    return 2 * w * std::sinh(std::asinh(q / w3) / 3);
  }
  const double r = q / w3;
  const bool simple = branch == Branch::Simple || (branch == Branch::Major && q > 0) ||
                      (branch == Branch::Minor && q < 0);
  if (std::fabs(r) >= 1 && simple) {
    if (!std::isfinite(r) || std::fabs(r) > 1e8) return std::cbrt(q) - p / (3 * std::cbrt(q));
    return side * 2 * w * std::cosh(std::acosh(std::fabs(r)) / 3);
  }
  const double angle = std::acos(std::clamp(r, -1.0, 1.0)) / 3;
  constexpr double kThird = 2 * std::numbers::pi / 3;
  if (branch == Branch::Simple) branch = q < 0 ? Branch::Minor : Branch::Major;
  if (branch == Branch::Major) return 2 * w * std::cos(angle);
  if (branch == Branch::Minor) return 2 * w * std::cos(angle + kThird);
  return 2 * w * std::cos(angle - kThird);
}

Vector cross(const double* a, const double* b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

}  // namespace

Region region_of_sector(int sector) {
  return sector == 2 ? Region::Linear : sector == 3 ? Region::Planar : Region::Complex;
}

Region region_of(const Classification& c) {
  if (c.stratum == Stratum::Sector) return region_of_sector(c.number);
  if (c.stratum == Stratum::Page && c.number == 3) return Region::Neutral;
  return Region::Complex;  // degenerate surfaces close the complex domain
}

bool holds_in(EigenvectorField field, Branch branch, Region region) {
  if (field == EigenvectorField::Real) return region == Region::Complex;
  if (field != EigenvectorField::Dominant) return region != Region::Complex;
  return branch == branch_in(field, region, branch);
}

Branch branch_in(EigenvectorField field, Region region, Branch present) {
  switch (field) {
    case EigenvectorField::Major:
      return Branch::Major;
    case EigenvectorField::Medium:
      return Branch::Medium;
    case EigenvectorField::Minor:
      return Branch::Minor;
    case EigenvectorField::Real:
      return Branch::Simple;
    case EigenvectorField::Dominant:
      break;
  }
  if (region == Region::Complex) return Branch::Simple;
  if (region == Region::Linear) return Branch::Major;
  if (region == Region::Planar) return Branch::Minor;
  return present == Branch::Minor ? Branch::Minor : Branch::Major;
}

bool eigenvector_approx(const Tensor<double>& t, Branch branch, Vector& v) {
  const double mean = (t[0] + t[4] + t[8]) / 3;
  Tensor<double> a = t;
  for (int i : {0, 4, 8}) a[i] -= mean;
  const double p =
      -(a[0] * a[0] + a[4] * a[4] + a[8] * a[8]) / 2 - a[1] * a[3] - a[2] * a[6] - a[5] * a[7];
  const double q = a[0] * (a[4] * a[8] - a[5] * a[7]) - a[1] * (a[3] * a[8] - a[5] * a[6]) +
                   a[2] * (a[3] * a[7] - a[4] * a[6]);
  double l = root_approx(p, q, branch);
  const double slope = 3 * l * l + p;
  // One step of Newton's method, where the root is simple: 1e-6 is a choice.
  if (std::fabs(slope) > 1e-6 * (std::fabs(p) + l * l)) l -= (l * (l * l + p) - q) / slope;
  for (int i : {0, 4, 8}) a[i] -= l;
  // The columns of the adjugate of A - l I, each a cross product of two rows; the largest one.
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    const Vector c = cross(&a[3 * i], &a[3 * ((i + 1) % 3)]);
    const double n = dot(c, c);
    if (!(n > largest)) continue;
    largest = n;
    v = c;
  }
  if (!(largest > 0) || !std::isfinite(largest)) return false;
  v = (1 / std::sqrt(largest)) * v;
  return true;
}

Vector eigenvector_of(const Tensor<double>& t, Branch branch) {
  if (branch == Branch::Simple) {
    const DominantEigenvector d = dominant_eigenvector(t);
    return d.count == 1 ? d.vectors[0] : kNoDirection;
  }
  const Eigenvectors e = eigenvectors(t);
  const auto i = static_cast<std::size_t>(branch);
  return e.all_real && e.dimensions[i] == 1 ? e.vectors[i] : kNoDirection;
}

}  // namespace triplex::detail

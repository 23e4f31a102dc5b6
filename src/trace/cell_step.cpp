// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cell_step.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

namespace triplex::detail {
namespace odeint = boost::numeric::odeint;
namespace {

using Dopri5 = odeint::runge_kutta_dopri5<Vector>;

/// The smallest t in [lo, hi] at which a cubic, given by its Bernstein coefficients there, is below
/// `bound`, to 2^-depth; subdivision.
std::optional<double> first_below(const std::array<double, 4>& b, double bound, double lo,
                                  double hi, int depth) {
  if (*std::min_element(b.begin(), b.end()) >= bound) return std::nullopt;
  if (b[0] < bound || depth == 0) return lo;
  const double m = (b[1] + b[2]) / 2;
  const double l1 = (b[0] + b[1]) / 2, r2 = (b[2] + b[3]) / 2;
  const double l2 = (l1 + m) / 2, r1 = (m + r2) / 2, c = (l2 + r1) / 2;
  const double middle = (lo + hi) / 2;
  if (const auto t = first_below({b[0], l1, l2, c}, bound, lo, middle, depth - 1)) return t;
  return first_below({c, r1, r2, b[3]}, bound, middle, hi, depth - 1);
}

}  // namespace

CellStep::CellStep(const CellField& cell, Branch branch, const State& from, double error)
    : cell_(cell), branch_(branch), from_(from), error_(error) {
  derivative(from_.position, from_.direction);
}

void CellStep::derivative(const Point& x, Vector& v) const {
  const Vector reference = from_.direction;
  if (!eigenvector_approx(cell_.scaled_tensor(x), branch_, v)) v = reference;
  if (dot(v, reference) < 0) v = -1 * v;
}

State CellStep::step(double length) const {
  State to;
  Dopri5 stepper;
  stepper.do_step([this](const Point& x, Vector& v, double) { derivative(x, v); }, from_.position,
                  from_.direction, 0.0, to.position, to.direction, length);
  return to;
}

State CellStep::controlled_step(double& length, double& proposed) const {
  auto stepper = odeint::make_controlled(error_, 0.0, Dopri5());
  const auto system = [this](const Point& x, Vector& v, double) { derivative(x, v); };
  State to;
  double h = length;
  while (h > error_) {
    double time = 0, next = h;
    const auto result = stepper.try_step(system, from_.position, from_.direction, time, to.position,
                                         to.direction, next);
    if (result == odeint::success) {
      length = h;
      proposed = next;
      return to;
    }
    h = next;
  }
  // Directions are of unit length: a step of length h is off by 2 h at most.
  length = std::fmin(length, error_);
  proposed = 2 * error_;
  return step(length);
}

std::optional<double> CellStep::cubic_exit(int i, double length, const State& to) const {
  const double begin = cell_.barycentric(from_.position)[i];
  const double end = cell_.barycentric(to.position)[i];
  const std::array<double, 4> bernstein = {std::fmax(begin, 0.0),
                                           begin + length * cell_.slope(i, from_.direction) / 3,
                                           end - length * cell_.slope(i, to.direction) / 3, end};
  return first_below(bernstein, -cell_.rounding(), 0, 1, 50);
}

double CellStep::refined_exit(int i, double guess, double length) const {
  // Newton's method for the coordinate along the step, from where the cubic vanishes: it differs
  // from the step by the cubic's small error, so a few rounds reach the rounding.
  double h = guess;
  for (int round = 0; round < 8; ++round) {
    const State at = step(h);
    const double slope = cell_.slope(i, at.direction);
    if (!(slope < 0)) break;  // a grazing touch
    const double correction = cell_.barycentric(at.position)[i] / slope;
    h = std::clamp(h - correction, 0.0, length);
    if (std::fabs(correction) <= 0x1p-50 * cell_.size()) break;
  }
  return h;
}

std::optional<double> CellStep::exit(double length, const State& to) const {
  std::optional<double> first;
  int face = 0;
  for (int i = 0; i < 4; ++i) {
    const auto t = cubic_exit(i, length, to);
    if (!t || (first && *first <= *t * length)) continue;
    first = *t * length;
    face = i;
  }
  if (!first) return std::nullopt;
  double h = refined_exit(face, *first, length);
  // Another face may come first by less than the cubic's error.
  const auto l = cell_.barycentric(step(h).position);
  for (int i = 0; i < 4; ++i)
    if (i != face && l[i] < -cell_.rounding()) h = std::fmin(h, refined_exit(i, h, h));
  return h;
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cell_field.hpp"

namespace triplex::detail {

/// A position, and the unit direction there.
struct State {
  Point position{};
  Vector direction{};
};

/// Runge-Kutta steps of Dormand and Prince (Boost.Odeint) along one branch of the eigenvectors of
/// one tet's linear field, from one state. Directions turn the way of the state's.
class CellStep {
 public:
  /// `error` is the estimated error of position that a step may have.
  CellStep(const CellField& cell, Branch branch, const State& from, double error);

  /// The step of a given length, without a test of its error.
  State step(double length) const;
  /// The largest step not longer than `length` whose error is small enough; sets `length` to its
  /// length and `proposed` to one to try next. A step not longer than the error always is.
  State controlled_step(double& length, double& proposed) const;
  /// The first length in [0, length] at which the curve leaves the tet, if it does; `to` is the
  /// state at `length`.
  std::optional<double> exit(double length, const State& to) const;

 private:
  void derivative(const Point& x, Vector& v) const;
  /// Where the Hermite cubic of coordinate i becomes negative, as a part of the step.
  std::optional<double> cubic_exit(int i, double length, const State& to) const;
  double refined_exit(int i, double guess, double length) const;

  const CellField& cell_;
  Branch branch_;
  State from_;
  double error_;
};

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "degenerate_conic.hpp"
#include "triplex/arithmetic/exact.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/certify/node.hpp"

namespace triplex {

/// The axes n of all degenerate tensors of a linear field: a smooth conic, a circle in the
/// projective plane. From a point inside, every direction meets it once, so a direction (u, v) says
/// where on the circle an axis is; turns count them from 0 to 4. Source: proofs/symmetric_curve.md.
///
/// All members but the constructor's caller need an `IntervalRounding`.
class AxisCircle {
 public:
  /// `conic` vanishes on the axes; `place` are the forms of the barycentric coordinates.
  AxisCircle(const Conic<Exact>& conic, const std::array<Conic<Exact>, 4>& place);

  /// Whether the conic is proven to be smooth and a point inside it was found.
  bool usable() const { return usable_; }

  /// The turn of an axis on the circle; nothing if it cannot be told. `view` turns the axes of
  /// (u, v), 0 <= view < kViews: another one helps where u or v is zero.
  std::optional<Range> turn_of(const std::array<Range, 3>& axis, int view) const;

  /// The signs of the forms of place at a turn: all proven positive, or all negative, or two
  /// different ones, or that cannot be told.
  enum class Side : std::uint8_t { Unknown, Outside, AllPositive, AllNegative };
  Side side_at(double turn, int view) const;
  /// Whether the direction that `side_at` takes for a turn lies strictly between two turns.
  bool is_between(double turn, double low, double high) const;

  /// The barycentric coordinates at a turn, in doubles.
  std::array<double, 4> place_approx(double turn, int view) const;

  static constexpr int kViews = 3;

 private:
  using Axis = Direction<Interval>;
  Axis axis_at(double turn, int view) const;
  std::array<Interval, 4> place_at(double turn, int view) const;

  bool usable_ = false;
  Conic<Interval> conic_;
  std::array<Conic<Interval>, 4> place_;
  std::size_t k_ = 0;          // the largest entry of z
  std::array<double, 3> z_{};  // inside
  Axis w_;                     // conic times z
  Interval value_;             // conic at z
};

}  // namespace triplex

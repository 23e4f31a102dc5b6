// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "degenerate_conic.hpp"
#include "triplex/arithmetic/exact_range.hpp"
#include "triplex/arithmetic/interval.hpp"

namespace triplex {

/// The axes n of all degenerate tensors of a linear field: a smooth conic, a circle in the
/// projective plane. From a point inside, every direction meets it once, so a direction (u, v) says
/// where on the circle an axis is; turns count them from 0 to 4. Source: proofs/symmetric_curve.md.
///
/// NT is `Interval`, with turns in doubles, for which all members but the constructor need an
/// `IntervalRounding`; or `ExactRange`, with exact turns.
template <class NT>
class AxisCircle {
 public:
  using Turn = std::conditional_t<std::is_same_v<NT, Interval>, double, Exact>;
  struct TurnRange {
    Turn lo, hi;
  };

  /// `conic` vanishes on the axes; `place` are the forms of the barycentric coordinates.
  AxisCircle(const Conic<Exact>& conic, const std::array<Conic<Exact>, 4>& place);

  /// Whether the conic is smooth; exact.
  bool smooth() const { return smooth_; }
  /// Whether, moreover, a point inside it was found. The other members need one.
  bool usable() const { return usable_; }

  /// The turn of an axis on the circle; nothing if it cannot be told. `view` turns the axes of
  /// (u, v), 0 <= view < kViews: another one helps where u or v is zero.
  std::optional<TurnRange> turn_of(const std::array<ExactRange, 3>& axis, int view) const;

  /// The signs of the forms of place at a turn: all proven positive, or all negative, or two
  /// different ones, or that cannot be told.
  enum class Side : std::uint8_t { Unknown, Outside, AllPositive, AllNegative };
  Side side_at(const Turn& turn, int view) const;
  /// Whether the direction that `side_at` takes for a turn is proven to lie after `low` and before
  /// `high`, on the way that grows from the one to the other; where high <= low, it passes zero.
  bool is_between(const Turn& turn, const Turn& low, const Turn& high) const;

  /// The barycentric coordinates at a turn, in doubles.
  std::array<double, 4> place_approx(const Turn& turn, int view) const;

  static constexpr int kViews = 3;

 private:
  using Axis = Direction<NT>;
  Axis axis_at(const Turn& turn, int view) const;
  std::array<NT, 4> place_at(const Turn& turn, int view) const;

  bool smooth_ = false, usable_ = false;
  Conic<NT> conic_;
  std::array<Conic<NT>, 4> place_;
  std::size_t k_ = 0;          // the largest entry of z
  std::array<double, 3> z_{};  // inside
  Axis w_;                     // conic times z
  NT value_;                   // conic at z
};

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cell_step.hpp"
#include "cell_walk.hpp"
#include "triplex/trace/tracer.hpp"

namespace triplex::detail {

/// One direction of a hyperstreamline, from the seed.
class HalfTrace {
 public:
  /// The options' length is positive.
  HalfTrace(const CellWalk& walk, const TraceOptions& options);

  /// Follows the curve from the seed's point, whose `forward` says which way.
  StemEnd run(const StemPoint& seed);

  std::vector<StemPoint> points;   ///< the seed first, every `forward` away from it
  std::vector<std::size_t> leaps;  ///< points before a leap

 private:
  struct Advance {
    double length = 0;
    State to;
    Tensor<double> tensor{};
    Classification place;
    bool left = false;     // the step ends on the tet's border
    bool changed = false;  // ... where the sector changes
    bool ended = false;    // ... before the border of the field's domain
    double proposed = 0;
  };
  bool cross_cells();
  std::optional<StemEnd> advance();
  Advance try_step(const CellStep& step, double length) const;
  void see(const CellStep& step, double length, Advance& a) const;
  bool breaks(const Classification& place) const;
  bool keeps(const Classification& place) const;
  bool cut_at_change(const CellStep& step, Advance& a) const;
  void cut_between(const CellStep& step, double lo, double hi, Advance& a) const;
  bool turns_within_error(const Advance& a, const Vector& forward) const;
  std::optional<StemEnd> accept(const Advance& a);
  double growth_of_q(const StemPoint& at, const Vector& direction) const;
  std::optional<StemEnd> turn(const StemPoint& at, Branch next);
  double error() const;

  const CellWalk& walk_;
  const TraceOptions& options_;
  CellField cell_;
  Branch branch_ = Branch::Major;
  double proposed_ = 0;      // length of the next step
  int sector_ = -1;          // of the last point, if it has one
  double last_turn_ = -1;    // arc length of the last jump
  double last_change_ = -1;  // arc length of the last change of sector
  int hops_ = 0;             // changes of tet without progress
};

}  // namespace triplex::detail

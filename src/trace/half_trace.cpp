// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_trace.hpp"

#include <algorithm>
#include <cmath>

#include "triplex/field/progress.hpp"
#include "triplex/trace/stem_events.hpp"

namespace triplex::detail {
namespace {

/// More changes of tet than this without progress end in a step over the border: a choice. The
/// number of tets at a vertex is of that order.
constexpr int kMostHops = 64;

bool is_direction(const Vector& v) { return v[0] == v[0]; }

}  // namespace

HalfTrace::HalfTrace(const CellWalk& walk, const TraceOptions& options)
    : walk_(walk), options_(options), cell_(walk.field(), TetId{0}) {}

double HalfTrace::error() const {
  return std::fmax(options_.tolerance * cell_.size(), cell_.position_rounding());
}

StemEnd HalfTrace::run(const StemPoint& seed) {
  points = {seed};
  cell_ = CellField(walk_.field(), seed.tet);
  branch_ = branch_in(options_.field, region_of(seed.place), Branch::Major);
  proposed_ = cell_.size() / 8;
  for (;;) {
    if (options_.interrupted && *options_.interrupted) throw Interrupted{};
    if (points.back().arc_length >= options_.max_length) return StemEnd::Length;
    if (points.size() > options_.max_steps) return StemEnd::Steps;
    if (hops_ <= kMostHops && !cross_cells()) return StemEnd::Boundary;
    if (const auto end = advance()) return *end;
  }
}

/// Moves to a tet into which the curve leads; false at the boundary of the mesh.
bool HalfTrace::cross_cells() {
  const StemPoint& last = points.back();
  const auto entry = walk_.enter(cell_, last.position, last.forward);
  if (!entry) return false;
  if (entry->tet != cell_.tet()) cell_ = CellField(walk_.field(), entry->tet);
  if (!entry->leapt) return true;
  leaps.push_back(points.size() - 1);
  StemPoint copy = last;
  copy.position = entry->position;
  copy.tet = entry->tet;
  points.push_back(copy);
  return true;
}

void HalfTrace::see(const CellStep& step, double length, Advance& a) const {
  a.length = length;
  a.to = step.step(length);
  a.tensor = cell_.tensor(a.to.position);
  a.region = region_of(classify(a.tensor));
}

/// A step of small error that ends in the tet, at its border or where the branch ceases to hold.
HalfTrace::Advance HalfTrace::try_step(const CellStep& step, double length) const {
  for (;;) {
    Advance a;
    a.length = length;
    a.to = step.controlled_step(a.length, a.proposed);
    if (hops_ <= kMostHops)
      if (const auto border = step.exit(a.length, a.to)) {
        a.left = true;
        a.length = *border;
        a.to = step.step(a.length);
      }
    a.tensor = cell_.tensor(a.to.position);
    a.region = region_of(classify(a.tensor));
    if (cut_at_change(step, a)) return a;
    length = a.length / 2;
  }
}

/// Ends the step where the branch first ceases to hold. False if the straight segment crosses where
/// the curve itself may not: to be tried again with a shorter step.
bool HalfTrace::cut_at_change(const CellStep& step, Advance& a) const {
  const auto holds = [&](Region r) { return holds_in(options_.field, branch_, r); };
  if (!holds(a.region)) {
    cut_between(step, 0, a.length, a);
    return true;
  }
  const Tensor<double>& start = points.back().tensor;
  if (only_sector(start, a.tensor) >= 0) return true;
  const SegmentSectors s = sectors_along(start, a.tensor);
  for (std::size_t i = 0; i < s.stretches.size(); ++i) {
    const auto& stretch = s.stretches[i];
    if (stretch.sector < 0 || holds(region_of_sector(stretch.sector))) continue;
    const double end = i + 1 < s.stretches.size() ? s.stretches[i + 1].begin_approx : 1;
    Advance middle = a;
    see(step, a.length * (stretch.begin_approx + end) / 2, middle);
    if (!holds(middle.region)) {
      cut_between(step, 0, middle.length, middle);
      a = middle;
      return true;
    }
    return a.length <= error();
  }
  return true;
}

/// Bisects between lengths where the branch holds and where it does not, to neighbouring doubles. A
/// field that jumps goes on from behind the change, one that ends stops before it.
void HalfTrace::cut_between(const CellStep& step, double lo, double hi, Advance& a) const {
  Advance at = a;
  for (;;) {
    const double middle = lo + (hi - lo) / 2;
    if (!(lo < middle && middle < hi) || hi - lo <= 0x1p-60 * cell_.size()) break;
    see(step, middle, at);
    (holds_in(options_.field, branch_, at.region) ? lo : hi) = middle;
  }
  a.left = false;
  a.changed = true;
  see(step, options_.field == EigenvectorField::Dominant ? hi : lo, a);
}

std::optional<StemEnd> HalfTrace::advance() {
  const StemPoint& last = points.back();
  const CellStep step(cell_, branch_, {last.position, last.forward}, error());
  const double rest = options_.max_length - last.arc_length;
  double length = std::fmin(std::fmin(proposed_, cell_.size()), rest);
  if (hops_ > kMostHops) length = std::fmin(length, error());
  const Advance a = try_step(step, length);
  hops_ = a.left && a.to.position == last.position ? hops_ + 1 : 0;
  // Steps cut short by a border say nothing about the next one.
  proposed_ = std::fmax(a.proposed, error());
  const bool progress = a.to.position != last.position;
  if (!progress && !a.changed) {
    if (!a.left) return StemEnd::Length;  // what is left of it is below the rounding
    return std::nullopt;
  }
  return accept(a);
}

/// Stores the end of a step, and what follows from a change of region there.
std::optional<StemEnd> HalfTrace::accept(const Advance& a) {
  StemPoint p;
  p.position = a.to.position;
  p.tet = cell_.tet();
  p.tensor = a.tensor;
  p.place = classify(a.tensor);
  p.arc_length = points.back().arc_length + a.length;
  const bool ends = a.changed && options_.field != EigenvectorField::Dominant;
  const bool holds = holds_in(options_.field, branch_, a.region);
  const Branch next = branch_in(options_.field, a.region, branch_);
  // At the real neutral surface the curve arrives along the eigenvector that dominated so far.
  const bool jumps = !holds && branch_ != Branch::Simple && next != Branch::Simple;
  p.forward = eigenvector_of(p.tensor, jumps ? branch_ : next);
  if (!is_direction(p.forward)) return ends ? StemEnd::Domain : StemEnd::NoDirection;
  if (dot(p.forward, points.back().forward) < 0) p.forward = -1 * p.forward;
  if (jumps) return turn(p, next);
  branch_ = next;
  if (p.position != points.back().position) points.push_back(p);
  if (ends) return StemEnd::Domain;
  return std::nullopt;
}

/// Goes on along the other dominant eigenvector, turned by less than a right angle.
std::optional<StemEnd> HalfTrace::turn(const StemPoint& at, Branch next) {
  const bool again = last_turn_ >= 0 && at.arc_length - last_turn_ <= 4 * error();
  if (again) return StemEnd::Sliding;
  if (at.position != points.back().position) points.push_back(at);
  StemPoint after = at;
  after.forward = eigenvector_of(at.tensor, next);
  if (!is_direction(after.forward)) return StemEnd::NoDirection;
  if (dot(after.forward, at.forward) < 0) after.forward = -1 * after.forward;
  points.push_back(after);
  last_turn_ = at.arc_length;
  branch_ = next;
  return std::nullopt;
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "half_trace.hpp"

#include <algorithm>
#include <cmath>

#include "triplex/bernstein/forms.hpp"
#include "triplex/field/progress.hpp"
#include "triplex/trace/stem_events.hpp"

namespace triplex::detail {
namespace {

/// More changes of tet than this without progress end in a step over the border: a choice. The
/// number of tets at a vertex is of that order.
constexpr int kMostHops = 64;

/// The sector of a place, or -1 on a page and on the spine.
int sector_at(const Classification& place) {
  return place.stratum == Stratum::Sector ? place.number : -1;
}

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
  sector_ = sector_at(seed.place);
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
  a.place = classify(a.tensor);
}

/// A step of small error that ends in the tet, at its border or where the sector changes.
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
    a.place = classify(a.tensor);
    if (cut_at_change(step, a)) return a;
    length = a.length / 2;
  }
}

/// The eigenvector that is followed jumps to another one there, or does not exist.
bool HalfTrace::breaks(const Classification& place) const {
  const Region region = region_of(place);
  if (holds_in(options_.field, branch_, region)) return false;
  return options_.field != EigenvectorField::Dominant ||
         (branch_ != Branch::Simple && region != Region::Complex);
}

/// A step may run on there: nothing breaks, and the sector is the same. Crossings of pages end a
/// step too, so that events lie on the curve and not on a chord; but not two in short succession:
/// along a page the sector may change with every rounding.
bool HalfTrace::keeps(const Classification& place) const {
  if (breaks(place)) return false;
  const bool recent = last_change_ >= 0 && points.back().arc_length - last_change_ <= 4 * error();
  if (recent || place.stratum != Stratum::Sector) return true;
  return sector_ < 0 || place.number == sector_;
}

/// Ends the step at the first change. False if the straight segment crosses where the curve itself
/// may not: to be tried again with a shorter step.
bool HalfTrace::cut_at_change(const CellStep& step, Advance& a) const {
  if (!keeps(a.place)) {
    cut_between(step, 0, a.length, a);
    return true;
  }
  const Tensor<double>& start = points.back().tensor;
  if (only_sector(start, a.tensor) >= 0) return true;
  const SegmentSectors s = sectors_along(start, a.tensor);
  for (std::size_t i = 0; i < s.stretches.size(); ++i) {
    const auto& stretch = s.stretches[i];
    if (stretch.sector < 0 || keeps({Stratum::Sector, stretch.sector})) continue;
    const double end = i + 1 < s.stretches.size() ? s.stretches[i + 1].begin_approx : 1;
    Advance middle = a;
    see(step, a.length * (stretch.begin_approx + end) / 2, middle);
    if (!keeps(middle.place)) {
      cut_between(step, 0, middle.length, middle);
      a = middle;
      return true;
    }
    return a.length <= error();
  }
  return true;
}

/// Bisects between lengths before and behind a change, down to rounding. A field that goes on goes
/// on from behind the change, one that ends stops before it.
void HalfTrace::cut_between(const CellStep& step, double lo, double hi, Advance& a) const {
  Advance at = a;
  see(step, hi, a);
  for (;;) {
    const double middle = lo + (hi - lo) / 2;
    if (!(lo < middle && middle < hi) || hi - lo <= 0x1p-60 * cell_.size()) break;
    see(step, middle, at);
    if (keeps(at.place)) {
      lo = middle;
    } else {
      hi = middle;
      a = at;
    }
  }
  a.left = false;
  a.changed = true;
  a.ended = options_.field != EigenvectorField::Dominant && breaks(a.place);
  if (a.ended) see(step, lo, a);
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

/// The direction turns by more than 60 degrees within a length that is not told from none (both
/// numbers are choices): next to a point without a direction, into which curves may run.
bool HalfTrace::turns_within_error(const Advance& a, const Vector& forward) const {
  return a.length <= 64 * error() && dot(forward, points.back().forward) < 0.5;
}

/// Stores the end of a step, and what follows from a change there.
std::optional<StemEnd> HalfTrace::accept(const Advance& a) {
  StemPoint p;
  p.position = a.to.position;
  p.tet = cell_.tet();
  p.tensor = a.tensor;
  p.place = a.place;
  p.arc_length = points.back().arc_length + a.length;
  // At the real neutral surface the curve arrives along the eigenvector that dominated so far.
  const bool jumps = !a.ended && breaks(a.place);
  const Branch next = branch_in(options_.field, region_of(a.place), branch_);
  p.forward = eigenvector_of(p.tensor, jumps ? branch_ : next);
  if (!is_direction(p.forward)) return a.ended ? StemEnd::Domain : StemEnd::NoDirection;
  if (dot(p.forward, points.back().forward) < 0) p.forward = -1 * p.forward;
  if (turns_within_error(a, p.forward)) return StemEnd::NoDirection;
  sector_ = sector_at(p.place);
  if (a.changed) last_change_ = p.arc_length;
  if (jumps) return turn(p, next);
  branch_ = next;
  if (p.position != points.back().position) points.push_back(p);
  if (a.ended) return StemEnd::Domain;
  return std::nullopt;
}

/// How fast q grows along a direction, up to a positive factor.
double HalfTrace::growth_of_q(const StemPoint& at, const Vector& direction) const {
  const Tensor<double> a = triple_deviator(cell_.scaled_tensor(at.position));
  return double_dot(mixed_cofactor(a, a), triple_deviator(cell_.scaled_growth(direction)));
}

/// Goes on along the other dominant eigenvector. That is a line; of its two directions the curve
/// takes the one that leads over to the other side of the surface.
std::optional<StemEnd> HalfTrace::turn(const StemPoint& at, Branch next) {
  const bool again = last_turn_ >= 0 && at.arc_length - last_turn_ <= 4 * error();
  if (again) return StemEnd::Sliding;
  if (at.position != points.back().position) points.push_back(at);
  StemPoint after = at;
  after.forward = eigenvector_of(at.tensor, next);
  if (!is_direction(after.forward)) return StemEnd::NoDirection;
  const double arriving = growth_of_q(at, at.forward), leaving = growth_of_q(at, after.forward);
  const bool turns_back = arriving * leaving < 0;
  const bool along = arriving * leaving == 0 && dot(after.forward, at.forward) < 0;
  if (turns_back || along) after.forward = -1 * after.forward;
  points.push_back(after);
  last_turn_ = at.arc_length;
  branch_ = next;
  return std::nullopt;
}

}  // namespace triplex::detail

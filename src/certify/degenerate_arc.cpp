// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/degenerate_arc.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "axis_circle.hpp"
#include "degenerate_tensors.hpp"

namespace triplex {
namespace {

using Place = std::array<double, 4>;

/// The column left out of the largest minor; nothing if all are zero.
std::optional<std::size_t> best_column_left_out(const std::array<Components<Exact>, 4>& m) {
  constexpr Columns<5> kAll = {0, 1, 2, 3, 4};
  std::optional<std::size_t> best;
  double most = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const Exact minor = minor_of(m, without(kAll, k));
    const double size = std::fabs(to_double_approx(minor));
    if (minor.is_zero() || (best && !(size > most))) continue;
    best = k;
    most = size;
  }
  return best;
}

/// The field in one tet, with four independent tensors.
template <class NT>
class CellLink {
  using Circle = AxisCircle<NT>;
  using Side = typename Circle::Side;
  using Turn = typename Circle::Turn;

  /// Points in order along the circle of axes, and whether the tet is inside after the first one.
  struct CircularOrder {
    std::vector<int> points;
    std::vector<typename Circle::TurnRange> turns;
    int view = 0;
    bool inside_after_first = false;
    bool goes_around(std::size_t n) const { return n + 1 == points.size(); }
  };

 public:
  CellLink(const std::array<Components<Exact>, 4>& m, std::size_t left_out,
           std::span<const CellPoint> points)
      : points_(points) {
    const Columns<4> columns = without(Columns<5>{0, 1, 2, 3, 4}, left_out);
    const Exact det = minor_of(m, columns);
    circle_.emplace(conic_of(relation(m, columns, det, left_out)), place_forms(m, columns));
  }

  CellArcs run() {
    if (!circle_->smooth()) return {{}, CurveObstacle::Crossing};
    const auto order = circle_->usable() ? order_points() : std::nullopt;
    CellArcs result;
    if (order) {
      const std::size_t first = order->inside_after_first ? 0 : 1;
      for (std::size_t n = first; n < order->points.size(); n += 2)
        result.arcs.push_back(arc(*order, n));
    } else if (points_.size() == 2) {
      result.arcs.push_back({points_[0].feature, 0, 1, {}});
    } else {
      result.obstacle = CurveObstacle::Order;
    }
    for (const DegenerateArc& a : result.arcs)
      if (points_[static_cast<std::size_t>(a.from)].feature !=
          points_[static_cast<std::size_t>(a.to)].feature)
        return {{}, CurveObstacle::Order};
    return result;
  }

 private:
  std::optional<CircularOrder> order_points() const {
    for (int view = 0; view < Circle::kViews; ++view)
      if (auto order = order_points(view)) return order;
    return std::nullopt;
  }

  std::optional<CircularOrder> order_points(int view) const {
    std::vector<typename Circle::TurnRange> turns;
    for (const CellPoint& p : points_) {
      const auto turn = circle_->turn_of(p.axis, view);
      if (!turn) return std::nullopt;
      turns.push_back(*turn);
    }
    CircularOrder order;
    order.view = view;
    order.points.resize(points_.size());
    std::iota(order.points.begin(), order.points.end(), 0);
    std::ranges::sort(order.points, {},
                      [&](int n) { return turns[static_cast<std::size_t>(n)].lo; });
    for (const int n : order.points) order.turns.push_back(turns[static_cast<std::size_t>(n)]);
    for (std::size_t n = 0; n + 1 < order.turns.size(); ++n)
      if (!(order.turns[n].hi < order.turns[n + 1].lo)) return std::nullopt;
    if (!find_inside(order)) return std::nullopt;
    return order;
  }

  /// One proven side of one gap between neighbours tells all: they alternate.
  bool find_inside(CircularOrder& order) const {
    for (const double part : {0.5, 0.3, 0.7})
      for (std::size_t n = 0; n < order.points.size(); ++n) {
        const Turn low = order.turns[n].hi, high = end_of_gap(order, n);
        const Turn turn = low + Turn(part) * (high - low);
        const Turn& next = order.turns[order.goes_around(n) ? 0 : n + 1].lo;
        if (!circle_->is_between(turn, low, next)) continue;
        const Side side = circle_->side_at(turn, order.view);
        if (side == Side::Unknown) continue;
        order.inside_after_first = (side != Side::Outside) == (n % 2 == 0);
        return true;
      }
    return false;
  }
  static Turn end_of_gap(const CircularOrder& order, std::size_t n) {
    return order.goes_around(n) ? order.turns[0].lo + Turn(4) : order.turns[n + 1].lo;
  }

  DegenerateArc arc(const CircularOrder& order, std::size_t n) const {
    const int from = order.points[n];
    const int to = order.points[order.goes_around(n) ? 0 : n + 1];
    const CellPoint &a = points_[static_cast<std::size_t>(from)],
                    &b = points_[static_cast<std::size_t>(to)];
    DegenerateArc r{a.feature, from, to, {}};
    add_between(order.turns[n].hi, a.place, end_of_gap(order, n), b.place, order.view,
                kMostHalvings, r.inside);
    return r;
  }

  /// Points that make the chords leave the curve by less than a part of the tet.
  void add_between(const Turn& low, const Place& a, const Turn& high, const Place& b, int view,
                   int halvings, std::vector<Place>& out) const {
    constexpr double kDeviation = 0.005;
    const Turn turn = low + Turn(0.5) * (high - low);
    const Place middle = circle_->place_approx(turn, view);
    double deviation = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(middle[i] > 0)) return;
      deviation = std::max(deviation, std::fabs(middle[i] - (a[i] + b[i]) / 2));
    }
    if (halvings == 0 || deviation < kDeviation) return;
    add_between(low, a, turn, middle, view, halvings - 1, out);
    out.push_back(middle);
    add_between(turn, middle, high, b, view, halvings - 1, out);
  }

  static constexpr int kMostHalvings = 5;
  std::span<const CellPoint> points_;
  std::optional<Circle> circle_;
};

[[gnu::noinline]] CellArcs run_in_intervals(CellLink<Interval>& link) {
  const IntervalRounding protect;
  return link.run();
}

}  // namespace

CellArcs link_degenerate_points(const SymmetricField& field,
                                const std::array<VertexId, 4>& vertices,
                                std::span<const CellPoint> points, AxisPrecision precision) {
  if (points.size() % 2 != 0) return {{}, CurveObstacle::Order};
  const auto m = exact_components(field, vertices);
  const auto left_out = best_column_left_out(m);
  if (!left_out) return {{}, CurveObstacle::FlatCell};
  // No curve stays inside a tet.
  if (points.empty()) return {};
  if (precision == AxisPrecision::High) return CellLink<ExactRange>(m, *left_out, points).run();
  CellLink<Interval> link(m, *left_out, points);
  return run_in_intervals(link);
}

}  // namespace triplex

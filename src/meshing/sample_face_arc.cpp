// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "chart.hpp"
#include "sample_arc.hpp"

namespace triplex {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Of directions that are orthonormal up to 2 / kLeastLength each.
constexpr double kSlack = 16 / kLeastLength;

/// How often a segment is cut, each time into two parts or more.
constexpr int kMostCuts = 16;

/// On a face, f grows at least by `rise` along `up`: the arc is a graph over the line across it.
struct FaceChart {
  Weights up;
  double rise = 0, steepest = 0;  // see Chart
  double stretch = 1;             // length of the graph per length across
};

std::array<Tensor<double>, 3> face_tensors(const CellMap& cell, std::size_t lacking) {
  std::array<Tensor<double>, 3> tensors;
  for (std::size_t i = 0, k = 0; i < 4; ++i) {
    if (i == lacking) continue;
    Weights w{};
    w[i] = 1;
    tensors[k++] = cell.tensor(w);
  }
  return tensors;
}

class FaceArc {
 public:
  FaceArc(const CellMap& cell, const SurfaceFunction& f, std::size_t lacking)
      : cell_(cell), f_(f), lacking_(lacking), corners_(face_tensors(cell, lacking)) {
    const auto corner = [&](std::size_t i) { return cell.corner((lacking + i) % 4); };
    normal_ = (corner(2) - corner(1)).cross(corner(3) - corner(1)).normalized();
  }

  std::optional<FaceChart> chart_along(const Vector& vector) const {
    const double length = vector.norm();
    if (!(length > 0) || !normal_.allFinite()) return std::nullopt;
    const auto up = cell_.direction_in_face(lacking_, vector / length);
    const auto across = cell_.direction_in_face(lacking_, normal_.cross(vector) / length);
    if (!up || !across) return std::nullopt;
    const Bounds growth = growth_along(cell_, f_, corners_, *up);
    if (!(growth.low > 0 || growth.high < 0)) return std::nullopt;
    FaceChart chart;
    chart.up = growth.low > 0 ? *up : -1.0 * *up;
    chart.rise = std::min(std::fabs(growth.low), std::fabs(growth.high)) * (1 - 0x1p-18);
    const double sideways = growth_along(cell_, f_, corners_, *across).largest();
    const double slope = sideways / chart.rise * (1 + kSlack) + kSlack;
    chart.stretch = std::hypot(1.0, slope);
    chart.steepest = std::hypot(growth.largest(), sideways) * (1 + kSlack);
    return std::isfinite(slope) ? std::optional(chart) : std::nullopt;
  }

  std::optional<FaceChart> best_chart() const {
    const Vector along =
        (cell_.corner((lacking_ + 2) % 4) - cell_.corner((lacking_ + 1) % 4)).normalized();
    return chart_along(
        steepest_at_worst(cell_, f_, corners_, std::array{along, Vector(normal_.cross(along))}));
  }
  /// Across the chord, else the best one.
  std::optional<FaceChart> chart(const ArcEnds& ends) const {
    const Vector chord = cell_.position(ends.second) - cell_.position(ends.first);
    if (const auto found = chart_along(normal_.cross(chord))) return found;
    return best_chart();
  }

  /// Of f between a segment and the arc, where f runs from what it is on the segment to zero.
  double largest_value(const Weights& a, const Weights& b) const {
    return f_.largest_value<2>({cell_.tensor(a), cell_.tensor(b)}, cell_.bounds());
  }
  double error_at(const FaceChart& chart, const Weights& w) const {
    return f_.largest_value<1>({cell_.tensor(w)}, cell_.bounds()) / chart.rise * (1 + 0x1p-20);
  }
  /// Appends the points between a and b, so that |f| is within the target on all segments: cut
  /// evenly into as many parts as a parabola asks for, and each of these again if it needs that.
  /// False: it cannot be reached.
  bool add_between(const FaceChart& chart, const Weights& a, const Weights& b, double target,
                   SampledArc& arc, int cuts = 0) const {
    const double now = largest_value(a, b);
    if (!std::isfinite(now) || !(target >= 0)) return false;
    if (now <= target) {
      largest_ = std::max(largest_, now);
      return true;
    }
    if (cuts == kMostCuts) return false;
    constexpr double kMostParts = 1024;
    const double parts = std::clamp(std::ceil(std::sqrt(now / target)), 2.0, kMostParts);
    Weights from = a;
    for (double k = 1; k <= parts; ++k) {
      const bool last = k == parts;
      Weights to = b;
      if (!last) {
        const auto moved =
            move_to_surface(cell_, f_, triplex::between(a, b, k / parts), chart.up, cell_.size());
        if (!moved || *std::ranges::min_element(*moved) < 0) return false;
        to = *moved;
      }
      if (!add_between(chart, from, to, target, arc, cuts + 1)) return false;
      if (!last) arc.between.push_back(to);
      from = to;
    }
    return true;
  }
  double largest() const { return largest_; }

 private:
  const CellMap& cell_;
  const SurfaceFunction& f_;
  const std::size_t lacking_;
  const std::array<Tensor<double>, 3> corners_;
  Vector normal_;
  mutable double largest_ = 0;
};

}  // namespace

double error_on_edge(const CellMap& cell, const SurfaceFunction& f, const Weights& point) {
  std::array<Tensor<double>, 2> ends;
  std::array<std::size_t, 2> corner{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (point[i] == 0) continue;
    if (count == 2) return kInfinite;
    Weights w{};
    w[i] = 1;
    corner[count] = i;
    ends[count++] = cell.tensor(w);
  }
  if (count != 2) return kInfinite;
  Weights along{};
  along[corner[0]] = -1, along[corner[1]] = 1;
  const Bounds growth = growth_along(cell, f, ends, along);
  const double rise = std::max(growth.low, -growth.high);
  if (!(rise > 0)) return kInfinite;
  return f.largest_value<1>({cell.tensor(point)}, cell.bounds()) / rise * (1 + 0x1p-18);
}

bool has_face_chart(const CellMap& cell, const SurfaceFunction& f, std::size_t lacking) {
  return FaceArc(cell, f, lacking).best_chart().has_value();
}

SampledArc sample_face_arc(const CellMap& cell, const SurfaceFunction& f, std::size_t lacking,
                           const ArcEnds& ends, const ArcTarget& target) {
  SampledArc arc;
  const FaceArc face(cell, f, lacking);
  const auto chart = face.chart(ends);
  if (!chart) return arc;
  const double of_ends = ends.error * (1 + chart->stretch);
  if (!(of_ends < kInfinite)) return arc;
  // If the ends alone keep it from the target: as close as it comes.
  const double allowed = std::max(target.deviation - of_ends, of_ends) * chart->rise;
  if (!face.add_between(*chart, ends.first, ends.second, std::min(allowed, target.value), arc)) {
    arc.between.clear();
    return arc;
  }
  arc.value = std::max(face.largest(), chart->steepest * ends.error);
  arc.deviation = (face.largest() / chart->rise + of_ends) * (1 + 0x1p-20);
  for (const Weights& w : arc.between)
    arc.point_error = std::max(arc.point_error, face.error_at(*chart, w));
  return arc;
}

}  // namespace triplex

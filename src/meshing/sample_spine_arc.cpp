// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "chart.hpp"
#include "sample_arc.hpp"
#include "triplex/bernstein/forms.hpp"

namespace triplex {
namespace {

using Pair = Eigen::Vector2d;
using Matrix = Eigen::Matrix2d;

constexpr double kSlack = 1 + 0x1p-18;  // of directions' lengths, and of a bound's own roundings

Pair invariants(const Tensor<double>& a) {
  return {minus_trace_of_product(a, a), double_dot(mixed_cofactor(a, a), a)};
}

/// Derivatives of P and Q at a along two directions, as columns.
Matrix jacobian(const Tensor<double>& a, const std::array<Tensor<double>, 2>& along) {
  Matrix j;
  const Tensor<double> cofactor = mixed_cofactor(a, a);
  for (int k = 0; k < 2; ++k) {
    const Tensor<double>& d = along[static_cast<std::size_t>(k)];
    j(0, k) = 2 * minus_trace_of_product(a, d);
    j(1, k) = 3 * double_dot(cofactor, d);
  }
  return j;
}

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr int kMostHalvings = 24;

constexpr Weights kCentroid = {0.25, 0.25, 0.25, 0.25};

/// Parallel planes in which the curve is followed, the same for the whole arc: spanned by two
/// directions of unit length.
struct Slices {
  std::array<Weights, 2> across;
  std::array<Tensor<double>, 2> tensors;  // of `across`
  Vector normal;
};

class SpineArc {
 public:
  /// With slices across a direction.
  SpineArc(const CellMap& cell, const Vector& direction, double error)
      : cell_(cell), error_(error), slices_(slices(direction)) {}

  bool has_slices() const { return slices_.has_value(); }
  /// (P, Q) is one-to-one on every slice of the cell.
  bool is_injective() const {
    const Matrix c = jacobian(cell_.tensor(kCentroid), slices_->tensors).inverse();
    return c.allFinite() && largest_defect(c, corner_tensors(cell_)) <= 0.5;
  }

  /// Appends the points between a and b. False: the target cannot be reached.
  bool add_between(const Weights& a, const Weights& b, double target, SampledArc& arc,
                   int halvings = 0) {
    const auto now = deviation(a, b);
    if (now && *now <= target) {
      largest_ = std::max(largest_, *now);
      return true;
    }
    if (halvings == kMostHalvings) return false;
    const auto middle = move_to_curve(between(a, b, 0.5));
    if (!middle || *std::ranges::min_element(*middle) < 0 ||
        !add_between(a, *middle, target, arc, halvings + 1))
      return false;
    arc.between.push_back(*middle);
    return add_between(*middle, b, target, arc, halvings + 1);
  }
  double largest() const { return largest_; }
  /// How far a point between proven segments may be from the curve's point in its slice: with C of
  /// its own |I - C J| <= 1/2 around it too, or nothing is said.
  double error_at(const Weights& w) const {
    const Matrix c = jacobian(cell_.tensor(w), slices_->tensors).inverse();
    if (!c.allFinite()) return kInfinite;
    const double residual = largest_residual(c, {cell_.tensor(w), cell_.tensor(w)});
    if (!std::isfinite(residual) || !(defect_around(c, w, w, 2 * residual) <= 0.5))
      return kInfinite;
    return std::sqrt(2.0) * 2 * residual * kSlack;
  }

  /// The curve's point in the slice through `from`.
  std::optional<Weights> move_to_curve(const Weights& from) const {
    constexpr int kSteps = 40;
    const double reach = cell_.size();
    Pair moved = Pair::Zero();
    double last = HUGE_VAL;
    for (int n = 0; n < kSteps; ++n) {
      const Tensor<double> a = cell_.tensor(at(from, moved));
      const Pair step = jacobian(a, slices_->tensors).inverse() * invariants(a);
      if (!((moved - step).norm() <= reach)) return std::nullopt;
      moved -= step;
      if (step.norm() == 0 || (step.norm() >= last && step.norm() < 1e-10 * reach)) break;
      last = step.norm();
    }
    return corrected(at(from, moved));
  }

 private:
  std::optional<Slices> slices(const Vector& direction) const {
    const Vector tangent = direction.normalized();
    if (!cell_.is_usable() || !tangent.allFinite()) return std::nullopt;
    const Vector first = tangent.unitOrthogonal();
    const auto u = cell_.direction(first), v = cell_.direction(tangent.cross(first));
    if (!u || !v) return std::nullopt;
    // What is wrong with their lengths has to be within kSlack.
    const double most = std::max(CellMap::total(*u), CellMap::total(*v));
    if (!(most * cell_.position_error() < 0x1p-21)) return std::nullopt;
    return Slices{{*u, *v}, {cell_.tensor(*u), cell_.tensor(*v)}, tangent};
  }

  /// For every point of the segment, drawn out by the error of the arc's ends: how far in its slice
  /// the curve can be, if in a square around the point there is exactly one zero of F = (P, Q).
  /// With C near the inverse of the Jacobian J, |I - C J| <= k < 1 on all these squares makes
  /// y -> y - C F(y) a contraction, and |C F| <= e at the segment a self-map of the square of
  /// half-width e / (1 - k).
  std::optional<double> deviation(const Weights& first, const Weights& second) const {
    const Vector chord = cell_.offset(second) - cell_.offset(first);
    const double along = std::fabs(slices_->normal.dot(chord));
    if (!(along > error_ && along >= chord.norm() / 2)) return std::nullopt;
    const double beyond = error_ / along * kSlack;
    const Weights a = triplex::between(first, second, -beyond);
    const Weights b = triplex::between(first, second, 1 + beyond);
    const Matrix at_middle = jacobian(cell_.tensor(triplex::between(a, b, 0.5)), slices_->tensors);
    const Matrix c = at_middle.inverse();
    if (!c.allFinite()) return std::nullopt;
    const double residual = largest_residual(c, {cell_.tensor(a), cell_.tensor(b)});
    if (!std::isfinite(residual)) return std::nullopt;
    const double k = defect_around(c, a, b, std::max(2 * residual, 4 * error_));
    if (!(k <= 0.5)) return std::nullopt;
    return std::sqrt(2.0) * residual / (1 - k) * kSlack;
  }

  Weights at(const Weights& from, const Pair& moved) const {
    return from + (moved[0] * slices_->across[0] + moved[1] * slices_->across[1]);
  }

  /// The largest component of C F on the segment, F = (P, Q): from Bernstein coefficients of degree
  /// three.
  double largest_residual(const Matrix& c, const std::array<Tensor<double>, 2>& ends) const {
    const auto f = forms_of<double, 2>(ends);
    const FormBounds bounds(cell_.bounds());
    const std::array<double, 4> p = {f.p[0], (f.p[0] + 2 * f.p[1]) / 3, (2 * f.p[1] + f.p[2]) / 3,
                                     f.p[2]};
    double largest = 0;
    for (int row = 0; row < 2; ++row) {
      const double error = std::fabs(c(row, 0)) * (bounds.p_error + gamma(6) * bounds.p_magnitude) +
                           std::fabs(c(row, 1)) * (bounds.q_error + gamma(3) * bounds.q_magnitude);
      for (std::size_t n = 0; n < 4; ++n)
        largest = std::max(largest, std::fabs(c(row, 0) * p[n] + c(row, 1) * f.q[n]) + error);
    }
    return largest * kSlack;
  }

  /// On the prism that squares of this half-width around the segment's points sweep.
  double defect_around(const Matrix& c, const Weights& a, const Weights& b, double radius) const {
    std::array<Tensor<double>, 8> corners;
    std::size_t n = 0;
    for (const Weights& end : {a, b})
      for (const double x : {-radius, radius})
        for (const double y : {-radius, radius}) {
          const Weights corner = at(end, {x, y});
          if (!(CellMap::total(corner) <= CellMap::kMostWeight)) return kInfinite;
          corners[n++] = cell_.tensor(corner);
        }
    return largest_defect(c, corners);
  }

  /// The largest row sum of |I - C J| on the hull of some tensors: derivatives of P are linear, and
  /// those of Q have the polar forms between the tensors as bounds.
  double largest_defect(const Matrix& c, std::span<const Tensor<double>> corners) const {
    // Directions have unit length, not weights of at most two: their tensors' errors grow as they
    // do.
    double longest = 1;
    for (const Weights& w : slices_->across)
      longest =
          std::max(longest, std::fabs(w[0]) + std::fabs(w[1]) + std::fabs(w[2]) + std::fabs(w[3]));
    const FormBounds bounds(cell_.bounds());
    std::array<double, 2> row_sum{};
    for (int k = 0; k < 2; ++k) {
      const Tensor<double>& d = slices_->tensors[static_cast<std::size_t>(k)];
      std::array<double, 2> worst{};
      for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i; j < corners.size(); ++j) {
          const double dp =
              minus_trace_of_product(corners[i], d) + minus_trace_of_product(corners[j], d);
          const double dq = 3 * double_dot(mixed_cofactor(corners[i], corners[j]), d);
          for (int row = 0; row < 2; ++row)
            worst[static_cast<std::size_t>(row)] =
                std::max(worst[static_cast<std::size_t>(row)],
                         std::fabs((row == k ? 1 : 0) - (c(row, 0) * dp + c(row, 1) * dq)));
        }
      for (int row = 0; row < 2; ++row)
        row_sum[static_cast<std::size_t>(row)] +=
            worst[static_cast<std::size_t>(row)] +
            longest * (2 * std::fabs(c(row, 0)) * (bounds.p_error + gamma(6) * bounds.p_magnitude) +
                       3 * std::fabs(c(row, 1)) * (bounds.q_error + gamma(6) * bounds.q_magnitude));
    }
    return std::max(row_sum[0], row_sum[1]) * kSlack + 0x1p-16;
  }

  const CellMap& cell_;
  const double error_;  // of the arc's ends
  const std::optional<Slices> slices_;
  double largest_ = 0;
};

/// Inside the cell by more than this distance.
bool is_inside(const CellMap& cell, const Weights& w, double distance) {
  return *std::ranges::min_element(w) * cell.least_height() > distance;
}

/// Along the curve through the centroid, as if it passed there.
Vector tangent_at_centroid(const CellMap& cell) {
  std::array<Vector, 2> gradients;
  const Tensor<double> a = cell.tensor(kCentroid);
  const Tensor<double> cofactor = mixed_cofactor(a, a);
  for (std::size_t i = 1; i < 4; ++i) {
    const Tensor<double> along = cell.tensor(cell.edge_direction(i));
    const auto k = static_cast<Eigen::Index>(i - 1);
    gradients[0][k] = minus_trace_of_product(a, along);
    gradients[1][k] = double_dot(cofactor, along);
  }
  const auto p = cell.gradient(gradients[0]), q = cell.gradient(gradients[1]);
  return p && q ? p->normalized().cross(q->normalized()) : Vector::Zero();
}

SampledArc sample_across(const CellMap& cell, const Vector& direction, const ArcEnds& ends,
                         double target) {
  SampledArc arc;
  SpineArc spine(cell, direction, ends.error);
  if (!spine.has_slices()) return arc;
  // A point inside the cell says that this is the way on which the curve runs there.
  const auto middle = spine.move_to_curve(between(ends.first, ends.second, 0.5));
  const double allowed = target - 4 * ends.error;
  if (!middle || !spine.add_between(ends.first, *middle, allowed, arc)) return {};
  arc.between.push_back(*middle);
  if (!spine.add_between(*middle, ends.second, allowed, arc)) return {};
  const double deviation = (spine.largest() + 4 * ends.error) * (1 + 0x1p-20);
  if (is_inside(cell, *middle, spine.error_at(*middle))) arc.deviation = deviation;
  for (const Weights& w : arc.between)
    arc.point_error = std::max(arc.point_error, spine.error_at(w));
  return arc;
}

}  // namespace

bool has_spine_slices(const CellMap& cell) {
  const SpineArc spine(cell, tangent_at_centroid(cell), 0);
  return spine.has_slices() && spine.is_injective();
}

SampledArc sample_spine_arc(const CellMap& cell, const ArcEnds& ends, double target) {
  if (!(ends.error < target / 8) || !std::isfinite(target)) return {};
  const Vector chord = cell.offset(ends.second) - cell.offset(ends.first);
  if (SampledArc arc = sample_across(cell, chord, ends, target); arc.deviation <= target)
    return arc;
  return sample_across(cell, tangent_at_centroid(cell), ends, target);
}

}  // namespace triplex

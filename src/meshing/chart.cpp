// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "triplex/certify/witness.hpp"

namespace triplex {
std::array<Tensor<double>, 4> corner_tensors(const CellMap& cell) {
  std::array<Tensor<double>, 4> tensors;
  for (std::size_t i = 0; i < 4; ++i) {
    Weights w{};
    w[i] = 1;
    tensors[i] = cell.tensor(w);
  }
  return tensors;
}

std::optional<Vector> gradient_at(const CellMap& cell, const SurfaceFunction& f, const Weights& w) {
  const Tensor<double> a = cell.tensor(w);
  Vector along_edges;
  for (std::size_t i = 1; i < 4; ++i)
    along_edges[static_cast<Eigen::Index>(i - 1)] =
        f.derivative(a, cell.tensor(cell.edge_direction(i)));
  return cell.gradient(along_edges);
}

/// The direction is made as long as the weights allow, so that the errors of its tensor are those
/// of any other; its length is then computed anew from the weights.
Bounds growth_along(const CellMap& cell, const SurfaceFunction& f,
                    std::span<const Tensor<double>> hull, const Weights& direction) {
  const double sum = CellMap::total(direction);
  if (!cell.is_usable() || !(sum > 0) || !std::isfinite(1 / sum)) return {-HUGE_VAL, HUGE_VAL};
  const Weights w = (CellMap::kMostWeight / sum * (1 - 0x1p-40)) * direction;
  const double length = cell.offset(w).norm();
  const double error = 2 * cell.position_error();  // of both ends
  if (!(length > kLeastLength * error)) return {-HUGE_VAL, HUGE_VAL};
  Bounds growth = f.derivative_on(hull, cell.tensor(w), cell.bounds());
  const double longest = (length + error) * (1 + 0x1p-40);
  const double shortest = (length - error) * (1 - 0x1p-40);
  growth.low /= growth.low > 0 ? longest : shortest;
  growth.high /= growth.high > 0 ? shortest : longest;
  return growth;
}

std::optional<Chart> chart_along(const CellMap& cell, const SurfaceFunction& f,
                                 const Vector& direction) {
  const double length = direction.norm();
  if (!(length > 0) || !std::isfinite(1 / length)) return std::nullopt;
  const auto up = cell.direction(direction / length);
  if (!up) return std::nullopt;
  const auto hull = corner_tensors(cell);
  const Bounds growth = growth_along(cell, f, hull, *up);
  if (!(growth.low > 0 || growth.high < 0)) return std::nullopt;
  Chart chart;
  chart.origin = cell.corner(0);
  chart.up_weights = growth.low > 0 ? *up : -1.0 * *up;
  chart.up = cell.offset(chart.up_weights).normalized();
  chart.rise = std::min(std::fabs(growth.low), std::fabs(growth.high)) * (1 - 0x1p-18);
  // The vector of the weights is as wrong as positions are, times the sum of the weights (which
  // also covers the roundings of its terms); over the length of the cell points move by that.
  chart.drift = 2 * CellMap::total(*up) * cell.position_error() * cell.size();

  chart.across1 = chart.up.unitOrthogonal();
  chart.across2 = chart.up.cross(chart.across1);
  std::array<double, 3> most = {growth.largest(), 0, 0};
  for (std::size_t k = 1; k < 3; ++k) {
    const auto w = cell.direction(k == 1 ? chart.across1 : chart.across2);
    if (!w) return std::nullopt;
    most[k] = growth_along(cell, f, hull, *w).largest();
  }
  // The true directions are orthonormal up to 2 / kLeastLength each.
  chart.steepest = std::hypot(most[0], most[1], most[2]) * (1 + 16 / kLeastLength);
  return std::isfinite(chart.steepest) && chart.steepest > 0 ? std::optional(chart) : std::nullopt;
}

Vector steepest_at_worst(const CellMap& cell, const SurfaceFunction& f,
                         std::span<const Tensor<double>> hull, std::span<const Vector> directions) {
  std::vector<Tensor<double>> tensors;
  for (const Vector& d : directions) {
    const auto w = cell.direction(d);
    if (!w) return Vector::Zero();
    tensors.push_back(cell.tensor(*w));
  }
  const auto weights = separating_direction(f.derivatives_approx(hull, tensors));
  Vector sum = Vector::Zero();
  for (std::size_t k = 0; k < directions.size(); ++k) sum += weights[k] * directions[k];
  return sum;
}

std::optional<Chart> best_chart(const CellMap& cell, const SurfaceFunction& f) {
  const std::array<Vector, 3> axes = {Vector::UnitX(), Vector::UnitY(), Vector::UnitZ()};
  return chart_along(cell, f, steepest_at_worst(cell, f, corner_tensors(cell), axes));
}

std::optional<Weights> move_to_surface(const CellMap& cell, const SurfaceFunction& f, Weights from,
                                       const Weights& direction, double reach) {
  constexpr int kSteps = 40;
  const Tensor<double> along = cell.tensor(direction);
  double moved = 0, last = HUGE_VAL;
  for (int n = 0; n < kSteps; ++n) {
    const Weights at = from + moved * direction;
    const Tensor<double> a = cell.tensor(at);
    const double slope = f.derivative(a, along);
    if (!(slope > 0)) return std::nullopt;
    const double step = f.value(a) / slope;
    if (!(std::fabs(moved - step) <= reach)) return std::nullopt;
    moved -= step;
    // Near the root steps shrink to rounding and then stop shrinking.
    if (step == 0 || (std::fabs(step) >= last && std::fabs(step) < 1e-10 * reach)) break;
    last = std::fabs(step);
  }
  return corrected(from + moved * direction);
}

}  // namespace triplex

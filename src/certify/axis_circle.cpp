// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis_circle.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/sign.hpp"

namespace triplex {
namespace {

/// (u, v) of the original view = (a u - b v, b u + a v) / (a^2 + b^2).
constexpr std::array<std::array<int, 2>, AxisCircle::kViews> kTurned = {{{1, 0}, {4, 3}, {5, -12}}};

Conic<Interval> to_intervals(const Conic<Exact>& q, const Exact& scale) {
  Conic<Interval> r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const auto [lo, hi] = CGAL::to_interval(scale * q.rows[i][j]);
      r.rows[i][j] = Interval(lo, hi);
    }
  return r;
}

/// A power of two that makes the largest coefficient about one.
Exact unit_scale(std::span<const Conic<Exact>> conics) {
  int exponent = -10000;
  for (const auto& q : conics)
    for (const auto& row : q.rows)
      for (const Exact& x : row)
        if (!x.is_zero()) exponent = std::max(exponent, binary_exponent(x));
  if (exponent == -10000) return Exact(1);
  return Exact(std::ldexp(1.0, -(exponent / 2))) *
         Exact(std::ldexp(1.0, -(exponent - exponent / 2)));
}

/// A vector that is alone with the sign of its value, of a form that has one sign once and the
/// other twice.
Eigen::Vector3d inside_approx(const Conic<Exact>& conic, const Exact& scale, Sign of_determinant) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      m(i, j) = to_double_approx(
          scale * conic.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  return solver.eigenvectors().col(of_determinant == Sign::Positive ? 2 : 0);
}

Sign sign_of(const Interval& x) {
  return x.inf() > 0 ? Sign::Positive : x.sup() < 0 ? Sign::Negative : Sign::Zero;
}

/// The direction at a turn, with |u| + |v| = 1 up to rounding.
std::array<double, 2> direction_at(double turn) {
  const double t = turn - 4 * std::floor(turn / 4);
  const int quadrant = std::min(3, static_cast<int>(t));
  const double r = t - quadrant;
  switch (quadrant) {
    case 0:
      return {1 - r, r};
    case 1:
      return {-r, 1 - r};
    case 2:
      return {r - 1, -r};
    default:
      return {r, r - 1};
  }
}

/// Monotone in the angle, from 0 to 4. Nothing if the quadrant is not known.
std::optional<Interval> turn_of_direction(const Interval& u, const Interval& v) {
  const Sign su = sign_of(u), sv = sign_of(v);
  if (su == Sign::Zero || sv == Sign::Zero) return std::nullopt;
  const Interval length = CGAL::abs(u) + CGAL::abs(v);
  if (su == Sign::Positive) return sv == Sign::Positive ? v / length : Interval(3.0) + u / length;
  return sv == Sign::Positive ? Interval(1.0) - u / length : Interval(2.0) - v / length;
}

}  // namespace

AxisCircle::AxisCircle(const Conic<Exact>& conic, const std::array<Conic<Exact>, 4>& place) {
  const Sign determinant = sign(conic.determinant());
  if (determinant == Sign::Zero) return;
  const Exact scale = unit_scale(std::span(&conic, 1));
  const Eigen::Vector3d z = inside_approx(conic, scale, determinant);
  for (std::size_t i = 0; i < 3; ++i) z_[i] = z[static_cast<int>(i)];
  for (std::size_t i = 1; i < 3; ++i)
    if (std::fabs(z_[i]) > std::fabs(z_[k_])) k_ = i;
  if (z_[k_] < 0)
    for (double& x : z_) x = -x;
  const Direction<Exact> exact = {Exact(z_[0]), Exact(z_[1]), Exact(z_[2])};
  // The eigenvalue that is alone has the sign of the determinant.
  const Exact value = scale * conic.at(exact);
  usable_ = z_[k_] > 0 && sign(value) == determinant;
  if (!usable_) return;
  conic_ = to_intervals(conic, scale);
  const Exact scale_of_place = unit_scale(place);
  for (std::size_t i = 0; i < 4; ++i) place_[i] = to_intervals(place[i], scale_of_place);
  const Direction<Exact> w = conic.times(exact);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [lo, hi] = CGAL::to_interval(scale * w[i]);
    w_[i] = Interval(lo, hi);
  }
  const auto [lo, hi] = CGAL::to_interval(value);
  value_ = Interval(lo, hi);
}

/// With i = k and j, m the next two, u = z_i n_m - z_m n_i and v = z_j n_i - z_i n_j vanish at z.
std::optional<Range> AxisCircle::turn_of(const std::array<Range, 3>& axis, int view) const {
  Axis n;
  for (std::size_t c = 0; c < 3; ++c) n[c] = Interval(axis[c].lo, axis[c].hi);
  const Sign side = sign_of(dot(w_, n));
  if (side == Sign::Zero) return std::nullopt;
  const std::size_t i = k_, j = (k_ + 1) % 3, m = (k_ + 2) % 3;
  const Interval s(static_cast<double>(side));
  const Interval u0 = s * (Interval(z_[i]) * n[m] - Interval(z_[m]) * n[i]);
  const Interval v0 = s * (Interval(z_[j]) * n[i] - Interval(z_[i]) * n[j]);
  const auto& [a, b] = kTurned[static_cast<std::size_t>(view)];
  const Interval ca(static_cast<double>(a)), cb(static_cast<double>(b));
  const auto turn = turn_of_direction(ca * u0 + cb * v0, ca * v0 - cb * u0);
  if (!turn) return std::nullopt;
  return Range{turn->inf(), turn->sup()};
}

bool AxisCircle::is_between(double turn, double low, double high) const {
  const auto [u, v] = direction_at(turn);
  const auto t = turn_of_direction(Interval(u), Interval(v));
  if (!t) return false;
  return (t->inf() > low && t->sup() < high) || (t->inf() + 4 > low && t->sup() + 4 < high);
}

/// With e_0 the direction in the plane n_i = 0, e = |q| e_0 - sign(q) (w.e_0) z has w.e = 0; then
/// n = sign(q) r z + |q| e with r^2 = -q Q(e) is on the conic, and w.n = r |q| > 0.
AxisCircle::Axis AxisCircle::axis_at(double turn, int view) const {
  const auto [u1, v1] = direction_at(turn);
  const auto& [a, b] = kTurned[static_cast<std::size_t>(view)];
  const Interval ca(static_cast<double>(a)), cb(static_cast<double>(b));
  const Interval u = ca * Interval(u1) - cb * Interval(v1),
                 v = cb * Interval(u1) + ca * Interval(v1);
  const std::size_t j = (k_ + 1) % 3, m = (k_ + 2) % 3;
  Axis e0;
  e0[k_] = Interval(0.0);
  e0[j] = -v;
  e0[m] = u;
  const Interval sign_of_value(value_.inf() > 0 ? 1.0 : -1.0);
  const Interval size = sign_of_value * value_;
  const Interval t = sign_of_value * dot(w_, e0);
  Axis e, n;
  for (std::size_t c = 0; c < 3; ++c) e[c] = size * e0[c] - t * Interval(z_[c]);
  Interval square = -(value_ * conic_.at(e));
  if (square.inf() < 0) square = Interval(0.0, std::max(0.0, square.sup()));
  const Interval r = sign_of_value * CGAL::sqrt(square);
  for (std::size_t c = 0; c < 3; ++c) n[c] = r * Interval(z_[c]) + size * e[c];
  return n;
}

std::array<Interval, 4> AxisCircle::place_at(double turn, int view) const {
  const Axis n = axis_at(turn, view);
  return {place_[0].at(n), place_[1].at(n), place_[2].at(n), place_[3].at(n)};
}

AxisCircle::Side AxisCircle::side_at(double turn, int view) const {
  int positive = 0, negative = 0;
  for (const Interval& x : place_at(turn, view)) {
    positive += x.inf() > 0;
    negative += x.sup() < 0;
  }
  if (positive > 0 && negative > 0) return Side::Outside;
  return positive == 4 ? Side::AllPositive : negative == 4 ? Side::AllNegative : Side::Unknown;
}

std::array<double, 4> AxisCircle::place_approx(double turn, int view) const {
  std::array<double, 4> x;
  double sum = 0;
  const auto place = place_at(turn, view);
  for (std::size_t i = 0; i < 4; ++i) sum += x[i] = (place[i].inf() + place[i].sup()) / 2;
  for (double& c : x) c /= sum;
  return x;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "axis_circle.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <span>
#include <vector>

#include "degenerate_tensors.hpp"
#include "triplex/arithmetic/exact_conversion.hpp"
#include "triplex/arithmetic/sign.hpp"

namespace triplex {
namespace {

/// (u, v) of the original view = (a u - b v, b u + a v) / (a^2 + b^2).
constexpr std::array<std::array<int, 2>, 3> kTurned = {{{1, 0}, {4, 3}, {5, -12}}};

// What the two kinds of numbers do differently.
template <class NT>
NT enclosure(const Exact& x);
template <>
Interval enclosure<Interval>(const Exact& x) {
  const auto [lo, hi] = CGAL::to_interval(x);
  return {lo, hi};
}
template <>
ExactRange enclosure<ExactRange>(const Exact& x) {
  return x;
}
Interval enclosure_of(const ExactRange& x, const Interval&) {
  return {CGAL::to_interval(x.lo).first, CGAL::to_interval(x.hi).second};
}
const ExactRange& enclosure_of(const ExactRange& x, const ExactRange&) { return x; }

double low(const Interval& x) { return x.inf(); }
double high(const Interval& x) { return x.sup(); }
const Exact& low(const ExactRange& x) { return x.lo; }
const Exact& high(const ExactRange& x) { return x.hi; }
Sign sign_of(double x) { return x > 0 ? Sign::Positive : x < 0 ? Sign::Negative : Sign::Zero; }
Sign sign_of(const Exact& x) { return sign(x); }
double middle_approx(const Interval& x) { return (x.inf() + x.sup()) / 2; }
double middle_approx(const ExactRange& x) { return to_double_approx(x.lo + x.hi) / 2; }
Interval root_of(const Interval& x) {
  return CGAL::sqrt(Interval(std::max(0.0, x.inf()), x.sup()));
}
ExactRange root_of(const ExactRange& x) { return sqrt(x); }
Interval size_of(const Interval& x) { return CGAL::abs(x); }
ExactRange size_of(const ExactRange& x) { return abs(x); }

/// Zero if it is not known.
template <class NT>
Sign proven_sign(const NT& x) {
  if (sign_of(low(x)) == Sign::Positive) return Sign::Positive;
  return sign_of(high(x)) == Sign::Negative ? Sign::Negative : Sign::Zero;
}

template <class NT>
Conic<NT> enclosure(const Conic<Exact>& q, const Exact& scale) {
  Conic<NT> r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r.rows[i][j] = enclosure<NT>(scale * q.rows[i][j]);
  return r;
}

/// A power of two that makes the largest coefficient about one.
Exact unit_scale(std::span<const Conic<Exact>> conics) {
  std::vector<Exact> all;
  for (const auto& q : conics)
    for (const auto& row : q.rows) all.insert(all.end(), row.begin(), row.end());
  return times_power_of_two(Exact(1), -common_exponent(all));
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

/// The direction at a turn, with |u| + |v| = 1 up to rounding.
template <class Turn>
std::array<Turn, 2> direction_at(const Turn& turn) {
  int quadrant = 0;
  Turn r = turn;
  while (sign_of(Turn(r - Turn(1))) != Sign::Negative) {
    r = r - Turn(1);
    quadrant = (quadrant + 1) % 4;
  }
  const Turn s = Turn(1) - r;
  switch (quadrant) {
    case 0:
      return {s, r};
    case 1:
      return {-r, s};
    case 2:
      return {-s, -r};
    default:
      return {r, -s};
  }
}

/// Monotone in the angle, from 0 to 4. Nothing if the quadrant is not known.
template <class NT>
std::optional<NT> turn_of_direction(const NT& u, const NT& v) {
  const Sign su = proven_sign(u), sv = proven_sign(v);
  if (su == Sign::Zero || sv == Sign::Zero) return std::nullopt;
  const NT length = size_of(u) + size_of(v);
  if (su == Sign::Positive) return sv == Sign::Positive ? v / length : NT(3.0) + u / length;
  return sv == Sign::Positive ? NT(1.0) - u / length : NT(2.0) - v / length;
}

}  // namespace

template <class NT>
AxisCircle<NT>::AxisCircle(const Conic<Exact>& conic, const std::array<Conic<Exact>, 4>& place) {
  const Sign determinant = sign(conic.determinant());
  smooth_ = determinant != Sign::Zero;
  if (!smooth_) return;
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
  conic_ = enclosure<NT>(conic, scale);
  value_ = enclosure<NT>(value);
  const Direction<Exact> w = conic.times(exact);
  for (std::size_t i = 0; i < 3; ++i) w_[i] = enclosure<NT>(scale * w[i]);
  const Exact scale_of_place = unit_scale(place);
  for (std::size_t i = 0; i < 4; ++i) place_[i] = enclosure<NT>(place[i], scale_of_place);
}

/// With i = k and j, m the next two, u = z_i n_m - z_m n_i and v = z_j n_i - z_i n_j vanish at z.
template <class NT>
auto AxisCircle<NT>::turn_of(const std::array<ExactRange, 3>& axis, int view) const
    -> std::optional<TurnRange> {
  Axis n;
  for (std::size_t c = 0; c < 3; ++c) n[c] = enclosure_of(axis[c], value_);
  const Sign side = proven_sign(dot(w_, n));
  if (side == Sign::Zero) return std::nullopt;
  const std::size_t i = k_, j = (k_ + 1) % 3, m = (k_ + 2) % 3;
  const NT s(static_cast<double>(side));
  const NT u = s * (NT(z_[i]) * n[m] - NT(z_[m]) * n[i]);
  const NT v = s * (NT(z_[j]) * n[i] - NT(z_[i]) * n[j]);
  const auto& [a, b] = kTurned[static_cast<std::size_t>(view)];
  const auto turn = turn_of_direction<NT>(NT(a) * u + NT(b) * v, NT(a) * v - NT(b) * u);
  if (!turn) return std::nullopt;
  return TurnRange{low(*turn), high(*turn)};
}

template <class NT>
bool AxisCircle<NT>::is_between(const Turn& turn, const Turn& low_end, const Turn& high_end) const {
  const auto [u, v] = direction_at(turn);
  const auto t = turn_of_direction<NT>(NT(u), NT(v));
  if (!t) return false;
  const bool after = proven_sign(NT(*t - NT(low_end))) == Sign::Positive;
  const bool before = proven_sign(NT(NT(high_end) - *t)) == Sign::Positive;
  return low_end < high_end ? after && before : after || before;
}

/// With e_0 the direction in the plane n_i = 0, e = |q| e_0 - sign(q) (w.e_0) z has w.e = 0; then
/// n = sign(q) r z + |q| e with r^2 = -q Q(e) is on the conic, and w.n = r |q| > 0.
template <class NT>
auto AxisCircle<NT>::axis_at(const Turn& turn, int view) const -> Axis {
  const auto [u1, v1] = direction_at(turn);
  const auto& [a, b] = kTurned[static_cast<std::size_t>(view)];
  const std::size_t j = (k_ + 1) % 3, m = (k_ + 2) % 3;
  Axis e0;
  e0[k_] = NT(0.0);
  e0[j] = -(NT(b) * NT(u1) + NT(a) * NT(v1));
  e0[m] = NT(a) * NT(u1) - NT(b) * NT(v1);
  const NT sign_of_value(static_cast<double>(proven_sign(value_)));
  const NT size = sign_of_value * value_;
  const NT t = sign_of_value * dot(w_, e0);
  Axis e, n;
  for (std::size_t c = 0; c < 3; ++c) e[c] = size * e0[c] - t * NT(z_[c]);
  const NT r = sign_of_value * root_of(-(value_ * conic_.at(e)));
  for (std::size_t c = 0; c < 3; ++c) n[c] = r * NT(z_[c]) + size * e[c];
  return n;
}

template <class NT>
std::array<NT, 4> AxisCircle<NT>::place_at(const Turn& turn, int view) const {
  const Axis n = axis_at(turn, view);
  return {place_[0].at(n), place_[1].at(n), place_[2].at(n), place_[3].at(n)};
}

template <class NT>
auto AxisCircle<NT>::side_at(const Turn& turn, int view) const -> Side {
  int positive = 0, negative = 0;
  for (const NT& x : place_at(turn, view)) {
    positive += proven_sign(x) == Sign::Positive;
    negative += proven_sign(x) == Sign::Negative;
  }
  if (positive > 0 && negative > 0) return Side::Outside;
  return positive == 4 ? Side::AllPositive : negative == 4 ? Side::AllNegative : Side::Unknown;
}

template <class NT>
std::array<double, 4> AxisCircle<NT>::place_approx(const Turn& turn, int view) const {
  std::array<double, 4> x;
  double sum = 0;
  const auto place = place_at(turn, view);
  for (std::size_t i = 0; i < 4; ++i) sum += x[i] = middle_approx(place[i]);
  for (double& c : x) c /= sum;
  return x;
}

template class AxisCircle<Interval>;
template class AxisCircle<ExactRange>;

}  // namespace triplex

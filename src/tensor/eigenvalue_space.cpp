// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/tensor/eigenvalue_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "linear_algebra.hpp"

namespace triplex {
namespace {

using Point2 = std::array<double, 2>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kHalfRoot3 = std::numbers::sqrt3 / 2;
constexpr Sign kMinus = Sign::Negative;
constexpr Sign kPlus = Sign::Positive;

// Edge k of the hexagon goes from corner k to corner k + 1 (mod 6).
constexpr int kCorners = 6;
constexpr std::array<SpecialMode, kCorners + 1> kSpecialModes = {{
    {"real neutral", {Stratum::Page, 3}, {0, kMinus, Sign::Zero}, {0, 1}},
    {"linear degenerate", {Stratum::Page, 2}, {1, kMinus, kPlus}, {-kHalfRoot3, 0.5}},
    {"linear balanced", {Stratum::Page, 1}, {kInfinity, Sign::Zero, kPlus}, {-kHalfRoot3, -0.5}},
    {"complex neutral", {Stratum::Page, 0}, {0, kPlus, Sign::Zero}, {0, -1}},
    {"planar balanced", {Stratum::Page, 5}, {kInfinity, Sign::Zero, kMinus}, {kHalfRoot3, -0.5}},
    {"planar degenerate", {Stratum::Page, 4}, {1, kMinus, kMinus}, {kHalfRoot3, 0.5}},
    {"triple degenerate", {Stratum::Spine, 0}, {kNaN, Sign::Zero, Sign::Zero}, {0, 0}},
}};

bool is_same(const Mode& a, const Mode& b) {
  return a.sign_p == b.sign_p && a.sign_q == b.sign_q &&
         (a.mu == b.mu || (std::isnan(a.mu) && std::isnan(b.mu)));
}

// Of a place on an edge: the two barycentric coordinates of its ends, up to a common factor.
struct OnEdge {
  int edge;
  double first, second;
};

// Modes with q > 0 and p, D not 0 lie on edges 0, 1, 2; those with q < 0 on the mirror images.
OnEdge place_on_edge(const Mode& m) {
  OnEdge on = {0, 1 - m.mu, m.mu};
  if (m.sign_p == kMinus && m.mu > 1) on = {1, 1 / m.mu, 1 - 1 / m.mu};
  // mu / (1 + mu) and 1 / (1 + mu), for large mu with numerator and denominator divided by mu
  if (m.sign_p == kPlus) {
    const double from_neutral = m.mu <= 1 ? m.mu / (1 + m.mu) : 1 / (1 + 1 / m.mu);
    on = {2, from_neutral, 1 / (1 + m.mu)};
  }
  if (m.sign_q == kMinus) on = {5 - on.edge, on.second, on.first};
  return on;
}

double mu_on_edge(OnEdge on) {
  if (on.edge >= 3) on = {5 - on.edge, on.second, on.first};
  const double sum = on.first + on.second;
  const double below_one = std::nextafter(1.0, 0.0);
  const double above_one = std::nextafter(1.0, 2.0);
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = std::numeric_limits<double>::max();
  if (on.edge == 0) return std::clamp(on.second / sum, least, below_one);
  if (on.edge == 1) return std::clamp(sum / on.first, above_one, greatest);
  return std::clamp(on.first / on.second, least, greatest);
}

double determinant(const Point2& a, const Point2& b) { return a[0] * b[1] - a[1] * b[0]; }

// The edge that the ray from the centre meets. On a corner the other coordinate is exactly 0.
OnEdge edge_met(const Point2& x) {
  OnEdge best = {0, -kInfinity, -kInfinity};
  for (int k = 0; k < kCorners; ++k) {
    const double first = determinant(x, kSpecialModes[(k + 1) % kCorners].hexagon);
    const double second = determinant(kSpecialModes[k].hexagon, x);
    if (std::min(first, second) > std::min(best.first, best.second)) best = {k, first, second};
  }
  return best;
}

}  // namespace

std::span<const SpecialMode, 7> special_modes() { return kSpecialModes; }

std::array<double, 2> hexagon_approx(const Mode& mode) {
  for (const SpecialMode& special : kSpecialModes) {
    if (is_same(special.mode, mode)) return special.hexagon;
  }
  const OnEdge on = place_on_edge(mode);
  const Point2& a = kSpecialModes[on.edge].hexagon;
  const Point2& b = kSpecialModes[(on.edge + 1) % kCorners].hexagon;
  return {on.first * a[0] + on.second * b[0], on.first * a[1] + on.second * b[1]};
}

std::optional<Mode> mode_on_hexagon(const std::array<double, 2>& hexagon) {
  if (!std::isfinite(hexagon[0]) || !std::isfinite(hexagon[1])) return std::nullopt;
  if (hexagon[0] == 0 && hexagon[1] == 0) return kSpecialModes[kCorners].mode;
  int exponent = 0;  // to size one
  std::frexp(std::fmax(std::fabs(hexagon[0]), std::fabs(hexagon[1])), &exponent);
  const OnEdge on =
      edge_met({std::ldexp(hexagon[0], -exponent), std::ldexp(hexagon[1], -exponent)});
  if (on.second == 0) return kSpecialModes[on.edge].mode;
  if (on.first == 0) return kSpecialModes[(on.edge + 1) % kCorners].mode;
  const bool inner = on.edge == 2 || on.edge == 3;
  return Mode{mu_on_edge(on), inner ? kPlus : kMinus, on.edge < 3 ? kPlus : kMinus};
}

Point eigenvalue_space_approx(const Tensor<double>& t) {
  if (std::all_of(t.begin(), t.end(), [](double x) { return x == 0; })) return {kNaN, kNaN, kNaN};
  const UnitDeviator deviator = unit_deviator(t);
  const double unit_magnitude = magnitude_approx(deviator.a);
  if (unit_magnitude == 0) return {0, 0, t[0] > 0 ? 1.0 : -1.0};
  // 1 - eta^2 = (|A| / |T|)^2, without cancellation; both norms at size one.
  int exponent = std::numeric_limits<int>::min();
  for (const double x : t) {
    int e = 0;
    std::frexp(x, &e);
    if (x != 0) exponent = std::max(exponent, e);
  }
  Tensor<double> unit = t;
  for (double& x : unit) x = std::ldexp(x, -exponent);
  const double ratio =
      std::ldexp(unit_magnitude / magnitude_approx(unit), deviator.exponent - exponent);
  const double eta = isotropicity_approx(t);
  const double radius = ratio * (ratio / (1 + std::fabs(eta)));
  const Point2 hexagon = hexagon_approx(mode(t));
  return {radius * hexagon[0], radius * hexagon[1], eta};
}

std::optional<ModeAndIsotropicity> from_eigenvalue_space(const Point& place) {
  if (!(std::fabs(place[2]) <= 1)) return std::nullopt;
  const std::optional<Mode> m = mode_on_hexagon({place[0], place[1]});
  if (!m) return std::nullopt;
  return ModeAndIsotropicity{*m, place[2]};
}

// 27 q^2 = 4 |p|^3 mu^2, so D = 4 |p|^3 (s - mu^2) = 27 q^2 (s / mu^2 - 1) with s = -sign p.
Eigenvalues deviator_eigenvalues_of_mode(const Mode& mode) {
  const auto scaled_real = [](double x) {
    ScaledReal r;
    r.mantissa = std::frexp(x, &r.exponent);
    return r;
  };
  const auto sign_of = [](double x) { return x > 0 ? kPlus : x < 0 ? kMinus : Sign::Zero; };
  double p = static_cast<double>(mode.sign_p);
  double q = static_cast<double>(mode.sign_q);
  double d = 0;
  if (mode.mu <= 1) {
    q *= mode.mu / (3 * kHalfRoot3);
    d = p < 0 ? 4 * (1 - mode.mu) * (1 + mode.mu) : -4 * (1 + mode.mu * mode.mu);
  } else if (mode.mu > 1) {
    const double inverse = 1 / mode.mu;
    d = p < 0 ? -27 * ((mode.mu - 1) * inverse) * (1 + inverse) : -27 * (1 + p * inverse * inverse);
    p *= std::pow(3 * kHalfRoot3 * inverse, 2.0 / 3.0);
  }
  Invariants i;
  i.p = scaled_real(p);
  i.q = scaled_real(q);
  i.discriminant = scaled_real(d);
  i.sign_p = sign_of(p);
  i.sign_q = sign_of(q);
  i.sign_discriminant = sign_of(d);
  return deviator_eigenvalues(i);
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_function.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace triplex {
namespace {

double trace(const Tensor<double>& a) { return a[0] + a[4] + a[8]; }

/// Q(a, b, c): the polar form with Q(a, a, a) = Q(a).
double polar_q(const Tensor<double>& a, const Tensor<double>& b, const Tensor<double>& c) {
  return double_dot(mixed_cofactor(a, b), c);
}

constexpr double kSlack = 1 + 0x1p-20;  // covers the roundings of a bound's own evaluation

/// Grows to hold what it is given.
class Hull {
 public:
  /// What is no number makes both ends infinite.
  void add(double x) {
    if (!(x >= low_)) low_ = std::isnan(x) ? -std::numeric_limits<double>::infinity() : x;
    if (!(x <= high_)) high_ = std::isnan(x) ? std::numeric_limits<double>::infinity() : x;
  }
  Bounds widened(double error) const { return {low_ - error, high_ + error}; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

SurfaceFunction::SurfaceFunction(const FeatureTable& table, Feature feature, int scale) {
  const FeatureRow& row = table.row(feature);
  const auto as_double = [](Sign s) { return static_cast<double>(static_cast<int>(s)); };
  if (row.kind == FeatureKind::LevelSet) {
    const double value = row.level.value;
    switch (row.level.kind) {
      case LevelSet::Kind::Magnitude:
        kind_ = Kind::Magnitude;
        square_ = std::ldexp(value, scale) * std::ldexp(value, scale);
        break;
      case LevelSet::Kind::Isotropicity:
        kind_ = Kind::Isotropicity;
        eta_ = 3 * value * value;
        break;
      case LevelSet::Kind::Traceless:
        kind_ = Kind::Traceless;
        break;
    }
    return;
  }
  const Sheet& sheet = table.sheet(feature);
  switch (sheet.kind) {
    case Sheet::Kind::Balanced:  // the angle of (p, q) grows as p falls where q > 0
      kind_ = Kind::Balanced;
      orientation_ = feature == Feature::BalancedLinear ? -1 : 1;
      break;
    case Sheet::Kind::Neutral:
      kind_ = Kind::Neutral;
      orientation_ = feature == Feature::NeutralReal ? -1 : 1;
      break;
    case Sheet::Kind::Curved:
      kind_ = Kind::Curved;
      orientation_ = as_double(row.sign_p);
      side_ = as_double(sheet.sign_q);
      p_factor_ = sheet.map.p_factor;
      q_factor_ = sheet.map.q_factor;
      break;
  }
}

double SurfaceFunction::height(double P) const {
  const double v = std::sqrt(std::fmax(0, -P) / 6);
  return side_ * 12 * v * v * v;
}

/// f(a, b), its polar form, of the level sets of second degree.
double SurfaceFunction::gram_coefficient(const Tensor<double>& a, const Tensor<double>& b) const {
  const double product = double_dot(a, b);
  return kind_ == Kind::Magnitude ? product - square_ : eta_ * product - trace(a) * trace(b);
}

double SurfaceFunction::value(const Tensor<double>& a) const {
  switch (kind_) {
    case Kind::Balanced:
      return minus_trace_of_product(a, a);
    case Kind::Neutral:
      return polar_q(a, a, a);
    case Kind::Curved:
      return q_factor_ * polar_q(a, a, a) - height(p_factor_ * minus_trace_of_product(a, a));
    case Kind::Magnitude:
    case Kind::Isotropicity:
      return gram_coefficient(a, a);
    case Kind::Traceless:
      return -trace(a);
  }
  return 0;
}

double SurfaceFunction::derivative(const Tensor<double>& a, const Tensor<double>& along) const {
  switch (kind_) {
    case Kind::Balanced:
      return 2 * minus_trace_of_product(a, along);
    case Kind::Neutral:
      return 3 * polar_q(a, a, along);
    case Kind::Curved: {
      const double v = std::sqrt(std::fmax(0, -p_factor_ * minus_trace_of_product(a, a)) / 6);
      return 3 * q_factor_ * polar_q(a, a, along) +
             6 * side_ * v * p_factor_ * minus_trace_of_product(a, along);
    }
    case Kind::Magnitude:
      return 2 * double_dot(a, along);
    case Kind::Isotropicity:
      return 2 * (eta_ * double_dot(a, along) - trace(a) * trace(along));
    case Kind::Traceless:
      return -trace(along);
  }
  return 0;
}

/// On the hull P runs in [low, high]. With P0 between, h(P) = h(P0) + h'(P0) (P - P0) + s r, and as
/// s h is convex, 0 <= r <= the larger of its values at the two ends. What is left of f is a cubic
/// with coefficients Q_ijk - h(P0) - h'(P0) (P_ijk - P0), P raised to degree three.
template <int N>
double SurfaceFunction::largest_curved(const Forms<double, N>& f, const FormBounds& bounds) const {
  const auto [least, most] = std::ranges::minmax(f.p);
  const double p_error =
      p_factor_ * p_factor_ == 1
          ? bounds.p_error
          : std::fabs(p_factor_) * (bounds.p_error + gamma(1) * bounds.p_magnitude);
  double low = p_factor_ * least, high = p_factor_ * most;
  if (low > high) std::swap(low, high);
  low -= p_error, high += p_error;
  const double middle = low + (high - low) / 2;
  const double at_middle = height(middle);
  const double slope = -3 * side_ * std::sqrt(std::fmax(0, -middle) / 6);
  const auto rest = [&](double P) {
    return std::fabs(height(P) - at_middle - slope * (P - middle));
  };
  Hull coefficients;
  for (const auto& [i, j, k] : triples<N>()) {
    const double P = p_factor_ * ((f.P(i, j) + f.P(j, k) + f.P(i, k)) / 3);
    coefficients.add(q_factor_ * f.Q(i, j, k) - at_middle - slope * (P - middle));
  }
  const double q_size = std::fabs(q_factor_) * bounds.q_magnitude;
  const double p_size = std::fmax(std::fabs(low), std::fabs(high));
  const double h_size = std::fmax(std::fabs(height(low)), std::fabs(height(high)));
  // At most: 4 roundings of P, 5 of h, 2 of Q, and 3 to add them up.
  const double error = std::fabs(q_factor_) * bounds.q_error + std::fabs(slope) * p_error +
                       gamma(16) * (q_size + 2 * h_size + 2 * std::fabs(slope) * p_size);
  const double remainder = std::fmax(rest(low), rest(high));
  const double below = coefficients.low() - (side_ > 0 ? remainder : 0);
  const double above = coefficients.high() + (side_ > 0 ? 0 : remainder);
  return (std::fmax(std::fabs(below), std::fabs(above)) + 2 * error) * kSlack;
}

template <int N>
double SurfaceFunction::largest_value(const std::array<Tensor<double>, N>& hull,
                                      const EntryBounds& entries) const {
  const FormBounds bounds(entries);
  const double m = entries.magnitude, e = entries.error;
  double largest = 0;
  switch (kind_) {
    case Kind::Balanced:
      for (const auto& [i, j] : pairs<N>())
        largest = std::fmax(largest, std::fabs(minus_trace_of_product(hull[i], hull[j])));
      return (largest + bounds.p_error) * kSlack;
    case Kind::Neutral: {
      const auto f = forms_of<double, N>(hull);
      for (const double q : f.q) largest = std::fmax(largest, std::fabs(q));
      return (largest + bounds.q_error) * kSlack;
    }
    case Kind::Curved:
      return largest_curved(forms_of<double, N>(hull), bounds);
    case Kind::Magnitude:
    case Kind::Isotropicity: {
      for (const auto& [i, j] : pairs<N>())
        largest = std::fmax(largest, std::fabs(gram_coefficient(hull[i], hull[j])));
      // A product of sums of nine, or of traces, has the error of P; the number beside it and the
      // difference take five roundings more; 3 eta^2 < 3.
      const double numbers = kind_ == Kind::Magnitude ? square_ : 36 * m * m;
      return (largest + 4 * bounds.p_error + gamma(5) * (numbers + 9 * m * m)) * kSlack;
    }
    case Kind::Traceless:
      for (const Tensor<double>& a : hull) largest = std::fmax(largest, std::fabs(trace(a)));
      return (largest + 3 * e + gamma(2) * 3 * m) * kSlack;
  }
  return largest;
}

/// f' = 3 Q(a, a, along) + 6 s v P(a, along), affine in v: bounds at both ends of v's range.
Bounds SurfaceFunction::curved_derivative_on(std::span<const Tensor<double>> hull,
                                             const Tensor<double>& along,
                                             const FormBounds& bounds) const {
  Hull range_of_p;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i; j < hull.size(); ++j)
      range_of_p.add(p_factor_ * minus_trace_of_product(hull[i], hull[j]));
  const double p_error =
      std::fabs(p_factor_) * (bounds.p_error + gamma(1) * bounds.p_magnitude) * kSlack;
  const auto v_at = [](double P) { return std::sqrt(std::fmax(0, -P) / 6); };
  const std::array<double, 2> v = {v_at(range_of_p.high() + p_error) * (1 - gamma(4)),
                                   v_at(range_of_p.low() - p_error) * (1 + gamma(4))};
  std::array<double, 8> p_along{};
  for (std::size_t i = 0; i < hull.size(); ++i)
    p_along[i] = p_factor_ * minus_trace_of_product(hull[i], along);
  Hull range;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i; j < hull.size(); ++j) {
      const double q = q_factor_ * polar_q(hull[i], hull[j], along);
      for (const double end : v) range.add(3 * q + 3 * side_ * end * (p_along[i] + p_along[j]));
    }
  const double q_size = std::fabs(q_factor_) * bounds.q_magnitude;
  const double p_size = std::fabs(p_factor_) * bounds.p_magnitude;
  return range.widened((3 * std::fabs(q_factor_) * bounds.q_error + 6 * v[1] * p_error +
                        gamma(8) * (3 * q_size + 6 * v[1] * p_size)) *
                       kSlack);
}

std::vector<std::array<double, 3>> SurfaceFunction::derivatives_approx(
    std::span<const Tensor<double>> hull, std::span<const Tensor<double>> directions) const {
  std::vector<std::array<double, 3>> vectors;
  const auto add = [&](const auto& derivative) {
    std::array<double, 3> v{};
    for (std::size_t k = 0; k < directions.size(); ++k) v[k] = derivative(directions[k]);
    vectors.push_back(v);
  };
  if (kind_ != Kind::Neutral && kind_ != Kind::Curved) {  // linear
    for (const Tensor<double>& a : hull)
      add([&](const Tensor<double>& along) { return derivative(a, along); });
    return vectors;
  }
  Hull range_of_p;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i; j < hull.size(); ++j)
      range_of_p.add(p_factor_ * minus_trace_of_product(hull[i], hull[j]));
  const auto v_at = [](double P) { return std::sqrt(std::fmax(0, -P) / 6); };
  const std::array<double, 2> v = {v_at(range_of_p.high()), v_at(range_of_p.low())};
  const std::size_t ends = kind_ == Kind::Curved ? 2 : 1;
  const double factor = kind_ == Kind::Curved ? 3 * side_ * p_factor_ : 0;
  for (std::size_t end = 0; end < ends; ++end)
    for (std::size_t i = 0; i < hull.size(); ++i)
      for (std::size_t j = i; j < hull.size(); ++j)
        add([&](const Tensor<double>& along) {
          const double q = 3 * q_factor_ * polar_q(hull[i], hull[j], along);
          return factor == 0 ? q
                             : q + factor * v[end] *
                                       (minus_trace_of_product(hull[i], along) +
                                        minus_trace_of_product(hull[j], along));
        });
  return vectors;
}

Bounds SurfaceFunction::derivative_on(std::span<const Tensor<double>> hull,
                                      const Tensor<double>& along,
                                      const EntryBounds& entries) const {
  const FormBounds bounds(entries);
  Hull range;
  switch (kind_) {
    case Kind::Balanced:
      for (const Tensor<double>& a : hull) range.add(2 * minus_trace_of_product(a, along));
      return range.widened(2 * bounds.p_error * kSlack);
    case Kind::Neutral:
      for (std::size_t i = 0; i < hull.size(); ++i)
        for (std::size_t j = i; j < hull.size(); ++j)
          range.add(3 * polar_q(hull[i], hull[j], along));
      return range.widened(3 * (bounds.q_error + gamma(1) * bounds.q_magnitude) * kSlack);
    case Kind::Curved:
      return curved_derivative_on(hull, along, bounds);
    case Kind::Magnitude:
    case Kind::Isotropicity:
      for (const Tensor<double>& a : hull) range.add(derivative(a, along));
      return range.widened((8 * bounds.p_error + gamma(5) * 8 * bounds.p_magnitude) * kSlack);
    case Kind::Traceless:
      range.add(-trace(along));
      return range.widened((3 * entries.error + gamma(2) * 3 * entries.magnitude) * kSlack);
  }
  return {};
}

template double SurfaceFunction::largest_value<1>(const std::array<Tensor<double>, 1>&,
                                                  const EntryBounds&) const;
template double SurfaceFunction::largest_value<2>(const std::array<Tensor<double>, 2>&,
                                                  const EntryBounds&) const;
template double SurfaceFunction::largest_value<3>(const std::array<Tensor<double>, 3>&,
                                                  const EntryBounds&) const;

}  // namespace triplex

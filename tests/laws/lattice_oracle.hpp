// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "triplex/arithmetic/filter.hpp"
#include "triplex/arithmetic/infinitesimal.hpp"
#include "triplex/bernstein/forms.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex::test {

/// The sector that the signs of p, q and D name: D does not count for p > 0.
inline int sector_of_signs(Sign p, Sign q, Sign d) {
  const bool linear = q == Sign::Positive;
  if (p == Sign::Positive) return linear ? 0 : 5;
  if (d == Sign::Positive) return linear ? 2 : 3;
  return linear ? 1 : 4;
}

/// The sectors of the perturbed field at the points of a regular lattice in a tet, each with its
/// exact sign: doubles where their error bound allows, else exact arithmetic.
class LatticeOracle {
 public:
  static constexpr int kSteps = 8;  // 165 points

  LatticeOracle(const RefinableField& field, const std::array<VertexId, 4>& vertices)
      : field_(field), vertices_(vertices) {
    EntryBounds entries;
    for (std::size_t i = 0; i < 4; ++i) {
      corners_[i] = field.approximate(vertices[i]).a;
      entries.include(field.approximate(vertices[i]).bounds);
    }
    usable_ = entries.usable();
    // A point's entries are sums of four products with weights n/8 that add up to one: at most four
    // roundings each, and the errors of the corners pass through with weight one.
    entries.error += gamma(4) * entries.magnitude;
    entries.magnitude *= 1 + 0x1p-40;
    bounds_ = FormBounds(entries);
  }

  /// The sector at sum n_i v_i / 8; nothing if the perturbation leaves it open.
  std::optional<int> sector(const std::array<int, 4>& n) {
    if (usable_) {
      if (const auto found = sector_by_doubles(n)) return found;
    }
    ++exact_decisions_;
    return sector_exactly(n);
  }
  std::size_t exact_decisions() const { return exact_decisions_; }

  /// Calls visit(n) for all lattice points.
  template <class Visit>
  static void for_all(const Visit& visit) {
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j)
        for (int k = 0; i + j + k <= kSteps; ++k)
          visit(std::array<int, 4>{i, j, k, kSteps - i - j - k});
  }

 private:
  std::optional<int> sector_by_doubles(const std::array<int, 4>& n) const {
    Tensor<double> a{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 9; ++k) a[k] += n[i] / double(kSteps) * corners_[i][k];
    const auto f = forms_of<double, 1>({a});
    const double P = std::fabs(f.p[0]), Q = std::fabs(f.q[0]);
    const double dp = bounds_.p_error, dq = bounds_.q_error;
    if (!(P > dp && Q > dq)) return std::nullopt;
    const auto sign = [](double x) { return x > 0 ? Sign::Positive : Sign::Negative; };
    if (f.p[0] > 0) return sector_of_signs(Sign::Positive, sign(f.q[0]), Sign::Zero);
    // -4 D = 2 P^3 + 3 Q^2 with P < 0: the two terms at the ends of their ranges, with slack for
    // the roundings here.
    constexpr double kSlack = 1 + 0x1p-40;
    const double cube_lo = 2 * (P - dp) * (P - dp) * (P - dp);
    const double cube_hi = 2 * (P + dp) * (P + dp) * (P + dp);
    const double square_lo = 3 * (Q - dq) * (Q - dq), square_hi = 3 * (Q + dq) * (Q + dq);
    if (cube_lo > kSlack * square_hi)
      return sector_of_signs(Sign::Negative, sign(f.q[0]), Sign::Positive);
    if (square_lo > kSlack * cube_hi)
      return sector_of_signs(Sign::Negative, sign(f.q[0]), Sign::Negative);
    return std::nullopt;
  }

  template <class NT>
  static std::optional<int> sector_in_ring(const Tensor<NT>& a) {
    const auto f = forms_of<NT, 1>({a});
    const NT &P = f.p[0], &Q = f.q[0];
    const Sign p = sign(P), q = sign(Q);
    if (p == Sign::Zero || q == Sign::Zero) return std::nullopt;
    const Sign d = p == Sign::Positive ? Sign::Negative : -sign(NT(2) * P * P * P + NT(3) * Q * Q);
    if (d == Sign::Zero) return std::nullopt;
    return sector_of_signs(p, q, d);
  }
  std::optional<int> sector_exactly(const std::array<int, 4>& n) {
    if (!exact_) {
      exact_.emplace();
      for (std::size_t i = 0; i < 4; ++i) (*exact_)[i] = field_.exact(vertices_[i]);
    }
    Tensor<Exact> a;
    for (std::size_t k = 0; k < 9; ++k) {
      a[k] = Exact(0);
      for (std::size_t i = 0; i < 4; ++i) a[k] = a[k] + Exact(n[i]) * (*exact_)[i][k];
    }
    if (const auto found = sector_in_ring(a)) return found;
    Tensor<Exact> direction;
    for (std::size_t k = 0; k < 9; ++k) direction[k] = Exact(kSteps * kPerturbation[k]);
    direction = triple_deviator(direction);
    Tensor<Series<7>> perturbed;
    for (std::size_t k = 0; k < 9; ++k) perturbed[k] = Series<7>(a[k], direction[k]);
    return sector_in_ring(perturbed);
  }

  const RefinableField& field_;
  std::array<VertexId, 4> vertices_;
  std::array<Tensor<double>, 4> corners_;
  FormBounds bounds_;
  bool usable_ = false;
  std::optional<std::array<Tensor<Exact>, 4>> exact_;
  std::size_t exact_decisions_ = 0;
};

}  // namespace triplex::test

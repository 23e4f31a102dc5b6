// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "error_bounds.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/certify/node.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {
namespace {

using Weights = std::array<std::int64_t, 4>;

Interval interval(const Exact& x) {
  const auto [lo, hi] = CGAL::to_interval(x);
  return {lo, hi};
}

/// The fraction of that denominator nearest to the node, if all its coordinates are in the box.
std::optional<Weights> nearest_fraction(const IsolatedNode& node, std::int64_t denominator) {
  const auto d = static_cast<double>(denominator);
  Weights w{};
  std::int64_t rest = denominator;
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = std::nearbyint(node.box[k].middle() * d);
    if (!(n >= 0 && n <= d)) return std::nullopt;
    w[k + 1] = static_cast<std::int64_t>(n);
    rest -= w[k + 1];
  }
  w[0] = rest;
  if (rest < 0) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) {  // n / d within a rounding of the box, both ways
    const double x = static_cast<double>(w[k + 1]) / d, slack = 0x1p-50;
    if (x < node.box[k].lo - slack || x > node.box[k].hi + slack) return std::nullopt;
  }
  return w;
}

/// The denominators that are tried.
std::vector<std::int64_t> denominators() {
  constexpr std::int64_t kAll = 64;
  constexpr int kPowers = 24;
  std::vector<std::int64_t> d(kAll);
  std::iota(d.begin(), d.end(), std::int64_t{1});
  for (int k = 7; k <= kPowers; ++k) d.push_back(std::int64_t{1} << k);
  return d;
}

/// Whether a node at these weights lies in the domain, where there is one only.
[[gnu::noinline]] bool is_in_domain(const std::array<Exact, 4>& w, const Tensor<Exact>& deviator,
                                    const IsolatedNode& node) {
  const Forms<Exact, 1> f = forms_of<Exact, 1>({deviator});
  const IntervalRounding protect;
  const Interval sum = interval(w[0] + w[1] + w[2] + w[3]);
  const auto covers = [](const Range& domain, const Interval& x) {
    return domain.lo <= x.inf() && x.sup() <= domain.hi;
  };
  for (std::size_t k = 0; k < 3; ++k)
    if (!covers(node.domain[k], interval(w[k + 1]) / sum)) return false;
  // The tensor is `sum` times the interpolated one, and so is the eigenvalue Q / (2 P).
  return covers(node.domain[3], interval(f.q[0]) / (2 * interval(f.p[0])) / sum);
}

}  // namespace

// With P != 0 and l = Q / (2 P) the matrix 2 P A' - Q I is a multiple of A' - l I; its 2 x 2 minors
// vanish exactly if that has rank one (it is not zero, for A' has no trace). Source:
// proofs/node.md.
bool is_node(const Tensor<Exact>& a) {
  const Forms<Exact, 1> f = forms_of<Exact, 1>({a});
  if (f.p[0].is_zero()) return false;
  Tensor<Exact> m;
  for (std::size_t k = 0; k < 9; ++k) {
    m[k] = Exact(2) * f.p[0] * a[k];
    if (k % 4 == 0) m[k] = m[k] - f.q[0];
  }
  return std::ranges::all_of(mixed_cofactor(m, m), [](const Exact& x) { return x.is_zero(); });
}

bool is_node(const RefinableField& field, VertexId v) {
  const Simplex<1> vertex(field, {v});
  if (vertex.filter_usable()) {
    const double p = vertex.approximate().p[0], q = vertex.approximate().q[0];
    const double d = 2 * p * p * p + 3 * q * q;  // a multiple of D, zero at a node
    if (std::fabs(d) > discriminant_coefficient_error(vertex.bounds())) return false;
  }
  return is_node(field.exact(v));
}

std::array<std::int64_t, 4> exact_weights(const RefinableField& field,
                                          const std::array<VertexId, 4>& vertices,
                                          const IsolatedNode& node) {
  static const std::vector<std::int64_t> kDenominators = denominators();
  std::optional<std::array<Tensor<Exact>, 4>> tensors;
  for (const std::int64_t d : kDenominators) {
    const auto w = nearest_fraction(node, d);
    if (!w) continue;
    if (!tensors) tensors = Simplex<4>(field, vertices).exact_tensors();
    Tensor<Exact> sum;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t k = 0; k < 9; ++k)
        sum[k] = sum[k] + Exact(static_cast<double>((*w)[i])) * (*tensors)[i][k];
    std::array<Exact, 4> exact;
    for (std::size_t i = 0; i < 4; ++i) exact[i] = Exact(static_cast<double>((*w)[i]));
    if (is_node(sum) && is_in_domain(exact, sum, node)) return *w;
  }
  return {};
}

bool is_at(const RefinableField& field, const std::array<VertexId, 4>& vertices,
           const IsolatedNode& node, VertexId v) {
  const auto is_corner = [&](VertexId corner) { return std::ranges::count(vertices, corner) > 0; };
  if (!std::ranges::all_of(field.corners(v), is_corner)) return false;
  Tensor<Exact> a = field.exact(v);
  // The domain is that of tensors scaled as the doubles.
  const Exact scale(std::ldexp(1.0, field.scale_exponent()));
  for (Exact& x : a) x = x * scale;
  return is_in_domain(field.exact_weights(v, vertices), a, node);
}

}  // namespace triplex

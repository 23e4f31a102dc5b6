// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that no halving of edges reaches: nodes known by an enclosure, and points with rational
// weights.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tensor_bounds.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/field/refinable_field.hpp"

namespace triplex {

/// Off the centre by `radius` in each weight and by 2^-50 as the sum of the weights is one up to
/// rounding: as much times the largest entry, four times. Else as in `add_midpoint`.
ApproximateTensor RefinableField::combine_enclosed(const Enclosed& e, bool with_trace) const {
  ApproximateTensor r{};
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const ApproximateTensor corner =
        with_trace ? combine_tensor(e.vertices[i]) : approximations_[index(e.vertices[i])];
    for (std::size_t k = 0; k < 9; ++k) r.a[k] += e.weights[i] * corner.a[k];
    largest = std::fmax(largest, corner.bounds.magnitude);
    r.bounds.error =
        std::fmax(r.bounds.error, corner.bounds.error + gamma(5) * corner.bounds.magnitude);
  }
  r.bounds.error += 4 * (e.radius + 0x1p-50) * largest * (1 + 0x1p-20);
  r.bounds.magnitude = largest_entry(r.a);
  return r;
}

/// Lower ends of enclosures one rounding wide, divided: off by three times 2^-52 at most.
[[gnu::noinline]] std::array<double, 4> RefinableField::Rational::weights_approx() const {
  const IntervalRounding protect;
  const double whole = CGAL::to_interval(denominator).first;
  std::array<double, 4> w;
  for (std::size_t i = 0; i < 4; ++i) w[i] = CGAL::to_interval(numerators[i]).first / whole;
  return w;
}

/// The weights are off by kWeightError of themselves at most and sum to one; else as in
/// `add_midpoint`.
ApproximateTensor RefinableField::combine_rational(const Rational& r, bool with_trace) const {
  ApproximateTensor t{};
  const auto weights = r.weights_approx();
  for (std::size_t i = 0; i < 4; ++i) {
    if (r.numerators[i].is_zero()) continue;
    const ApproximateTensor corner =
        with_trace ? combine_tensor(r.vertices[i]) : approximations_[index(r.vertices[i])];
    for (std::size_t k = 0; k < 9; ++k) t.a[k] += weights[i] * corner.a[k];
    t.bounds.error = std::fmax(t.bounds.error, corner.bounds.error + (gamma(5) + 2 * kWeightError) *
                                                                         corner.bounds.magnitude);
  }
  t.bounds.magnitude = largest_entry(t.a);
  return t;
}

VertexId RefinableField::add_rational(const std::array<VertexId, 4>& tet,
                                      const std::array<Exact, 4>& weights) {
  Rational r{tet, weights, Exact(0), 0};
  for (const Exact& n : weights) r.denominator = r.denominator + n;
  return add(std::move(r));
}

/// Brings the denominator into [1, 2), by a power of two.
VertexId RefinableField::add(Rational r) {
  Exact factor(std::ldexp(1.0, -std::ilogb(CGAL::to_double(r.denominator))));
  if (sign(r.denominator * factor - Exact(1)) == Sign::Negative) factor = factor * Exact(2);
  r.denominator = r.denominator * factor;
  for (Exact& n : r.numerators) n = n * factor;
  const auto v = static_cast<VertexId>(approximations_.size());
  if (rational_.empty()) rational_from_ = index(v);
  midpoints_.emplace_back();
  approximations_.push_back(combine_rational(r, false));
  if (!tensors_.empty()) tensors_.push_back(combine_rational(r, true));
  rational_.emplace(v, std::move(r));
  return v;
}

std::array<Exact, 4> RefinableField::exact_weights(VertexId v,
                                                   const std::array<VertexId, 4>& tet) const {
  std::array<Exact, 4> w;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!is_rational(v)) {
      const Combination c = combination(v);
      for (std::size_t k = 0; k < 4; ++k)
        if (c.numerators[k] != 0 && c.vertices[k] == tet[i])
          w[i] = exact_dyadic(c.numerators[k], c.depth);
      continue;
    }
    const Rational& r = rational_.at(v);
    for (std::size_t k = 0; k < 4; ++k)
      if (r.vertices[k] == tet[i]) w[i] = w[i] + r.numerators[k];
  }
  return w;
}

Exact RefinableField::denominator(VertexId v) const {
  return is_rational(v) ? rational_.at(v).denominator : Exact(1);
}

RefinableField::Rational RefinableField::rational(VertexId v) const {
  if (is_rational(v)) return rational_.at(v);
  const Combination c = combination(v);
  Rational r{c.vertices, {}, Exact(1), c.depth};
  for (std::size_t i = 0; i < 4; ++i)
    if (c.numerators[i] != 0) r.numerators[i] = exact_dyadic(c.numerators[i], c.depth);
  return r;
}

/// (1 - at) n_a / N_a + at n_b / N_b, over N_a N_b or over their common value: the denominators are
/// those of few points.
std::optional<VertexId> RefinableField::add_rational_between(VertexId a, VertexId b, double at) {
  Rational middle = rational(a);
  middle.depth = std::max(middle.depth, rational(b).depth) + dyadic(at).depth;
  if (middle.depth > kMaxDepth) return std::nullopt;
  const Exact own = denominator(a), other = denominator(b);
  const bool same = own == other;
  for (Exact& n : middle.numerators) n = n * Exact(1 - at) * (same ? Exact(1) : other);
  middle.denominator = same ? own : own * other;
  for (const VertexId corner : corners(b)) {
    auto slot = std::ranges::find(middle.vertices, corner);
    if (slot == middle.vertices.end()) {
      const auto unused = std::ranges::find_if(middle.numerators, &Exact::is_zero);
      slot = middle.vertices.begin() + (unused - middle.numerators.begin());
      *slot = corner;
    }
    Exact& sum = middle.numerators[static_cast<std::size_t>(slot - middle.vertices.begin())];
    const Exact n = exact_weights(b, {corner, corner, corner, corner})[0];
    sum = sum + n * Exact(at) * (same ? Exact(1) : own);
  }
  return add(std::move(middle));
}

VertexId RefinableField::add_node(const std::array<VertexId, 4>& tet,
                                  const std::array<double, 4>& centre, double radius,
                                  const std::array<ExactRange, 4>& weights) {
  const auto v = static_cast<VertexId>(approximations_.size());
  Tensor<ExactRange>& tensor = node_tensors_[v];
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor<Exact> corner = exact(tet[i]);
    for (std::size_t k = 0; k < 9; ++k) tensor[k] = tensor[k] + weights[i] * corner[k];
  }
  Enclosed e{.vertices = tet, .weights = centre, .radius = radius};
  e.node = v;
  return add(e);
}

VertexId RefinableField::add_node(const std::array<VertexId, 4>& tet,
                                  const std::array<double, 4>& centre, double radius) {
  std::array<ExactRange, 4> weights;
  for (std::size_t i = 0; i < 4; ++i)
    weights[i] = ExactRange(centre[i]) + ExactRange(Exact(-radius), Exact(radius));
  return add_node(tet, centre, radius, weights);
}

Tensor<ExactRange> RefinableField::enclosure(VertexId v) const {
  Tensor<ExactRange> sum;
  if (!is_enclosed(v)) {
    const Tensor<Exact> point = exact(v);
    for (std::size_t k = 0; k < 9; ++k) sum[k] = point[k];
    return sum;
  }
  const Enclosed& e = enclosed_.at(v);
  const auto add_multiple = [&](WeightNumerator n, const auto& tensor) {
    if (n == 0) return;
    const Exact weight = exact_dyadic(n, e.depth);
    for (std::size_t k = 0; k < 9; ++k) sum[k] = sum[k] + ExactRange(weight) * tensor[k];
  };
  add_multiple(e.of_node, node_tensors_.at(e.node));
  for (std::size_t i = 0; i < 4; ++i)
    if (e.of_vertices[i] != 0) add_multiple(e.of_vertices[i], exact(e.vertices[i]));
  return sum;
}

/// The mean of two weights, of which that of `b` may have been rounded, is rounded once: by 2^-53 +
/// 2^-54 in all at most.
std::optional<VertexId> RefinableField::add_enclosed_midpoint(VertexId a, VertexId b) {
  if (!is_enclosed(a)) std::swap(a, b);
  Enclosed middle = enclosed_.at(a);
  const bool both = is_enclosed(b);
  Enclosed other = both ? enclosed_.at(b) : Enclosed{.vertices = middle.vertices, .of_node = 0};
  if (!both) {
    if (is_rational(b)) return std::nullopt;
    const Combination c = combination(b);
    other.depth = c.depth;
    for (std::size_t i = 0; i < 4; ++i) {
      other.weights[i] = weight(b, middle.vertices[i]);
      for (std::size_t k = 0; k < 4; ++k)
        if (c.numerators[k] != 0 && c.vertices[k] == middle.vertices[i])
          other.of_vertices[i] = c.numerators[k];
    }
  } else if (other.node != middle.node) {
    throw std::logic_error("an edge between two nodes");
  }
  const int depth = std::max(middle.depth, other.depth) + 1;
  if (depth > kMaxEnclosedDepth) return std::nullopt;
  const auto mean = [&](WeightNumerator n, WeightNumerator m) {
    return (n << (depth - 1 - middle.depth)) + (m << (depth - 1 - other.depth));
  };
  double length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    length = std::fmax(length, std::fabs(middle.weights[i] - other.weights[i]));
    middle.weights[i] = (middle.weights[i] + other.weights[i]) / 2;
    middle.of_vertices[i] = mean(middle.of_vertices[i], other.of_vertices[i]);
  }
  middle.of_node = mean(middle.of_node, other.of_node);
  middle.depth = depth;
  middle.radius = (middle.radius + other.radius) / 2 * (1 + 0x1p-20) + 0x1p-52;
  constexpr double kLeastLength = 64;  // radii: what is shorter could not be certified anyway
  if (!(length > kLeastLength * middle.radius)) return std::nullopt;
  return add(middle);
}

VertexId RefinableField::add(const Enclosed& e) {
  const auto v = static_cast<VertexId>(approximations_.size());
  if (enclosed_.empty()) enclosed_from_ = index(v);
  midpoints_.emplace_back();
  approximations_.push_back(combine_enclosed(e, false));
  enclosed_.emplace(v, e);
  if (!tensors_.empty()) tensors_.push_back(combine_enclosed(e, true));
  return v;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/refinable_field.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "tensor_bounds.hpp"

#include "triplex/arithmetic/interval.hpp"

namespace triplex {
namespace {

/// The exponent that brings the largest entry of the field into [1/2, 1); 0 for a zero field.
int common_scale(const std::vector<Tensor<double>>& tensors) {
  double m = 0;
  for (const auto& t : tensors) m = std::max(m, largest_entry(t));
  int exponent = 0;
  if (m > 0) std::frexp(m, &exponent);
  return -exponent;
}

/// With A' the exact result and M its largest entry, t_xx - t_yy = (A'_xx - A'_yy) / 3 is below 2 M
/// / 3, and so is t_xx - t_zz: rounding them and their sum costs at most u (2/3 + 2/3 + 1) M and
/// second-order terms; off the diagonal u M. So the error is below gamma(3) M, whatever the trace
/// is, and below gamma(4) times the largest computed entry.
ApproximateTensor approximate_input(const Tensor<double>& tensor, int exponent) {
  Tensor<double> scaled;
  // A product with a power of two is rounded as ldexp rounds, and is no call.
  const bool is_normal = std::abs(exponent) <= 1000;
  const double factor = is_normal ? std::ldexp(1.0, exponent) : 1;
  for (int i = 0; i < 9; ++i)
    scaled[i] = is_normal ? factor * tensor[i] : std::ldexp(tensor[i], exponent);
  ApproximateTensor r;
  r.a = triple_deviator(scaled);
  r.bounds.magnitude = largest_entry(r.a);
  r.bounds.error = gamma(4) * r.bounds.magnitude + kUnderflow;
  return r;
}

}  // namespace

RefinableField::RefinableField(const TensorField& field)
    : field_(&field), input_of_(field.mesh.points.size()) {
  const auto& points = field.mesh.points;
  // Points beside their ids, so that comparing them does not jump through memory.
  struct Numbered {
    Point point;
    std::uint32_t id;
  };
  std::vector<Numbered> sorted(points.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) sorted[i] = {points[i], i};
  tbb::parallel_sort(sorted.begin(), sorted.end(), [](const Numbered& a, const Numbered& b) {
    for (int k = 0; k < 3; ++k)
      if (a.point[k] != b.point[k]) return a.point[k] < b.point[k];
    return a.id < b.id;  // equal: unused points only
  });
  for (std::size_t i = 0; i < sorted.size(); ++i) input_of_[i] = sorted[i].id;
  std::vector<VertexId> rank(points.size());
  for (std::size_t i = 0; i < input_of_.size(); ++i) rank[input_of_[i]] = VertexId(i);

  input_tets_.resize(field.mesh.tets.size());
  const auto tets = tbb::blocked_range<std::size_t>(0, input_tets_.size(), 4096);
  tbb::parallel_for(tets, [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t)
      for (int i = 0; i < 4; ++i) input_tets_[t][i] = rank[index(field.mesh.tets[t][i])];
  });

  scale_exponent_ = common_scale(field.tensors);
  approximations_.resize(points.size());
  const auto vertices = tbb::blocked_range<std::size_t>(0, points.size(), 4096);
  tbb::parallel_for(vertices, [&](const auto& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v)
      approximations_[v] = approximate_input(field.tensors[input_of_[v]], scale_exponent_);
  });
  find_block_faces();
}

std::vector<VertexId> RefinableField::vertices_of_input() const {
  std::vector<VertexId> vertex(input_of_.size());
  for (std::size_t i = 0; i < input_of_.size(); ++i) vertex[input_of_[i]] = VertexId(i);
  return vertex;
}

RefinableField::Combination RefinableField::combination(VertexId v) const {
  if (!is_input(v)) return midpoints_[index(v) - input_of_.size()];
  return {{v}, {1}, 0};
}

Tensor<Exact> RefinableField::exact(VertexId v) const { return triple_deviator(exact_tensor(v)); }

template <std::size_t N>
std::array<Exact, N> RefinableField::exact_combination(
    VertexId v, const std::vector<std::array<double, N>>& of_input) const {
  if (is_enclosed(v))
    throw std::logic_error("the tensor of an enclosed vertex is not known exactly");
  std::array<Exact, N> sum;
  if (is_rational(v)) {
    const Rational& r = rational_.at(v);
    for (std::size_t i = 0; i < 4; ++i) {
      if (r.numerators[i].is_zero()) continue;
      const std::array<double, N>& x = of_input[input_of_[index(r.vertices[i])]];
      for (std::size_t k = 0; k < N; ++k) sum[k] = sum[k] + r.numerators[i] * Exact(x[k]);
    }
    return sum;
  }
  const Combination c = combination(v);
  for (int i = 0; i < 4; ++i) {
    if (c.numerators[i] == 0) continue;
    const Exact weight = exact_dyadic(c.numerators[i], c.depth);
    const std::array<double, N>& x = of_input[input_of_[index(c.vertices[i])]];
    for (std::size_t k = 0; k < N; ++k) sum[k] = sum[k] + weight * Exact(x[k]);
  }
  return sum;
}

Tensor<Exact> RefinableField::exact_tensor(VertexId v) const {
  return exact_combination(v, field_->tensors);
}

std::array<Exact, 3> RefinableField::exact_position(VertexId v) const {
  return exact_combination(v, field_->mesh.points);
}

ApproximateTensor RefinableField::approximate_tensor(VertexId v) const {
  return tensors_.empty() ? combine_tensor(v) : tensors_[index(v)];
}

void RefinableField::keep_tensors() {
  tensors_.resize(vertex_count());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tensors_.size(), 4096),
                    [&](const auto& range) {
                      for (std::size_t v = range.begin(); v < range.end(); ++v)
                        tensors_[v] = combine_tensor(VertexId(v));
                    });
}

/// Scaling is exact but for underflow; the combination is as in `add_midpoint`.
ApproximateTensor RefinableField::combine_tensor(VertexId v) const {
  if (is_enclosed(v)) return combine_enclosed(enclosed_.at(v), true);
  if (is_rational(v)) return combine_rational(rational_.at(v), true);
  const Combination c = combination(v);
  ApproximateTensor r{};
  for (int i = 0; i < 4; ++i) {
    if (c.numerators[i] == 0) continue;
    const double weight = std::ldexp(static_cast<double>(c.numerators[i]), -c.depth);
    const Tensor<double>& t = field_->tensors[input_of_[index(c.vertices[i])]];
    double largest = 0;
    for (int k = 0; k < 9; ++k) {
      const double entry = std::ldexp(t[k], scale_exponent_);
      r.a[k] += weight * entry;
      largest = std::fmax(largest, std::fabs(entry));
    }
    r.bounds.error = std::fmax(r.bounds.error, gamma(6) * largest + kUnderflow);
  }
  r.bounds.magnitude = largest_entry(r.a);
  return r;
}

double RefinableField::weight(VertexId v, VertexId corner) const {
  if (is_rational(v)) {
    const Rational& r = rational_.at(v);
    const auto at = std::ranges::find(r.vertices, corner);
    return at == r.vertices.end()
               ? 0
               : r.weights_approx()[static_cast<std::size_t>(at - r.vertices.begin())];
  }
  const Combination c = combination(v);
  for (std::size_t i = 0; i < 4; ++i)
    if (c.numerators[i] != 0 && c.vertices[i] == corner)
      return std::ldexp(static_cast<double>(c.numerators[i]), -c.depth);
  return 0;
}

/// Each of four weights is off by at most the radius; together they are one up to 2^-50.
double RefinableField::position_radius(VertexId v) const {
  if (!is_enclosed(v)) return 0;
  const Enclosed& e = enclosed_.at(v);
  double longest = 0;
  for (const VertexId i : e.vertices)
    for (const VertexId j : e.vertices) {
      const Point a = position(i), b = position(j);
      longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
    }
  return 4 * (e.radius + 0x1p-50) * longest * (1 + 0x1p-20);
}

Point RefinableField::position(VertexId v) const {
  if (is_enclosed(v)) {
    const Enclosed& e = enclosed_.at(v);
    Point x{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Point corner = position(e.vertices[i]);
      for (std::size_t k = 0; k < 3; ++k) x[k] += e.weights[i] * corner[k];
    }
    return x;
  }
  if (is_rational(v)) {  // from one corner, so that a coordinate that all corners share is kept
    const auto used = corners(v);
    const Point origin = position(used.front());
    Point x = origin;
    for (const VertexId corner : used)
      for (std::size_t k = 0; k < 3; ++k)
        x[k] += weight(v, corner) * (position(corner)[k] - origin[k]);
    return x;
  }
  const Combination c = combination(v);
  if (c.depth == 0) return field_->mesh.points[input_of_[index(v)]];
  std::array<long double, 3> x{};  // wider than double, so that weights of few bits add no rounding
  for (int i = 0; i < 4; ++i) {
    if (c.numerators[i] == 0) continue;
    const long double weight = std::ldexp(static_cast<long double>(c.numerators[i]), -c.depth);
    const Point& corner = field_->mesh.points[input_of_[index(c.vertices[i])]];
    for (int k = 0; k < 3; ++k) x[k] += weight * corner[k];
  }
  return {static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])};
}

std::vector<VertexId> RefinableField::corners(VertexId v) const {
  if (is_enclosed(v)) {
    const auto& corners = enclosed_.at(v).vertices;
    return {corners.begin(), corners.end()};
  }
  std::vector<VertexId> r;
  if (is_rational(v)) {
    const Rational& point = rational_.at(v);
    for (std::size_t i = 0; i < 4; ++i)
      if (!point.numerators[i].is_zero()) r.push_back(point.vertices[i]);
    return r;
  }
  const Combination c = combination(v);
  for (int i = 0; i < 4; ++i)
    if (c.numerators[i] != 0) r.push_back(c.vertices[i]);
  return r;
}

std::optional<VertexId> RefinableField::add_point_between(VertexId a, VertexId b, double at) {
  if (is_enclosed(a) || is_enclosed(b)) return add_enclosed_midpoint(a, b);
  if (is_rational(a) || is_rational(b)) return add_rational_between(a, b, at);
  const std::array<Combination, 2> ends = {combination(a), combination(b)};
  const Dyadic ratio = dyadic(at);
  const std::array<WeightNumerator, 2> shares = {
      (WeightNumerator{1} << ratio.depth) - ratio.numerator, ratio.numerator};
  Combination middle;
  middle.depth = std::max(ends[0].depth, ends[1].depth) + ratio.depth;
  if (middle.depth > kWordDepth) return add_rational_between(a, b, at);
  int used = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Combination& end = ends[k];
    for (int i = 0; i < 4; ++i) {
      if (end.numerators[i] == 0) continue;
      const WeightNumerator n = shares[k] * end.numerators[i]
                                << (middle.depth - ratio.depth - end.depth);
      const auto known =
          std::find(middle.vertices.begin(), middle.vertices.begin() + used, end.vertices[i]);
      const auto slot = known - middle.vertices.begin();
      if (slot == used) middle.vertices[used++] = end.vertices[i];
      middle.numerators[slot] += n;
    }
  }

  // Weights sum to one and are rounded once; each entry takes one product and three sums: 5
  // roundings.
  ApproximateTensor r{};
  for (int i = 0; i < used; ++i) {
    const double w = std::ldexp(static_cast<double>(middle.numerators[i]), -middle.depth);
    const ApproximateTensor& corner = approximations_[index(middle.vertices[i])];
    for (int k = 0; k < 9; ++k) r.a[k] += w * corner.a[k];
    r.bounds.error =
        std::fmax(r.bounds.error, corner.bounds.error + gamma(6) * corner.bounds.magnitude);
  }
  r.bounds.magnitude = largest_entry(r.a);
  midpoints_.push_back(middle);
  approximations_.push_back(r);
  if (!tensors_.empty()) tensors_.push_back(combine_tensor(VertexId(approximations_.size() - 1)));
  return VertexId(approximations_.size() - 1);
}

}  // namespace triplex

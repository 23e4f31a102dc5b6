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

namespace triplex {
namespace {

double largest_entry(const Tensor<double>& t) {
  double m = 0;
  for (const double x : t) m = std::max(m, std::fabs(x));
  return m;
}

/// The exponent that brings the largest entry of the field into [1/2, 1); 0 for a zero field.
int common_scale(const std::vector<Tensor<double>>& tensors) {
  double m = 0;
  for (const auto& t : tensors) m = std::max(m, largest_entry(t));
  int exponent = 0;
  if (m > 0) std::frexp(m, &exponent);
  return -exponent;
}

/// What scaling down may lose: one rounding below the smallest normal double, tripled and summed.
constexpr double kUnderflow = 0x1p-1070;

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
  const Combination c = combination(v);
  std::array<Exact, N> sum;
  for (int i = 0; i < 4; ++i) {
    if (c.numerators[i] == 0) continue;
    // n < 2^51 is exact as a double, and so is the scaling by a power of two.
    const Exact weight(std::ldexp(static_cast<double>(c.numerators[i]), -c.depth));
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
    r.bounds.error = std::fmax(r.bounds.error, gamma(5) * largest + kUnderflow);
  }
  r.bounds.magnitude = largest_entry(r.a);
  return r;
}

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
  const auto add_multiple = [&](std::uint64_t n, const auto& tensor) {
    if (n == 0) return;
    constexpr int kHalf = 32;  // a double holds half of the bits exactly
    const Exact weight = (Exact(static_cast<double>(n >> kHalf)) * Exact(0x1p32) +
                          Exact(static_cast<double>(n & 0xffffffffu))) *
                         Exact(std::ldexp(1.0, -e.depth));
    for (std::size_t k = 0; k < 9; ++k) sum[k] = sum[k] + ExactRange(weight) * tensor[k];
  };
  add_multiple(e.of_node, node_tensors_.at(e.node));
  for (std::size_t i = 0; i < 4; ++i)
    if (e.of_vertices[i] != 0) add_multiple(e.of_vertices[i], exact(e.vertices[i]));
  return sum;
}

/// The mean of two weights is rounded once, by 2^-53 at most.
std::optional<VertexId> RefinableField::add_enclosed_midpoint(VertexId a, VertexId b) {
  if (!is_enclosed(a)) std::swap(a, b);
  Enclosed middle = enclosed_.at(a);
  const bool both = is_enclosed(b);
  Enclosed other = both ? enclosed_.at(b) : Enclosed{.vertices = middle.vertices, .of_node = 0};
  if (!both) {
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
  const auto mean = [&](std::uint64_t n, std::uint64_t m) {
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

unsigned RefinableField::zero_couplings(VertexId v) const {
  if (is_enclosed(v)) return 0;
  const Combination c = combination(v);
  unsigned zero = 0b111111;
  for (std::size_t i = 0; i < 4 && zero != 0; ++i) {
    if (c.numerators[i] == 0) continue;
    const Tensor<double>& t = field_->tensors[input_of_[index(c.vertices[i])]];
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
        if (t[3 * other + k] != 0) zero &= ~(1u << k);
        if (t[3 * k + other] != 0) zero &= ~(8u << k);
      }
  }
  return zero;
}

double RefinableField::weight(VertexId v, VertexId corner) const {
  const Combination c = combination(v);
  for (std::size_t i = 0; i < 4; ++i)
    if (c.numerators[i] != 0 && c.vertices[i] == corner)
      return std::ldexp(static_cast<double>(c.numerators[i]), -c.depth);
  return 0;
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
  const Combination c = combination(v);
  std::vector<VertexId> r;
  for (int i = 0; i < 4; ++i)
    if (c.numerators[i] != 0) r.push_back(c.vertices[i]);
  return r;
}

std::optional<VertexId> RefinableField::add_midpoint(VertexId a, VertexId b) {
  if (is_enclosed(a) || is_enclosed(b)) return add_enclosed_midpoint(a, b);
  const std::array<Combination, 2> ends = {combination(a), combination(b)};
  Combination middle;
  middle.depth = std::max(ends[0].depth, ends[1].depth) + 1;
  if (middle.depth > kMaxDepth) return std::nullopt;
  int used = 0;
  for (const Combination& end : ends) {
    for (int i = 0; i < 4; ++i) {
      if (end.numerators[i] == 0) continue;
      const std::uint64_t n = end.numerators[i] << (middle.depth - 1 - end.depth);
      const auto known =
          std::find(middle.vertices.begin(), middle.vertices.begin() + used, end.vertices[i]);
      const auto slot = known - middle.vertices.begin();
      if (slot == used) middle.vertices[used++] = end.vertices[i];
      middle.numerators[slot] += n;
    }
  }

  // Weights are exact and sum to one; each entry takes one product and three sums: 4 roundings.
  ApproximateTensor r{};
  for (int i = 0; i < used; ++i) {
    const double w = std::ldexp(static_cast<double>(middle.numerators[i]), -middle.depth);
    const ApproximateTensor& corner = approximations_[index(middle.vertices[i])];
    for (int k = 0; k < 9; ++k) r.a[k] += w * corner.a[k];
    r.bounds.error =
        std::fmax(r.bounds.error, corner.bounds.error + gamma(5) * corner.bounds.magnitude);
  }
  r.bounds.magnitude = largest_entry(r.a);
  midpoints_.push_back(middle);
  approximations_.push_back(r);
  if (!tensors_.empty()) tensors_.push_back(combine_tensor(VertexId(approximations_.size() - 1)));
  return VertexId(approximations_.size() - 1);
}

}  // namespace triplex

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

#include "triplex/arithmetic/interval.hpp"

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

/// numerator / 2^depth
struct Dyadic {
  std::uint64_t numerator;
  int depth;
};

/// \pre inside (0, 1) and a multiple of 2^-kMaxDepth.
Dyadic dyadic(double x) {
  Dyadic r{static_cast<std::uint64_t>(std::ldexp(x, RefinableField::kMaxDepth)),
           RefinableField::kMaxDepth};
  while (r.numerator % 2 == 0) {
    r.numerator /= 2;
    r.depth -= 1;
  }
  return r;
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
  find_mirror_planes();
}

void RefinableField::find_mirror_planes() {
  std::vector<std::uint8_t> axes(input_of_.size());
  tbb::parallel_for(std::size_t{0}, axes.size(), [&](std::size_t v) {
    const unsigned zero = zero_couplings(VertexId(v));
    axes[v] = static_cast<std::uint8_t>(zero & zero >> 3);
  });
  if (std::ranges::count(axes, 0) == std::ranges::ssize(axes)) return;
  for (const auto& tet : input_tets_)
    for (std::size_t omit = 0; omit < 4; ++omit) {
      unsigned common = 0b111;
      std::array<VertexId, 3> face;
      for (std::size_t i = 0, n = 0; i < 4; ++i)
        if (i != omit) common &= axes[index(face[n++] = tet[i])];
      if (common == 0) continue;
      std::ranges::sort(face);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (common >> axis & 1u)
          for (const auto& [i, j] : {std::array{0, 1}, {0, 2}, {1, 2}})
            mirror_edges_[axis].push_back({face[i], face[j]});
    }
  for (auto& edges : mirror_edges_) {
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  }
}

bool RefinableField::is_in_mirror_plane(std::span<const VertexId> simplex, int axis) const {
  std::vector<VertexId> carrier;
  for (const VertexId v : simplex)
    for (const VertexId corner : corners(v)) carrier.push_back(corner);
  std::ranges::sort(carrier);
  carrier.erase(std::unique(carrier.begin(), carrier.end()), carrier.end());
  if (carrier.size() < 2) return false;
  for (std::size_t i = 0; i + 1 < carrier.size(); ++i)
    if (!std::ranges::binary_search(mirror_edges_[axis], std::array{carrier[i], carrier[i + 1]}))
      return false;
  return true;
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
      w[i] = Exact(weight(v, tet[i]));
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

/// (1 - at) n_a / N_a + at n_b / N_b, over N_a N_b or over their common value: the denominators are
/// those of few points.
std::optional<VertexId> RefinableField::add_rational_between(VertexId a, VertexId b, double at) {
  if (!is_rational(a)) {
    std::swap(a, b);
    at = 1 - at;
  }
  Rational middle = rational_.at(a);
  if (is_rational(b)) middle.depth = std::max(middle.depth, rational_.at(b).depth);
  middle.depth += dyadic(at).depth;
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
    if (is_rational(b))
      throw std::logic_error("an edge between an enclosed vertex and a rational one");
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
  const auto zero_at = [&](VertexId corner) {
    unsigned zero = 0b111111;
    const Tensor<double>& t = field_->tensors[input_of_[index(corner)]];
    for (std::size_t k = 0; k < 3; ++k)
      for (const std::size_t other : {(k + 1) % 3, (k + 2) % 3}) {
        if (t[3 * other + k] != 0) zero &= ~(1u << k);
        if (t[3 * k + other] != 0) zero &= ~(8u << k);
      }
    return zero;
  };
  unsigned zero = 0b111111;
  if (is_rational(v)) {
    for (const VertexId corner : corners(v)) zero &= zero_at(corner);
    return zero;
  }
  const Combination c = combination(v);
  for (std::size_t i = 0; i < 4 && zero != 0; ++i)
    if (c.numerators[i] != 0) zero &= zero_at(c.vertices[i]);
  return zero;
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
  const std::array<std::uint64_t, 2> shares = {(std::uint64_t{1} << ratio.depth) - ratio.numerator,
                                               ratio.numerator};
  Combination middle;
  middle.depth = std::max(ends[0].depth, ends[1].depth) + ratio.depth;
  if (middle.depth > kMaxDepth) return std::nullopt;
  int used = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Combination& end = ends[k];
    for (int i = 0; i < 4; ++i) {
      if (end.numerators[i] == 0) continue;
      const std::uint64_t n = shares[k] * end.numerators[i]
                              << (middle.depth - ratio.depth - end.depth);
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

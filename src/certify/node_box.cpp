// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "node_box.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "krawczyk.hpp"
#include "node_system.hpp"
#include "triplex/arithmetic/interval.hpp"
#include "triplex/certify/enclosure.hpp"

namespace triplex {

using namespace node_system;

namespace {

Eigen::Matrix4d to_eigen(const Matrix<double>& m) {
  Eigen::Matrix4d r;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      r(i, j) = m[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return r;
}

Pencil<double> approximate_pencil(const std::array<Tensor<double>, 4>& a) {
  std::array<Tensor<double>, 3> differences;
  for (std::size_t n = 0; n < 3; ++n)
    for (std::size_t k = 0; k < 9; ++k) differences[n][k] = a[n + 1][k] - a[0][k];
  return pencil_of(a[0], differences);
}

using Box = Vector<Interval>;

/// The operator, for one pivot and one approximate inverse of the Jacobian.
class Krawczyk {
 public:
  Krawczyk(const Pencil<Interval>& pencil, std::size_t pivot, const Eigen::Matrix4d& inverse)
      : pencil_(pencil), minors_(pivot) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        inverse_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
            Interval(inverse(i, j));
  }

  /// K(Z); nothing if the pivot or l may vanish on Z.
  std::optional<Box> operator()(const Box& z) const {
    const Tensor<Interval> b = pencil_.at(z);
    if (!certainly_zero_free(b[minors_.pivot]) || !certainly_zero_free(z[3])) return {};
    const Matrix<Interval> jacobian = minors_.jacobian(b, pencil_);
    Box m;
    for (std::size_t k = 0; k < 4; ++k) m[k] = Interval(z[k].inf() + (z[k].sup() - z[k].inf()) / 2);
    return krawczyk(m, minors_.values(pencil_.at(m)), jacobian, inverse_, z);
  }

 private:
  static bool certainly_zero_free(const Interval& x) { return x.inf() > 0 || x.sup() < 0; }

  Pencil<Interval> pencil_;
  Minors minors_;
  Matrix<Interval> inverse_;
};

bool inside(const Box& inner, const Box& outer) {
  for (std::size_t k = 0; k < 4; ++k)
    if (!(outer[k].inf() < inner[k].inf() && inner[k].sup() < outer[k].sup())) return false;
  return true;
}
double width(const Box& box) {
  double w = 0;
  for (std::size_t k = 0; k < 4; ++k) w = std::max(w, box[k].sup() - box[k].inf());
  return w;
}

/// Repeats the operator while it gains: the node stays inside, so the parts common to box and image
/// hold it.
Box tightened(const Krawczyk& krawczyk, Box box) {
  constexpr int kMost = 30;
  for (int step = 0; step < kMost; ++step) {
    const auto image = krawczyk(box);
    if (!image) break;
    Box next;
    for (std::size_t k = 0; k < 4; ++k)
      next[k] = Interval(std::max(box[k].inf(), (*image)[k].inf()),
                         std::min(box[k].sup(), (*image)[k].sup()));
    const bool gained = width(next) < 0.9 * width(box);
    box = next;
    if (!gained) break;
  }
  return box;
}

struct Boxes {
  Box domain, box;
};
[[gnu::noinline]] std::optional<Boxes> prove_in_intervals(
    const std::array<std::array<Range, 9>, 4>& tensors, const NodePoint& guess, double variation,
    std::size_t pivot, const Eigen::Matrix4d& inverse) {
  const IntervalRounding protect;
  std::array<Tensor<Interval>, 4> a;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 9; ++k) a[i][k] = Interval(tensors[i][k].lo, tensors[i][k].hi);
  const Krawczyk krawczyk(pencil_of<Interval>(a[0], {a[1], a[2], a[3]}), pivot, inverse);
  constexpr int kSmallest = 40;
  for (int k = 0; k < kSmallest; ++k) {
    const double radius = std::ldexp(1.0, -k);
    Box domain;
    for (std::size_t n = 0; n < 4; ++n) {
      const double r = n < 3 ? radius : radius * variation;
      domain[n] = Interval(guess[n]) + Interval(-r, r);
    }
    const auto image = krawczyk(domain);
    if (image && inside(*image, domain)) return Boxes{domain, tightened(krawczyk, *image)};
  }
  return std::nullopt;
}

Range range_of(const Interval& x) { return {x.inf(), x.sup()}; }

[[gnu::noinline]] Range first_coordinate(const NodeBox& box) {
  const IntervalRounding protect;
  Interval x(1.0);
  for (std::size_t k = 0; k < 3; ++k) x = x - Interval(box[k].lo, box[k].hi);
  return range_of(x);
}

}  // namespace

std::optional<NodePoint> newton_approx(const std::array<Tensor<double>, 4>& tensors,
                                       NodePoint start) {
  const Pencil<double> pencil = approximate_pencil(tensors);
  double variation = 0;
  for (std::size_t n = 0; n < 3; ++n)
    for (const double x : pencil.derivative[n]) variation = std::max(variation, std::fabs(x));
  constexpr int kSteps = 12;
  constexpr double kFar = 4, kSmall = 1e-12;
  for (int step = 0; step < kSteps; ++step) {
    const Tensor<double> b = pencil.at(start);
    const Minors minors(largest_entry(b));
    const Vector<double> f = minors.values(b);
    const Eigen::Vector4d d = to_eigen(minors.jacobian(b, pencil))
                                  .partialPivLu()
                                  .solve(Eigen::Vector4d(f[0], f[1], f[2], f[3]));
    for (std::size_t k = 0; k < 4; ++k) start[k] -= d[static_cast<int>(k)];
    const double size = std::max(d.head<3>().cwiseAbs().maxCoeff(), std::fabs(d[3]) / variation);
    const double far = std::max({std::fabs(start[0]), std::fabs(start[1]), std::fabs(start[2])});
    if (!(far < kFar) || !std::isfinite(start[3])) return std::nullopt;
    if (size < kSmall) return start;
  }
  return std::nullopt;
}

NodeProof::NodeProof(const std::array<Tensor<Exact>, 4>& tensors) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 9; ++k) {
      tensors_[i][k] = enclosure(i == 0 ? tensors[0][k] : tensors[i][k] - tensors[0][k]);
      approximate_[i][k] = CGAL::to_double(tensors[i][k]);
      if (i > 0)
        variation_ = std::max(variation_,
                              std::max(std::fabs(tensors_[i][k].lo), std::fabs(tensors_[i][k].hi)));
    }
}

std::optional<IsolatedNode> NodeProof::prove(const NodePoint& guess) const {
  const Pencil<double> pencil = approximate_pencil(approximate_);
  const Tensor<double> b = pencil.at(guess);
  const std::size_t pivot = largest_entry(b);
  const Eigen::Matrix4d inverse = to_eigen(Minors(pivot).jacobian(b, pencil)).inverse();
  if (!inverse.allFinite()) return std::nullopt;
  const auto boxes = prove_in_intervals(tensors_, guess, variation_, pivot, inverse);
  if (!boxes) return std::nullopt;
  IsolatedNode node;
  for (std::size_t k = 0; k < 4; ++k) {
    node.box[k] = range_of(boxes->box[k]);
    node.domain[k] = range_of(boxes->domain[k]);
  }
  node.first = first_coordinate(node.box);
  node.feature = node.domain[3].lo > 0 ? Feature::DegeneratePlanar : Feature::DegenerateLinear;
  return node;
}

}  // namespace triplex

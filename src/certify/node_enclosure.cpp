// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Dense>
#include <cmath>

#include "krawczyk.hpp"
#include "node_system.hpp"
#include "triplex/certify/node.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {

using namespace node_system;

namespace {

using Box = Vector<ExactRange>;

double middle_approx(const ExactRange& x) {
  return (CGAL::to_double(x.lo) + CGAL::to_double(x.hi)) / 2;
}
double width_approx(const Box& z) {
  double w = 0;
  for (const ExactRange& x : z) w = std::fmax(w, CGAL::to_double(x.hi - x.lo));
  return w;
}
/// Ends are rounded outwards to `kRangeBits` bits after the point.
ExactRange rounded(const ExactRange& x) { return x / ExactRange(1); }

/// Krawczyk's operator for one approximate inverse of the Jacobian.
class Contraction {
 public:
  Contraction(const Pencil<ExactRange>& pencil, const Box& z)
      : pencil_(pencil), minors_(pivot(pencil, z)) {
    const Matrix<ExactRange> jacobian = minors_.jacobian(pencil_.at(z), pencil_);
    Eigen::Matrix4d approximate;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        approximate(i, j) =
            middle_approx(jacobian[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
    const Eigen::Matrix4d inverse = approximate.inverse();
    usable_ = inverse.allFinite();
    for (int i = 0; i < 4 && usable_; ++i)
      for (int j = 0; j < 4; ++j)
        inverse_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = inverse(i, j);
  }
  bool usable() const { return usable_; }

  Box operator()(const Box& z) const {
    const Matrix<ExactRange> jacobian = minors_.jacobian(pencil_.at(z), pencil_);
    Box m;
    const Exact half(0.5);
    for (std::size_t k = 0; k < 4; ++k) m[k] = (z[k].lo + z[k].hi) * half;
    Box image = krawczyk(m, minors_.values(pencil_.at(m)), jacobian, inverse_, z);
    for (ExactRange& x : image) x = rounded(x);
    return image;
  }

 private:
  static std::size_t pivot(const Pencil<ExactRange>& pencil, const Box& z) {
    Tensor<double> b;
    const Tensor<ExactRange> there = pencil.at(z);
    for (std::size_t k = 0; k < 9; ++k) b[k] = middle_approx(there[k]);
    return largest_entry(b);
  }

  const Pencil<ExactRange>& pencil_;
  Minors minors_;
  Matrix<ExactRange> inverse_;
  bool usable_ = false;
};

}  // namespace

std::array<ExactRange, 4> enclosed_weights(const RefinableField& field,
                                           const std::array<VertexId, 4>& vertices,
                                           const IsolatedNode& node) {
  const auto exact = Simplex<4>(field, vertices).exact_tensors();
  std::array<Tensor<ExactRange>, 4> a;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 9; ++k) a[i][k] = i == 0 ? exact[0][k] : exact[i][k] - exact[0][k];
  const Pencil<ExactRange> pencil = pencil_of<ExactRange>(a[0], {a[1], a[2], a[3]});
  Box z;
  for (std::size_t k = 0; k < 4; ++k) z[k] = {Exact(node.box[k].lo), Exact(node.box[k].hi)};

  const Contraction contraction(pencil, z);
  constexpr int kMostSteps = 30;
  constexpr double kNarrow = 0x1p-250;  // wider than what rounding to kRangeBits leaves
  for (int step = 0; contraction.usable() && step < kMostSteps && width_approx(z) > kNarrow;
       ++step) {
    const Box next = contraction(z);
    if (!(width_approx(next) < 0.5 * width_approx(z))) break;
    z = next;
  }
  return {ExactRange(1) - z[0] - z[1] - z[2], z[0], z[1], z[2]};
}

}  // namespace triplex

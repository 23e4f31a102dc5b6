// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/nappe.hpp"

#include <algorithm>

#include "block.hpp"
#include "triplex/bernstein/discriminant.hpp"

namespace triplex {
namespace {

Eigen::Matrix3d to_eigen(const Tensor<double>& t) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = t[static_cast<std::size_t>(i)];
  return m;
}

/// D > 0, of a deviator.
bool is_real_approx(const Eigen::Matrix3d& a) {
  const double p = -(a * a).trace() / 2, q = a.determinant();
  return -4 * p * p * p - 27 * q * q > 0;
}

/// Weights of the differences A_k - A_0, k = 1 ... N-1: a direction in the affine hull.
template <int N>
using Direction = Eigen::Matrix<double, N - 1, 1>;

/// The Lorentzian form of the compressed derivatives at a tensor, and the basis that it refers to.
template <int N>
struct FormThere {
  SplittingBasis basis;
  std::array<Eigen::Vector3d, N - 1> derivatives;  // (u, v, w) of each difference
  Eigen::Matrix<double, N - 1, N - 1> form;

  /// The direction that is timelike there, if any, and by the largest margin.
  std::optional<Direction<N>> timelike() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N - 1, N - 1>> solver(form);
    if (!(solver.eigenvalues()[0] < 0)) return {};
    return Direction<N>(solver.eigenvectors().col(0));
  }
};

template <int N>
std::optional<FormThere<N>> form_at(const Eigen::Matrix3d& tensor,
                                    const std::array<Eigen::Matrix3d, N - 1>& differences) {
  const auto basis = splitting_basis_approx(tensor);
  if (!basis) return {};
  FormThere<N> there{*basis, {}, {}};
  const Eigen::Matrix3d inverse = basis->inverse();
  for (int k = 0; k < N - 1; ++k)
    there.derivatives[k] =
        traceless_part((inverse * differences[k] * *basis).template topLeftCorner<2, 2>());
  for (int k = 0; k < N - 1; ++k)
    for (int m = 0; m < N - 1; ++m) {
      const auto &a = there.derivatives[k], &b = there.derivatives[m];
      there.form(k, m) = a[0] * b[0] + a[1] * b[1] - a[2] * b[2];
    }
  return there;
}

/// Proves the condition for one direction by halving the simplex, in place of the mesh, until the
/// enclosures are narrow enough.
template <int N>
class Verification {
 public:
  using Cell = std::array<Tensor<Interval>, N>;

  Verification(const Cell& cell, const Direction<N>& direction) {
    for (int i = 0; i < 9; ++i) {
      derivative_[i] = Interval(0);
      for (int k = 1; k < N; ++k)
        derivative_[i] += Interval(direction[k - 1]) * (cell[k][i] - cell[0][i]);
    }
    for (int i = 0; i < 9; ++i) derivative_approx_(i / 3, i % 3) = middle(derivative_[i]);
  }

  bool holds(const Cell& cell) {
    if (holds_at_once(cell) || is_real(cell)) return true;
    if ((cells_left_ -= 2) < 0) return false;
    const auto [a, b] = longest_edge(cell);
    Tensor<Interval> half;
    for (int i = 0; i < 9; ++i) half[i] = (cell[a][i] + cell[b][i]) * Interval(0.5);
    for (const int replaced : {a, b}) {
      Cell part = cell;
      part[replaced] = half;
      if (!holds(part)) return false;
    }
    return true;
  }

 private:
  static double middle(const Interval& x) { return x.inf() + (x.sup() - x.inf()) / 2; }

  /// D > 0 throughout: nothing is asked there.
  static bool is_real(const Cell& cell) {
    const auto minus_d = minus_discriminant(forms_of<Interval, N>(cell));
    return std::ranges::all_of(minus_d, [](const Interval& d) { return d.sup() < 0; });
  }

  bool holds_at_once(const Cell& cell) {
    Eigen::Matrix3d centre = Eigen::Matrix3d::Zero();
    for (const auto& tensor : cell)
      for (int i = 0; i < 9; ++i) centre(i / 3, i % 3) += middle(tensor[i]) / N;
    auto basis = splitting_basis_approx(centre);
    if (!basis) return stop_unless_real(centre);
    const Eigen::Matrix2d block =
        (basis->inverse() * derivative_approx_ * *basis).topLeftCorner<2, 2>();
    const auto rotation = rotation_basis_approx(traceless_part(block));
    if (!rotation) return stop_unless_real(centre);
    basis->leftCols<2>() = (basis->leftCols<2>() * *rotation).eval();
    return compression_is_timelike(cell, derivative_, *basis);
  }
  /// No halving helps where the condition fails at the centre, and matters.
  bool stop_unless_real(const Eigen::Matrix3d& centre) {
    if (!is_real_approx(centre)) cells_left_ = 0;
    return false;
  }

  static std::array<int, 2> longest_edge(const Cell& cell) {
    std::array<int, 2> edge{0, 1};
    double longest = -1;
    for (int a = 0; a < N; ++a)
      for (int b = a + 1; b < N; ++b) {
        double length = 0;
        for (int i = 0; i < 9; ++i) {
          const double x = middle(cell[a][i]) - middle(cell[b][i]);
          length += x * x;
        }
        if (length > longest) longest = length, edge = {a, b};
      }
    return edge;
  }

  static constexpr int kCells = 64;  // a limit of effort only
  int cells_left_ = kCells;
  Tensor<Interval> derivative_;
  Eigen::Matrix3d derivative_approx_;
};

/// Directions worth a try: that of the centre, and the mean of those of the corners.
template <int N>
std::vector<Direction<N>> directions_approx(const Simplex<N>& simplex) {
  std::array<Eigen::Matrix3d, N> a;
  Eigen::Matrix3d centre = Eigen::Matrix3d::Zero();
  for (int i = 0; i < N; ++i) {
    a[i] = to_eigen(simplex.field().approximate(simplex.vertices()[i]).a);
    centre += a[i] / N;
  }
  std::array<Eigen::Matrix3d, N - 1> differences;
  for (int k = 1; k < N; ++k) differences[k - 1] = a[k] - a[0];
  std::vector<Direction<N>> found;
  const auto there = form_at<N>(centre, differences);
  if (!there) return found;
  const auto best = there->timelike();
  if (!best) return found;
  found.push_back(*best);
  Direction<N> sum = *best;
  for (const auto& corner : a) {
    if (is_real_approx(corner)) continue;
    const auto form = form_at<N>(corner, differences);
    const auto direction = form ? form->timelike() : std::nullopt;
    if (!direction) return {};  // not timelike at a complex corner: no direction serves
    sum += direction->dot(*best) < 0 ? Direction<N>(-*direction) : *direction;
  }
  found.push_back(sum.normalized());
  return found;
}

}  // namespace

template <int N>
std::optional<NappeDirection<N>> nappe_direction(const Simplex<N>& simplex, SignStages& stages) {
  if (!simplex.filter_usable()) return {};
  const auto directions = directions_approx(simplex);
  if (directions.empty()) return {};
  stages.count(Stage::Interval);
  IntervalRounding protect;
  std::array<Tensor<Interval>, N> cell;
  for (int i = 0; i < N; ++i) {
    const ApproximateTensor& v = simplex.field().approximate(simplex.vertices()[i]);
    const Interval error(-v.bounds.error, v.bounds.error);
    for (int k = 0; k < 9; ++k) cell[i][k] = Interval(v.a[k]) + error;
  }
  for (const Direction<N>& d : directions) {
    if (!Verification<N>(cell, d).holds(cell)) continue;
    NappeDirection<N> weights;
    std::copy(d.begin(), d.end(), weights.begin());
    return weights;
  }
  return {};
}
template <int N>
bool certifies_nappes(const Simplex<N>& simplex, SignStages& stages) {
  return nappe_direction(simplex, stages).has_value();
}

template std::optional<NappeDirection<3>> nappe_direction<3>(const Simplex<3>&, SignStages&);
template std::optional<NappeDirection<4>> nappe_direction<4>(const Simplex<4>&, SignStages&);
template bool certifies_nappes<3>(const Simplex<3>&, SignStages&);
template bool certifies_nappes<4>(const Simplex<4>&, SignStages&);

}  // namespace triplex

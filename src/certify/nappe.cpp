// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/nappe.hpp"

#include <algorithm>

#include "block.hpp"
#include "lorentz_form.hpp"
#include "tensor_parts.hpp"

namespace triplex {
namespace {

/// Proves the condition for one direction by halving the simplex, in place of the mesh, until the
/// enclosures are narrow enough.
template <int N>
class Verification {
 public:
  using Cell = TensorCell<N>;

  Verification(const Cell& cell, const Direction<N>& direction)
      : derivative_(change_along<N>(cell, direction)), derivative_approx_(middle(derivative_)) {}

  bool holds(const Cell& cell) {
    if (holds_at_once(cell) || is_real<N>(cell)) return true;
    if ((cells_left_ -= 2) < 0) return false;
    for (const Cell& part : halves<N>(cell, longest_edge<N>(cell)))
      if (!holds(part)) return false;
    return true;
  }

 private:
  bool holds_at_once(const Cell& cell) {
    const Eigen::Matrix3d centre = centre_of<N>(cell);
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
  const TensorCell<N> cell = tensor_cell(simplex);
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

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/nappe_points.hpp"

#include <cmath>

#include "block_algebra.hpp"
#include "spacelike_guess.hpp"
#include "tensor_parts.hpp"

namespace triplex {
namespace {

/// Looks for parts in which the block may be a multiple of the identity.
template <int N>
class NodeExclusion {
 public:
  NodeExclusion(const SplittingBasis& basis, const Tensor<Interval>& inverse_basis,
                const std::array<double, 2>& weights)
      : basis_(basis), inverse_(inverse_basis), weights_(weights) {}

  bool holds(const TensorCell<N>& cell, int depth = 0) {
    const auto couplings = couplings_unless_apart(cell);
    if (!couplings || is_real<N>(cell)) return true;
    if (depth == kDepth || (cells_left_ -= 2) < 0) return false;
    for (const TensorCell<N>& part : halves<N>(cell, edge_to_cut(cell, *couplings)))
      if (!holds(part, depth + 1)) return false;
    return true;
  }

 private:
  /// n_01 and n_10 of the block, unless it is no multiple of the identity anywhere in the cell;
  /// all numbers if there is no block.
  std::optional<Pair> couplings_unless_apart(const TensorCell<N>& cell) const {
    const Interval all(-INFINITY, INFINITY);
    const Split a = enclosure_in(cell, basis_, inverse_);
    const auto y = invariant_plane(a);
    if (!y) return Pair{all, all};
    const Block n = restricted(a, *y);
    if (!inverse_of_shifted(n, a.corner - dot(*y, a.column))) return Pair{all, all};
    if (sign_of(n[0][1]) != 0 || sign_of(n[1][0]) != 0 || sign_of(n[0][0] - n[1][1]) != 0)
      return {};
    // The part that is linear in the tensor, by its values at the corners.
    Interval combined = combination(cell[0]);
    for (int i = 1; i < N; ++i) combined = hull(combined, combination(cell[i]));
    combined += Interval(weights_[0]) * a.column[0] * (*y)[1] +
                Interval(weights_[1]) * a.column[1] * (*y)[0];
    if (sign_of(combined) != 0) return {};
    return Pair{n[0][1], n[1][0]};
  }

  Interval combination(const Tensor<Interval>& t) const {
    const Split corner = split(in_basis(t, basis_, inverse_));
    return Interval(weights_[0]) * corner.block[0][1] + Interval(weights_[1]) * corner.block[1][0];
  }

  /// The edge along which a coupling changes nearly as much as it does on the whole cell; else the
  /// longest one.
  std::array<int, 2> edge_to_cut(const TensorCell<N>& cell, const Pair& couplings) const {
    constexpr double kMostly = 0.75;  // a choice only
    std::array<std::array<double, 2>, N> n;
    for (int i = 0; i < N; ++i) {
      const Split t = split(in_basis(cell[i], basis_, inverse_));
      n[i] = {middle(t.block[0][1]), middle(t.block[1][0])};
    }
    const std::array<double, 2> most = {magnitude(couplings[0]), magnitude(couplings[1])};
    const auto change = [&](int a, int b) {
      return std::max(std::fabs(n[a][0] - n[b][0]) / most[0],
                      std::fabs(n[a][1] - n[b][1]) / most[1]);
    };
    const auto edge = longest_edge<N>(change);
    return change(edge[0], edge[1]) > kMostly ? edge : longest_edge<N>(cell);
  }

  static constexpr int kCells = 1024, kDepth = 64;  // limits of effort only
  int cells_left_ = kCells;
  const SplittingBasis& basis_;
  const Tensor<Interval>& inverse_;
  std::array<double, 2> weights_;  // of a combination that does not change across the gap
};

}  // namespace

template <int N>
int nappe_at(const Simplex<N>& simplex, const NappeDirection<N>& direction, const EdgePoint& zero) {
  const IntervalRounding protect;
  const TensorCell<N> cell = tensor_cell(simplex);
  const Tensor<Interval> change = change_along<N>(cell, direction);
  const auto& from = cell[static_cast<std::size_t>(zero.edge[0])];
  const auto& to = cell[static_cast<std::size_t>(zero.edge[1])];
  const Interval t(zero.weight.lo, zero.weight.hi);
  Tensor<Interval> a;
  for (std::size_t k = 0; k < 9; ++k) a[k] = from[k] + t * (to[k] - from[k]);
  // With P = 2 p and Q = 6 q at A, and at (A, A') half of P', a third of Q': D = -4 p^3 - 27 q^2
  // has the derivative -3 P^2 p' - 9/2 Q q'.
  const auto f = forms_of<Interval, 2>({a, change});
  return -sign_of(-Interval(3) * square(f.P(0, 0)) * f.P(0, 1) -
                  Interval(4.5) * f.Q(0, 0, 0) * f.Q(0, 0, 1));
}

template <int N>
bool keeps_nappes_apart(const Simplex<N>& simplex, const NappeDirection<N>& direction,
                        SignStages& stages) {
  const auto guess = spacelike_guess(simplex);
  if (!guess) return false;
  stages.count(Stage::Interval);
  const IntervalRounding protect;
  const auto inverse_basis = inverse(guess->basis);
  if (!inverse_basis) return false;
  const TensorCell<N> cell = tensor_cell(simplex);
  const Split change =
      split(in_basis(change_along<N>(cell, direction), guess->basis, *inverse_basis));
  return NodeExclusion<N>(guess->basis, *inverse_basis,
                          {-middle(change.block[1][0]), middle(change.block[0][1])})
      .holds(cell);
}

template int nappe_at<3>(const Simplex<3>&, const NappeDirection<3>&, const EdgePoint&);
template int nappe_at<4>(const Simplex<4>&, const NappeDirection<4>&, const EdgePoint&);
template bool keeps_nappes_apart<3>(const Simplex<3>&, const NappeDirection<3>&, SignStages&);
template bool keeps_nappes_apart<4>(const Simplex<4>&, const NappeDirection<4>&, SignStages&);

}  // namespace triplex

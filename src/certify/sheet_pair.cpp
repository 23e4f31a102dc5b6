// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/certify/sheet_pair.hpp"

#include <algorithm>
#include <cmath>

#include "block_algebra.hpp"
#include "spacelike_guess.hpp"
#include "tensor_parts.hpp"

namespace triplex {
namespace {

/// The block of the pair, by a plane that is invariant and the only one to leave out the largest
/// (side 1) or the smallest (side -1) eigenvalue.
struct PairBlock {
  Split tensor;
  Pair plane;
  Block block, apart;
  int side = 0;
};
std::optional<PairBlock> pair_block(const Split& a) {
  const auto y = invariant_plane(a);
  if (!y) return {};
  const Block n = restricted(a, *y);
  const Interval third = a.corner - dot(*y, a.column);
  const auto apart = inverse_of_shifted(n, third);
  if (!apart) return {};
  // Both eigenvalues of the block less the third one: product and sum.
  const Interval x = n[0][0] - third, w = n[1][1] - third;
  if (sign_of(x * w - n[0][1] * n[1][0]) <= 0) return {};
  const int side = -sign_of(x + w);
  if (side == 0) return {};
  return PairBlock{a, *y, n, *apart, side};
}

/// Proves the condition in one basis for one direction, on ever smaller parts.
template <int N>
class Verification {
 public:
  Verification(const SplittingBasis& basis, const Tensor<Interval>& inverse_basis,
               const Tensor<Interval>& derivative)
      : basis_(basis),
        inverse_(inverse_basis),
        derivative_(split(in_basis(derivative, basis, inverse_basis))) {}

  bool is_pair(const TensorCell<N>& cell) {
    return on_parts(cell, [&](const TensorCell<N>& part) { return has_pair(part); });
  }
  /// After `is_pair`: D > 0 on the cell, as on all of its parts.
  bool is_empty() const { return is_empty_; }

 private:
  enum class Found { No, Yes, Never };

  template <class Test>
  bool on_parts(const TensorCell<N>& cell, const Test& test) {
    const Found found = test(cell);
    if (found == Found::Yes) return true;
    if (found == Found::Never || (cells_left_ -= 2) < 0) return false;
    for (const TensorCell<N>& part : halves<N>(cell, longest_edge<N>(cell)))
      if (!on_parts(part, test)) return false;
    return true;
  }
  static bool couplings_agree(const PairBlock& b) {
    return sign_of(b.block[0][1]) * sign_of(b.block[1][0]) > 0;
  }

  /// On a tet the entries' difference grows everywhere; on a face only where D <= 0 may be.
  Found has_pair(const TensorCell<N>& part) {
    const auto b = pair_block(enclosure_in(part, basis_, inverse_));
    if (N == 3 && ((b && couplings_agree(*b)) || is_real<N>(part))) return Found::Yes;
    if (!b) return Found::No;
    if (side_ == 0) side_ = b->side;
    if (N == 4 && b->side != side_) return Found::Never;
    const Block rate = restricted_rate(b->tensor, b->plane, derivative_, b->apart);
    const Interval growth = rate[0][0] - rate[1][1];
    if (growth.sup() < 0) return Found::Never;
    if (sign_of(growth) <= 0) return Found::No;
    if (N == 4 && (couplings_agree(*b) || is_real<N>(part))) return Found::Yes;
    const Interval product = b->block[0][1] * b->block[1][0];
    if (product.inf() > 0) return Found::Never;
    if (sign_of(product) >= 0) return Found::No;
    const Interval change = rate[0][1] * b->block[1][0] + b->block[0][1] * rate[1][0];
    if (sign_of(-square(growth) * product - square(change)) <= 0) return Found::No;
    is_empty_ = false;
    return Found::Yes;
  }

  static constexpr int kCells = 96;  // a limit of effort only
  int cells_left_ = kCells;
  int side_ = 0;
  bool is_empty_ = true;
  const SplittingBasis& basis_;
  const Tensor<Interval>& inverse_;
  Split derivative_;
};

}  // namespace

template <int N>
std::optional<SheetPair<N>> SheetPair<N>::find(const Simplex<N>& simplex, SignStages& stages) {
  if (!simplex.filter_usable()) return {};
  const auto guess = spacelike_guess(simplex);
  if (!guess) return {};
  stages.count(Stage::Interval);
  const IntervalRounding protect;
  const auto inverse_basis = inverse(guess->basis);
  if (!inverse_basis) return {};
  const TensorCell<N> cell = tensor_cell(simplex);
  SheetPair pair;
  for (int i = 0; i < 9; ++i) pair.basis_[static_cast<std::size_t>(i)] = guess->basis(i / 3, i % 3);
  const Tensor<Interval> derivative = change_along<N>(cell, guess->direction);
  std::copy(guess->direction.begin(), guess->direction.end(), pair.direction_.begin());
  Verification<N> verification(guess->basis, *inverse_basis, derivative);
  if (!verification.is_pair(cell)) return {};
  pair.empty_ = verification.is_empty();
  return pair;
}

template <int N>
int SheetPair<N>::sheet_at(const Simplex<N>& simplex, const EdgePoint& zero) const {
  const IntervalRounding protect;
  SplittingBasis basis;
  for (int i = 0; i < 9; ++i) basis(i / 3, i % 3) = basis_[static_cast<std::size_t>(i)];
  const auto inverse_basis = inverse(basis);
  if (!inverse_basis) return 0;
  const TensorCell<N> cell = tensor_cell(simplex);
  const auto& from = cell[zero.edge[0]];
  const auto& to = cell[zero.edge[1]];
  const Interval t(zero.weight.lo, zero.weight.hi);
  std::array<Tensor<Interval>, 1> there;
  for (std::size_t k = 0; k < 9; ++k) there[0][k] = from[k] + t * (to[k] - from[k]);
  const auto b = pair_block(enclosure_in(there, basis, *inverse_basis));
  return b ? sign_of(b->block[0][0] - b->block[1][1]) : 0;
}

template class SheetPair<3>;
template class SheetPair<4>;

}  // namespace triplex

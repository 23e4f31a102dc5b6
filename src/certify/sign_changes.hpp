// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "triplex/bernstein/discriminant.hpp"
#include "triplex/certify/simplex.hpp"

namespace triplex {

/// Sign changes in a sequence, zeros dropped, counted over every way to settle the unknown signs:
/// the fewest and the most, by dynamic programming over the sign of the last member.
class SignChanges {
 public:
  void add(Certainty c) {
    for (const bool positive : {false, true}) {
      if (c == (positive ? Certainty::Negative : Certainty::Positive)) {
        next_[positive] = {kNever, -kNever};
        continue;
      }
      const Range same = last_[positive], other = last_[!positive];
      next_[positive] = first_ ? Range{0, 0}
                               : Range{std::min(same.fewest, other.fewest + 1),
                                       std::max(same.most, other.most + 1)};
    }
    last_ = next_;
    first_ = false;
  }
  int most() const { return std::max(last_[0].most, last_[1].most); }
  int fewest() const { return std::min(last_[0].fewest, last_[1].fewest); }
  Verdict at_most_one() const {
    if (most() <= 1) return Verdict::Yes;
    return fewest() > 1 ? Verdict::No : Verdict::Unknown;
  }

 private:
  static constexpr int kNever = 1000;  // more changes than members
  struct Range {
    int fewest, most;
  };
  std::array<Range, 2> last_{}, next_{};
  bool first_ = true;
};

/// The common sign of the coefficients of a layer, once all are added.
class LayerSign {
 public:
  void add(Certainty c) {
    if (first_)
      sign_ = c;
    else if (sign_ != c)
      sign_ = Certainty::Unknown;
    first_ = false;
  }
  Certainty sign() const { return sign_; }

 private:
  Certainty sign_ = Certainty::Unknown;
  bool first_ = true;
};

/// From the signs of the Bernstein coefficients of a form: whether some split of the vertices into
/// two sides leaves at most one change in the sequence of layers, and with it at most one root on
/// every segment between the two. Source: proofs/pencil.md.
template <int N, int Degree>
Verdict one_change_in_some_split(
    const std::array<Certainty, Monomials<N, Degree>::count()>& signs) {
  for (unsigned side = 1; side < 1u << (N - 1); ++side) {  // the other side is the rest
    std::array<LayerSign, Degree + 1> layers;
    for (std::size_t n = 0; n < signs.size(); ++n) {
      int k = 0;
      for (int i = 0; i < N; ++i)
        if (side >> i & 1u) k += kMonomials<N, Degree>.exponents[n][i];
      layers[k].add(signs[n]);
    }
    SignChanges changes;
    for (const LayerSign& layer : layers) changes.add(layer.sign());
    if (changes.most() <= 1) return Verdict::Yes;
  }
  return std::ranges::find(signs, Certainty::Unknown) == signs.end() ? Verdict::No
                                                                     : Verdict::Unknown;
}

}  // namespace triplex

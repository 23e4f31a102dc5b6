// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "error_bounds.hpp"
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
    positive_ |= c == Certainty::Positive;
    negative_ |= c == Certainty::Negative;
    unknown_ |= c == Certainty::Unknown;
  }
  Certainty sign() const {
    if (unknown_ || positive_ == negative_) return Certainty::Unknown;
    return positive_ ? Certainty::Positive : Certainty::Negative;
  }
  /// Coefficients of both signs: no higher rung makes this layer one of known sign.
  bool is_mixed() const { return positive_ && negative_; }
  bool has_unknown() const { return unknown_; }
  /// Whether the sign is this one; unknown as long as a higher rung may say so.
  Verdict is(Certainty c) const {
    if (c == Certainty::Positive ? negative_ : positive_) return Verdict::No;
    return unknown_ ? Verdict::Unknown : Verdict::Yes;
  }
  LayerSign negated() const {
    LayerSign r = *this;
    std::swap(r.positive_, r.negative_);
    return r;
  }

 private:
  bool positive_ = false, negative_ = false, unknown_ = false;
};

/// Whether a sequence of layers has at most one change of sign. No, if no higher rung can say yes.
template <std::size_t Count>
Verdict at_most_one_change(const std::array<LayerSign, Count>& layers) {
  SignChanges changes;
  for (const LayerSign& layer : layers) changes.add(layer.sign());
  if (changes.most() <= 1) return Verdict::Yes;
  const bool open = std::ranges::any_of(layers, &LayerSign::has_unknown) &&
                    std::ranges::count_if(layers, &LayerSign::is_mixed) <= 1;
  return open ? changes.at_most_one() : Verdict::No;
}

/// The signs of the Bernstein coefficients of a form.
template <int N, int Degree>
using CoefficientSigns = std::array<Certainty, Monomials<N, Degree>::count()>;

/// The signs of the coefficients of -D(A'), given as monomial coefficients.
template <class NT, int N>
CoefficientSigns<N, 6> signs_of(const SexticCoefficients<NT, N>& minus_d, double error) {
  CoefficientSigns<N, 6> signs;
  for (std::size_t n = 0; n < signs.size(); ++n)
    signs[n] = certainty(minus_d[n], kMonomials<N, 6>.multinomial[n] * error);
  return signs;
}
template <class NT, int N>
CoefficientSigns<N, 6> signs_of_minus_discriminant(const Forms<NT, N>& f,
                                                   const FormBounds& bounds) {
  return signs_of<NT, N>(minus_discriminant(f), discriminant_coefficient_error(bounds));
}

/// The layers of a form by the power of the vertices of one side, of which bit i says that vertex i
/// is one.
template <int N, int Degree>
std::array<LayerSign, Degree + 1> layers_towards(unsigned side,
                                                 const CoefficientSigns<N, Degree>& signs) {
  std::array<LayerSign, Degree + 1> layers;
  for (std::size_t n = 0; n < signs.size(); ++n) {
    int k = 0;
    for (int i = 0; i < N; ++i)
      if (side >> i & 1u) k += kMonomials<N, Degree>.exponents[n][i];
    layers[k].add(signs[n]);
  }
  return layers;
}

/// Whether some split of the vertices into two sides leaves at most one change in the sequence of
/// layers, and with it at most one root on every segment between the two. Source: proofs/pencil.md.
template <int N, int Degree>
Verdict one_change_in_some_split(const CoefficientSigns<N, Degree>& signs) {
  Verdict best = Verdict::No;
  for (unsigned side = 1; side < 1u << (N - 1) && best != Verdict::Yes; ++side)
    best = std::max(best, at_most_one_change(layers_towards<N, Degree>(side, signs)));
  return best;
}

}  // namespace triplex

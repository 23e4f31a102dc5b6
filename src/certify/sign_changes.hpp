// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

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

}  // namespace triplex

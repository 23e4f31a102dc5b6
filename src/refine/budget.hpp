// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
/// Bounds the refinement: how many bisections each tet of the input may ask for, and the reserve
/// that the last ones share.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "triplex/refine/refine.hpp"

namespace triplex {

class Budget {
 public:
  Budget(std::size_t tets, std::uint32_t limit) : asked_for_(tets, 0), limit_(limit) {}

  std::uint32_t limit() const { return limit_; }
  std::uint32_t asked_for(TetId tet) const { return asked_for_[index(tet)]; }
  bool is_spent(TetId tet) const { return asked_for(tet) >= limit_; }
  void ask(TetId tet) { asked_for_[index(tet)] += 1; }

  /// Leaves of tets whose budget is spent, of those that `goes_on` picks: each of these tets gets
  /// an equal share of the reserve, if that is at least as much again. Returns the leaves.
  template <class Predicate>
  std::vector<std::uint32_t> share(std::uint32_t reserve, std::span<const Leaf> leaves,
                                   Predicate&& goes_on) {
    std::vector<std::uint32_t> left;
    std::unordered_set<TetId> tets;
    for (std::size_t n = 0; n < leaves.size(); ++n)
      if (is_spent(leaves[n].input) && goes_on(leaves[n])) {
        tets.insert(leaves[n].input);
        left.push_back(static_cast<std::uint32_t>(n));
      }
    if (tets.empty() || reserve / tets.size() < limit_) return {};
    limit_ += static_cast<std::uint32_t>(reserve / tets.size());
    return left;
  }

  std::vector<std::uint32_t> take() && { return std::move(asked_for_); }

 private:
  std::vector<std::uint32_t> asked_for_;  // per tet of the input
  std::uint32_t limit_;
};

}  // namespace triplex

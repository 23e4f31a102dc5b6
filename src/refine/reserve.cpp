// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reserve.hpp"

#include <algorithm>

#include "triplex/certify/cell.hpp"

namespace triplex {
namespace {

// Choices by trial, docs/decisions/0020-few-tets-share-a-reserve.md.

/// Leaves made by more bisections shrink towards a point that no halving reaches, where exact
/// numbers are long: of more tets than a few, those with such a leaf are left as they are.
constexpr int kDeep = 40;
constexpr std::size_t kFewTets = 4;
/// No share is larger than so many times the limit: a tet that is beyond help takes all of it.
constexpr std::uint32_t kMostTimes = 16;

}  // namespace

std::unordered_set<TetId> worth_a_share(std::span<const Leaf> leaves, const Budget& budget) {
  std::unordered_set<TetId> open, deep;
  for (const Leaf& leaf : leaves) {
    if (leaf.open == 0 || is_at_vertex(leaf.obstacle) || !budget.is_spent(leaf.input)) continue;
    open.insert(leaf.input);
    if (leaf.depth > kDeep) deep.insert(leaf.input);
  }
  if (open.size() > kFewTets)
    for (const TetId tet : deep) open.erase(tet);
  return open;
}

bool Budget::share(std::uint32_t reserve, std::unordered_set<TetId> tets) {
  if (tets.empty() || reserve / tets.size() < limit_) return false;
  const auto share = static_cast<std::uint32_t>(reserve / tets.size());
  shared_limit_ = limit_ + std::min(share, kMostTimes * limit_);
  sharing_ = std::move(tets);
  return true;
}

}  // namespace triplex

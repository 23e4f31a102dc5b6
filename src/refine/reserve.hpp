// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <unordered_set>

#include "triplex/refine/refine.hpp"

namespace triplex {

/// The tets of the input that are open as their budget is spent, without those where more of it
/// would not help, as far as one can tell. Which are given more is a choice that nothing certified
/// depends on.
std::unordered_set<TetId> worth_a_share(std::span<const Leaf> leaves, const Budget& budget);

}  // namespace triplex

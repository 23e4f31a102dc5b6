// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "block.hpp"

/// Interval algebra of tensors that split, nearly, into a 2 x 2 block and a number. All of it is
/// valid inside an `IntervalRounding` only. Source: proofs/nappe.md.
namespace triplex {

using Pair = std::array<Interval, 2>;
using Block = std::array<Pair, 2>;

// What overflowed and is no interval any more (infinity minus infinity, zero times infinity) counts
// as all numbers.
bool is_interval(const Interval& x);
bool contains_zero(const Interval& x);
double magnitude(const Interval& x);
Interval square(const Interval& x);
Interval hull(const Interval& a, const Interval& b);
/// 1 or -1 if all numbers of the interval have that sign, else 0.
int sign_of(const Interval& x);

std::optional<Block> inverse(const Block& m);
Interval dot(const Pair& a, const Pair& b);
Pair row_times(const Pair& row, const Block& m);
/// The inverse of m - shift I.
std::optional<Block> inverse_of_shifted(const Block& m, const Interval& shift);

/// A 3 x 3 matrix as [[block, column], [row, corner]].
struct Split {
  Block block;
  Pair column, row;
  Interval corner;
};
Split split(const Tensor<Interval>& t);

/// Enclosure of the inverse of a basis.
std::optional<Tensor<Interval>> inverse(const SplittingBasis& s);
Tensor<Interval> in_basis(const Tensor<Interval>& t, const SplittingBasis& basis,
                          const Tensor<Interval>& inverse_basis);
/// The hull of tensors, in a basis.
Split enclosure_in(std::span<const Tensor<Interval>> tensors, const SplittingBasis& basis,
                   const Tensor<Interval>& inverse_basis);

/// The plane {(z, y z)} that a tensor maps into itself: y (M - d) = c - (y b) y.
std::optional<Pair> invariant_plane(const Split& a);
/// The line through (r, 1) that it maps into itself: (M - d) r = r (c r) - b.
std::optional<Pair> invariant_line(const Split& a);

/// The tensor restricted to the plane, in the coordinates z: M + b y.
Block restricted(const Split& a, const Pair& y);

/// How the restricted tensor changes with the tensor. `apart` is the inverse of M + b y minus the
/// third eigenvalue d - y b, where that is none of the pair's.
Block restricted_rate(const Split& a, const Pair& y, const Split& derivative, const Block& apart);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ground_truth_families.hpp"

namespace triplex::detail {

/// S B S^-1 with B = [[-k/2 + u, m12, 0], [m21, -k/2 - u, 0], [0, 0, k]] and a constant unimodular
/// integer S, which changes no invariant but hides the block. With det = k^2/4 - u^2 - m12 m21,
/// p = det - k^2, q = k det and D = (2 k^2 + det)^2 4 (u^2 + m12 m21).
std::array<Tensor<double>, 4> block_tensors(double k, const LinearForm& u, const LinearForm& m12,
                                            const LinearForm& m21);

inline constexpr LinearForm constant_form(double value) { return {value, 0, 0, 0}; }

/// How the argument begins for every field made of blocks.
inline constexpr const char* kBlockSource =
    "The tensor is similar to a block [[-k/2 + u, m12], [m21, -k/2 - u]] and the number k, by a "
    "constant matrix of integers and determinant one. With d = k^2/4 - u^2 - m12 m21: p = d - k^2, "
    "q = k d, D = (2 k^2 + d)^2 4 (u^2 + m12 m21); in the box 2 k^2 + d > 0. ";

/// The box has no node: two independent eigenvectors of a double eigenvalue need a block that is a
/// multiple of the identity, or 2 k^2 + d = 0.
inline constexpr const char* kNoNodes = " No nodes: they need 2 k^2 + d = 0 or u = m12 = m21 = 0.";

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "triplex/certify/simplex.hpp"
#include "triplex/extract/identical.hpp"

namespace triplex {

/// What is exactly zero at a vertex: p, q, D; the entries off a block along x, y, z; T - T^t. What
/// holds on a simplex holds at its vertices, so the common flags say what may hold; those of the
/// entries, which are linear, say what does.
using Flags = std::uint8_t;
inline constexpr Flags kZeroP = 1, kZeroQ = 2, kZeroD = 4;
inline constexpr Flags kInvariantFlags = kZeroP | kZeroQ | kZeroD;
inline constexpr Flags kBlockFlags = 8 | 16 | 32;

/// `tensor` is T at the vertex. A filter, then exact.
Flags flags_at(const RefinableField& field, VertexId v, const Tensor<double>& tensor);

/// The identities of the invariants at a vertex.
IdentitySet identity_at_vertex(Flags flags);

/// What holds on a simplex with N vertices, 2 to 4, from their common flags. Of the invariants only
/// what says more than `known`, which holds on a larger simplex. Exact.
template <int N>
IdentitySet identities(const RefinableField& field, const std::array<VertexId, N>& vertices,
                       Flags shared, IdentitySet known);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "triplex/certify/symmetric_field.hpp"
#include "triplex/feature/feature.hpp"

namespace triplex {

/// The degenerate features (linear, planar) that a linear field of symmetric tensors misses in a
/// simplex, given by its N = 3 or 4 vertices: linear if the two lower eigenvalues stay apart,
/// planar if the two upper ones do. Bisects the simplex in doubles a few times where that helps.
/// Guarantee: proven by a filter, whatever the `Shift`; what is not in the set may be missed
/// as well. Source: proofs/symmetric_curve.md. \pre the tensors at the vertices are symmetric.
template <std::size_t N>
FeatureSet degenerate_features_missed(const SymmetricField& field,
                                      const std::array<VertexId, N>& vertices);

}  // namespace triplex

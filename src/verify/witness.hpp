// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "source_pieces.hpp"
#include "triplex/verify/audit.hpp"

namespace triplex::detail {

/// Looks for the exact answer in a cell of the input, made of these tets, where the two meshes
/// differ: on the edges of the tets, then along their medians, then across the pieces themselves;
/// of the curve, in the faces. The first of these places that speaks for one side alone decides.
std::pair<Ruling, std::optional<Witness>> find_witness(
    const TensorField& field, const FeatureTable& table, Feature feature, std::int64_t cell,
    std::span<const TetId> tets, const SourcePieces& reference, const SourcePieces& other);

}  // namespace triplex::detail

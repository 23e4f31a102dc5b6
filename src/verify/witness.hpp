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
/// differ: of the curve, in the faces of the tets; of a surface, on their edges, and where one side
/// has nothing, along their medians and across the pieces of the other. (Where both have something,
/// segments inside tell flat triangles from curved sheets rather than one topology from another.)
/// The first of these places that speaks for one side alone decides.
std::pair<Ruling, std::optional<Witness>> find_witness(
    const TensorField& field, const FeatureTable& table, const Difference& difference,
    std::span<const TetId> tets, const SourcePieces& reference, const SourcePieces& other);

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "triplex/arithmetic/instructions.hpp"
#include "triplex/certify/cell.hpp"

namespace triplex {

/// What the sweep says of one tet. If `settled`, the certificate of the tet is complete: `graph` is
/// certified, every other requested feature is excluded, and there is no spine. Otherwise nothing
/// is said and `certify_cell` decides.
struct SweptCell {
  FeatureSet graph = 0;
  bool settled = false;
};

/// Tets swept in one call, at most.
inline constexpr std::size_t kSweepBlock = 256;

/// The certificates of the easy tets, several at a time in the lanes of vector registers: those
/// that hold nothing, and those that hold sheets but no spine, where the filter's first answers and
/// a direction near the mean gradient suffice. On rung one only (the filter).
///
/// Only of the standard pages and the curve: \pre `requested` is a part of `kStandardSet`, and the
/// sectors are those of a book of six pages.
/// Guarantee: a settled tet carries the proofs that `certify_cell` asks for (proofs/sweep.md). Law:
/// the answer on a tet does not depend on the others, nor on the instructions.
/// \pre at most kSweepBlock cells, vertices ascending; as many results as cells.
void sweep_cells(const RefinableField& field, std::span<const std::array<VertexId, 4>> cells,
                 SectorTable sectors, FeatureSet requested, std::span<SweptCell> results,
                 SignStages& stages, Instructions instructions = best_instructions());

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "triplex/extract/extraction.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {

/// The open cells, gathered by tet of the input; the gravest obstacle names the reason. Sorted by
/// source cell.
std::vector<UnresolvedTet> unresolved_tets(const TensorField& input, const RefinedComplex& complex,
                                           const std::vector<Node>& nodes,
                                           const IdenticalSimplices& identical,
                                           const FeatureTable& table);

/// A tet of the input that is open as a whole, without features and reason.
UnresolvedTet whole_tet(const TensorField& input, TetId tet);

/// The open cells as a mesh, by tet of the input; if there are more than `most`, the largest.
OpenCells open_cells(const TensorField& input, const RefinedComplex& complex,
                     std::size_t most = kMostOpenCells);

}  // namespace triplex

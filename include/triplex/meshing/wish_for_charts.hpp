// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/feature/feature_table.hpp"
#include "triplex/meshing/tolerance.hpp"
#include "triplex/refine/refine.hpp"

namespace triplex {

/// Bisects, along their longest edges, certified leaves in which the distance of a mesh could not
/// be bounded: where a surface may pass through that is a graph in no direction that the meshing
/// finds, in the cell or on a face. Leaves that are smaller than the tolerance are good enough. The
/// table and the field must outlive it. Source: proofs/mesh_accuracy.md.
LeafWish wish_for_charts(const TensorField& input, const FeatureTable& table, Tolerance tolerance);

}  // namespace triplex

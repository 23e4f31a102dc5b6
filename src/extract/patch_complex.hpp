// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cell_patches.hpp"
#include "triplex/extract/patch_complex.hpp"

namespace triplex {

/// The patches of all active tets with their arcs, each arc once. Takes the refined field.
PatchComplex make_patch_complex(const TensorField& input, RefinedComplex complex,
                                const EdgeCrossings& crossings, const FaceSpinePoints& spine_points,
                                const std::vector<std::uint32_t>& active_leaves,
                                FeatureSet features);

}  // namespace triplex

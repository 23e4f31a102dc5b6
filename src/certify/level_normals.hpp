// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "triplex/bernstein/tensor_array.hpp"
#include "triplex/feature/level_set.hpp"

namespace triplex {

/// Normals of planes that may separate tensors from the convex set of a magnitude or isotropicity
/// surface, in doubles of few bits: witnesses, to be tested. Zero: none found.

/// From the mean of the tensors alone.
Tensor<double> normal_at_mean(const LevelSet& level, std::span<const Tensor<double>> tensors);
/// From the point of their hull that is nearest to the set.
Tensor<double> normal_at_nearest(const LevelSet& level, std::span<const Tensor<double>> tensors);

}  // namespace triplex

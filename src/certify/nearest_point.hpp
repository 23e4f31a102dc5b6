// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// The point of the hull of up to four tensors that is nearest to zero, in doubles: a witness.
/// For each subset the nearest point of its affine hull is the combination whose products with all
/// members are equal; the nearest point of the hull is the one with weights that are not negative
/// and no member on the near side.
Tensor<double> nearest_to_origin(std::span<const Tensor<double>> tensors);

}  // namespace triplex

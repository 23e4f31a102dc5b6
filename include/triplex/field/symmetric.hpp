// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Whether the tensors at all vertices of tets are symmetric. Guarantee: exact; false for a mesh
/// without tets.
bool is_symmetric(const TensorField& field);

/// Replaces every tensor by its symmetric part. The mean of two entries that differ is rounded
/// once, to the nearest double; what was symmetric stays as it is, to the bit. Guarantee:
/// `is_symmetric` holds afterwards, if there are tets.
void take_symmetric_part(TensorField& field);

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/field/tensor_field.hpp"

namespace triplex::oracle {

/// A field on one tet, whose vertices are numbered by their coordinates already.
inline TensorField on_one_tet(const std::array<Tensor<double>, 4>& tensors) {
  TensorField field;
  field.mesh.points = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  field.mesh.tets = {{VertexId(0), VertexId(3), VertexId(2), VertexId(1)}};
  field.tensors.assign(tensors.begin(), tensors.end());
  return field;
}

}  // namespace triplex::oracle

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// A vector at every vertex of a tet mesh, interpolated linearly in each tet: a velocity. The mesh
/// is what `check_input` asks for.
struct VectorField {
  TetMesh mesh;
  std::vector<Point> vectors;  ///< one per point
  std::string array_name;      ///< name of the point array they came from
};

}  // namespace triplex

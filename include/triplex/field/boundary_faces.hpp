// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Which faces of each tet lie on the boundary of the mesh: bit i for the face opposite to vertex
/// i. Shape: one byte per tet. \pre the mesh passed `check_input`.
std::vector<std::uint8_t> boundary_faces(const TetMesh& mesh);

}  // namespace triplex

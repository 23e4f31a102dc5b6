// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// Where there is no tet beyond a face.
inline constexpr TetId kNoTet{0xffffffff};

/// The tets beyond the four faces of each tet: entry i is across the face opposite to vertex i,
/// `kNoTet` on the boundary of the mesh. Shape: one entry per tet. \pre the mesh passed
/// `check_input`.
std::vector<std::array<TetId, 4>> face_neighbors(const TetMesh& mesh);

}  // namespace triplex

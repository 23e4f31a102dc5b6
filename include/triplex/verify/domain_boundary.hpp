// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "triplex/feature/feature_mesh.hpp"
#include "triplex/field/tensor_field.hpp"

namespace triplex {

/// The edges of a mesh that lie on the boundary of the domain, where a surface may end: pairs of
/// points, ascending, sorted. An edge counts if both its ends are within 1e-9, in barycentric
/// coordinates, of one boundary face of the cell of the input that its triangle lies in; in
/// doubles. \pre triangles lie in their source cells; the field passed `check_input`.
std::vector<std::array<std::uint32_t, 2>> edges_on_boundary(const TensorField& field,
                                                            const FeatureMesh& mesh);

}  // namespace triplex

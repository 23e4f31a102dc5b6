// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "triplex/verify/mesh_view.hpp"

namespace triplex {

/// One component as a mesh of its own; cells are in the order of the whole mesh.
struct MeshComponent {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> segments;
  Point place{};  ///< its lowest point: by x, then y, then z
};

/// The components of a mesh, joined through shared vertices, and the one that each cell is in.
struct MeshComponents {
  std::vector<MeshComponent> components;  ///< by `place`
  std::vector<std::uint32_t> of_triangle;
  std::vector<std::uint32_t> of_segment;
};

/// Takes a mesh apart. Points that no cell uses are in no component. The order of the components
/// does not depend on the numbering, unless two have the same place. Cost: near linear; copies the
/// mesh. \pre `check_mesh`.
MeshComponents mesh_components(const MeshView& mesh);

}  // namespace triplex

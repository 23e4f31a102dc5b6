// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/boundary_faces.hpp"

#include "half_faces.hpp"

namespace triplex {

std::vector<std::uint8_t> boundary_faces(const TetMesh& mesh) {
  const detail::HalfFaceTable table(mesh);
  std::vector<std::uint8_t> faces(mesh.tets.size(), 0);
  for (std::size_t v = 0; v < table.groups(); ++v) {
    const auto group = table.group(v);
    for (std::size_t i = 0; i < group.size(); ++i) {
      const bool has_twin = (i > 0 && group[i].same_face(group[i - 1])) ||
                            (i + 1 < group.size() && group[i].same_face(group[i + 1]));
      if (!has_twin) faces[group[i].tet()] |= static_cast<std::uint8_t>(1u << group[i].face());
    }
  }
  return faces;
}

}  // namespace triplex

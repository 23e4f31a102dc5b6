// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/domain_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "source_pieces.hpp"
#include "tet_chart.hpp"
#include "tets_of_cells.hpp"
#include "triplex/field/boundary_faces.hpp"

namespace triplex {

std::vector<std::array<std::uint32_t, 2>> edges_on_boundary(const TensorField& field,
                                                            const FeatureMesh& mesh) {
  const std::vector<std::uint8_t> boundary = boundary_faces(field.mesh);
  const detail::TetsOfCells tets(field);
  const detail::SourcePieces pieces(mesh);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const std::int64_t cell : pieces.cells())
    for (const TetId tet : tets.of(cell)) {
      if (boundary[index(tet)] == 0) continue;
      const detail::TetChart chart(field, tet);
      const auto on_faces = [&](std::uint32_t v) {
        const detail::Barycentric b = chart.of(mesh.points[v]);
        unsigned faces = 0;
        for (unsigned i = 0; i < 4; ++i) faces |= (std::fabs(b[i]) < detail::kOnSimplex) << i;
        return faces & boundary[index(tet)];
      };
      for (const std::uint32_t t : pieces.in(cell)) {
        if (t >= mesh.triangles.size()) continue;
        std::array<unsigned, 3> faces;
        for (std::size_t k = 0; k < 3; ++k) faces[k] = on_faces(mesh.triangles[t][k]);
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
          if (faces[k] & faces[(k + 1) % 3]) edges.push_back({std::min(a, b), std::max(a, b)});
        }
      }
    }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace triplex

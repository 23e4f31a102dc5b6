// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/verify/domain_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "source_pieces.hpp"
#include "tet_chart.hpp"
#include "triplex/field/boundary_faces.hpp"

namespace triplex {

DomainBoundary::DomainBoundary(const TensorField& field) : field_(&field) {
  const std::vector<std::uint8_t> faces = boundary_faces(field.mesh);
  for (std::size_t t = 0; t < faces.size(); ++t)
    if (faces[t] != 0) {
      const auto tet = static_cast<TetId>(t);
      tets_.push_back({field.source_cell(tet), tet, faces[t]});
    }
  std::ranges::stable_sort(tets_, {}, &BoundaryTet::source_cell);
}

std::vector<std::array<std::uint32_t, 2>> DomainBoundary::edges_of(const FeatureMesh& mesh) const {
  const detail::SourcePieces pieces(mesh);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const BoundaryTet& t : tets_) {
    const auto in_cell = pieces.in(t.source_cell);
    if (in_cell.empty()) continue;
    const detail::TetChart chart(*field_, t.tet);
    const auto on_faces = [&](std::uint32_t v) {
      const detail::Barycentric b = chart.of(mesh.points[v]);
      unsigned faces = 0;
      for (unsigned i = 0; i < 4; ++i) faces |= (std::fabs(b[i]) < detail::kOnSimplex) << i;
      return faces & t.faces;
    };
    for (const std::uint32_t n : in_cell) {
      if (n >= mesh.triangles.size()) continue;
      std::array<unsigned, 3> faces;
      for (std::size_t k = 0; k < 3; ++k) faces[k] = on_faces(mesh.triangles[n][k]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh.triangles[n][k], b = mesh.triangles[n][(k + 1) % 3];
        if (faces[k] & faces[(k + 1) % 3]) edges.push_back({std::min(a, b), std::max(a, b)});
      }
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace triplex

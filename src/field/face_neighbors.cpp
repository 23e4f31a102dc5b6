// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/field/face_neighbors.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "half_faces.hpp"

namespace triplex {

std::vector<std::array<TetId, 4>> face_neighbors(const TetMesh& mesh) {
  const detail::HalfFaceTable table(mesh);
  std::vector<std::array<TetId, 4>> neighbors(mesh.tets.size(), {kNoTet, kNoTet, kNoTet, kNoTet});
  // Every half face is written by the one group that holds it, so no two threads write one entry.
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, table.groups(), 1024),
                    [&](const auto& range) {
                      for (std::size_t v = range.begin(); v < range.end(); ++v) {
                        const auto group = table.group(v);
                        for (std::size_t i = 1; i < group.size(); ++i) {
                          const auto &a = group[i - 1], &b = group[i];
                          if (!a.same_face(b)) continue;
                          neighbors[a.tet()][a.face()] = TetId{static_cast<std::uint32_t>(b.tet())};
                          neighbors[b.tet()][b.face()] = TetId{static_cast<std::uint32_t>(a.tet())};
                        }
                      }
                    });
  return neighbors;
}

}  // namespace triplex

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_parts.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "spine_in_tet.hpp"
#include "triplex/topology/disjoint_sets.hpp"

namespace triplex::detail {

PatchCut cut_of_patch(const TensorField& field, const CutTet& tet, const QuadricPatch& patch,
                      const SampledFaces& faces, const std::vector<TetLoop>& loops, int samples) {
  PatchCut cut;
  for (const std::uint8_t l : patch.loops) faces.sides_of(tet, tet.cut.loops[l], cut.sides);
  for (std::uint32_t n = 0; n < cut.sides.size(); ++n)
    if (cut.sides[n] == 0) cut.ends.push_back(n);
  if (cut.ends.size() == 2)
    cut.path = spine_path_approx(field, tet.vertices, loops[0][cut.ends[0]], loops[0][cut.ends[1]],
                                 samples);
  return cut;
}

bool label_parts(const PatchCut& cut, PatchMesh& mesh) {
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  std::set<Edge> spine;
  const std::vector<std::uint32_t> chain = cut.chain();
  for (std::size_t k = 0; k + 1 < chain.size(); ++k)
    spine.insert(std::minmax(chain[k], chain[k + 1]));
  DisjointSets regions(mesh.triangles.size());
  std::map<Edge, std::uint32_t> first;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge e = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      if (spine.contains(e)) continue;
      const auto [at, fresh] = first.try_emplace(e, t);
      if (!fresh) regions.unite(at->second, t);
    }
  std::map<std::uint32_t, std::int8_t> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::int8_t& side = sides[regions.find(t)];
    for (const std::uint32_t v : mesh.triangles[t]) {
      const std::int8_t own = v < cut.sides.size() ? cut.sides[v] : std::int8_t{0};
      if (own == 0) continue;
      if (side == -own) return false;
      side = own;
    }
  }
  if (sides.size() != (chain.empty() ? 1u : 2u)) return false;
  if (std::ranges::any_of(sides, [](const auto& s) { return s.second == 0; })) return false;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    mesh.parts.push_back(sides[regions.find(t)]);
  return true;
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <random>

#include "triplex/extract/extraction.hpp"
#include "triplex/field/generators.hpp"

namespace triplex::test {

/// The same field with points and tets listed in another order (orientations kept).
inline TensorField relabelled(const TensorField& field, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> order(field.mesh.points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::shuffle(order.begin(), order.end(), random);
  TensorField r;
  r.mesh.points.resize(order.size());
  r.tensors.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    r.mesh.points[order[i]] = field.mesh.points[i];
    r.tensors[order[i]] = field.tensors[i];
  }
  for (auto tet : field.mesh.tets) {
    for (VertexId& v : tet) v = VertexId(order[index(v)]);
    std::rotate(tet.begin(), tet.begin() + 1, tet.begin() + 3);  // an even permutation
    r.mesh.tets.push_back(tet);
  }
  std::shuffle(r.mesh.tets.begin(), r.mesh.tets.end(), random);
  return r;
}

/// The same mesh with every tensor mapped.
template <class Map>
TensorField mapped(TensorField field, const Map& map) {
  for (auto& t : field.tensors) t = map(t);
  return field;
}

inline Tensor<double> negated(Tensor<double> t) {
  for (double& x : t) x = -x;
  return t;
}
/// The standard feature of -T where T has this one: linear and planar are exchanged.
inline Feature of_negative(Feature f) {
  switch (f) {
    case Feature::DegenerateLinear:
      return Feature::DegeneratePlanar;
    case Feature::DegeneratePlanar:
      return Feature::DegenerateLinear;
    case Feature::BalancedLinear:
      return Feature::BalancedPlanar;
    case Feature::BalancedPlanar:
      return Feature::BalancedLinear;
    default:
      return f;
  }
}
inline Tensor<double> transposed(const Tensor<double>& t) {
  return {t[0], t[3], t[6], t[1], t[4], t[7], t[2], t[5], t[8]};
}

inline const FeatureMesh& mesh_of(const Extraction& e, Feature f) {
  return e.features[static_cast<std::size_t>(f)];
}
/// Whether the feature is certified in every tet.
inline bool certified(const Extraction& e, Feature f) {
  return std::none_of(e.unresolved.begin(), e.unresolved.end(),
                      [&](const UnresolvedTet& t) { return t.features & bit(f); });
}

/// The triangles as unordered sets of points, sorted: the mesh as a geometric object.
inline std::vector<std::array<Point, 3>> geometry(const FeatureMesh& mesh) {
  std::vector<std::array<Point, 3>> cells;
  for (const auto& t : mesh.triangles)
    cells.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  for (const auto& s : mesh.segments)
    cells.push_back({mesh.points[s[0]], mesh.points[s[1]], mesh.points[s[1]]});
  for (auto& c : cells) std::sort(c.begin(), c.end());
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace triplex::test

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_mesh.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace triplex::detail {
namespace {

/// Whether doubles show that all Bernstein coefficients have one sign: then there is no zero.
bool is_empty_by_filter(const TensorField& field, const QuadricSurface& surface,
                        const std::array<VertexId, 4>& v) {
  double magnitude = 0;
  for (const VertexId vertex : v)
    for (const double x : field.tensors[index(vertex)])
      magnitude = std::fmax(magnitude, std::fabs(x));
  const double error = quadric_polar_error(surface, magnitude);
  bool positive = true, negative = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) {
      const double c =
          quadric_polar(surface, field.tensors[index(v[i])], field.tensors[index(v[j])]);
      positive = positive && c > error;
      negative = negative && c < -error;
      if (!positive && !negative) return false;
    }
  return true;
}

/// The vertices of a tet in ascending order; whether that reverses its orientation.
bool sort_vertices(std::array<VertexId, 4>& v) {
  bool odd = false;
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t j = i; j > 0 && v[j] < v[j - 1]; --j) {
      std::swap(v[j], v[j - 1]);
      odd = !odd;
    }
  return odd;
}

std::vector<CutTet> candidates(const TensorField& field, const QuadricSurface& surface) {
  const auto& all = field.mesh.tets;
  std::vector<std::uint8_t> keep(all.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, all.size(), 1024), [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t)
      keep[t] = !is_empty_by_filter(field, surface, all[t]);
  });
  std::vector<CutTet> tets;
  tets.reserve(static_cast<std::size_t>(std::ranges::count(keep, 1)));
  for (std::size_t t = 0; t < all.size(); ++t) {
    if (!keep[t]) continue;
    CutTet& tet = tets.emplace_back();
    tet.tet = TetId(static_cast<std::uint32_t>(t));
    tet.vertices = all[t];
    tet.flipped = sort_vertices(tet.vertices);
  }
  return tets;
}

using Key = std::uint64_t;
Key key_of(std::uint32_t a, VertexId b) { return Key{a} << 32 | index(b); }

/// Sorts the keys, which come `n` to a tet, and gives each tet the places of its own.
template <std::size_t N, class KeysOf, class Places>
std::vector<Key> number(std::vector<CutTet>& tets, const KeysOf& keys_of, const Places& places) {
  std::vector<Key> keys(N * tets.size());
  tbb::parallel_for(std::size_t{0}, tets.size(), [&](std::size_t t) {
    const std::array<Key, N> own = keys_of(tets[t]);
    std::ranges::copy(own, keys.begin() + static_cast<std::ptrdiff_t>(N * t));
  });
  tbb::parallel_sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  tbb::parallel_for(std::size_t{0}, tets.size(), [&](std::size_t t) {
    const std::array<Key, N> own = keys_of(tets[t]);
    for (std::size_t k = 0; k < N; ++k)
      places(tets[t])[k] =
          static_cast<std::uint32_t>(std::ranges::lower_bound(keys, own[k]) - keys.begin());
  });
  return keys;
}

void cut_edges(const TensorField& field, const QuadricSurface& surface, CutMesh& mesh) {
  const auto keys = number<6>(
      mesh.tets,
      [](const CutTet& t) {
        std::array<Key, 6> k;
        for (std::size_t e = 0; e < 6; ++e)
          k[e] = key_of(static_cast<std::uint32_t>(t.vertices[kTetEdges[e][0]]),
                        t.vertices[kTetEdges[e][1]]);
        return k;
      },
      [](CutTet & t) -> auto& { return t.edges; });
  mesh.edges.resize(keys.size());
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t e) {
    CutMeshEdge& edge = mesh.edges[e];
    edge.vertices = {VertexId(static_cast<std::uint32_t>(keys[e] >> 32)),
                     VertexId(static_cast<std::uint32_t>(keys[e]))};
    edge.cut = cut_edge(SimplexForm<2>(surface, field, edge.vertices));
  });
}

// A face is named by its first edge and its last vertex.
void cut_faces(const TensorField& field, const QuadricSurface& surface, CutMesh& mesh) {
  const auto keys = number<4>(
      mesh.tets,
      [](const CutTet& t) {
        std::array<Key, 4> k;
        for (std::size_t f = 0; f < 4; ++f)
          k[f] = key_of(t.edges[kEdgesOfFaces[f][0]], t.vertices[kTetFaces[f][2]]);
        return k;
      },
      [](CutTet & t) -> auto& { return t.faces; });
  mesh.faces.resize(keys.size());
  for (const CutTet& t : mesh.tets)
    for (std::size_t f = 0; f < 4; ++f)
      for (std::size_t k = 0; k < 3; ++k)
        mesh.faces[t.faces[f]].edges[k] = t.edges[kEdgesOfFaces[f][k]];
  tbb::parallel_for(std::size_t{0}, keys.size(), [&](std::size_t f) {
    CutMeshFace& face = mesh.faces[f];
    const auto& first = mesh.edges[face.edges[0]].vertices;
    face.vertices = {first[0], first[1], mesh.edges[face.edges[1]].vertices[1]};
    face.cut =
        cut_face(SimplexForm<3>(surface, field, face.vertices), cuts_of<3>(mesh.edges, face.edges));
  });
}

void cut_tets(const TensorField& field, const QuadricSurface& surface, CutMesh& mesh) {
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(), [&](std::size_t t) {
    CutTet& tet = mesh.tets[t];
    std::array<FaceCut, 4> faces;
    for (std::size_t f = 0; f < 4; ++f) faces[f] = mesh.faces[tet.faces[f]].cut;
    const SimplexForm<4> form(surface, field, tet.vertices);
    tet.cut = cut_tet(form, cuts_of<6>(mesh.edges, tet.edges), faces);
    if (tet.reported()) tet.type = quadric_type(form);
  });
}

}  // namespace

CutMesh cut_mesh(const TensorField& field, const QuadricSurface& surface) {
  CutMesh mesh;
  mesh.tets = candidates(field, surface);
  cut_edges(field, surface, mesh);
  cut_faces(field, surface, mesh);
  cut_tets(field, surface, mesh);
  return mesh;
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spine_cut.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "spine_in_tet.hpp"

namespace triplex::detail {
namespace {

void look_at_tets(const TensorField& field, const CutMesh& mesh, SpineCut& cut) {
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(), [&](std::size_t t) {
    if (mesh.tets[t].cut.patches.empty()) return;
    const Sign s = sign_of_q(field, mesh.tets[t].vertices);
    cut.tets[t] = s == Sign::Positive   ? TetSplit::Linear
                  : s == Sign::Negative ? TetSplit::Planar
                                        : TetSplit::Open;
  });
}

/// The edges or faces of the tets that are still open.
template <class PlacesOf>
std::vector<std::uint32_t> of_open_tets(const CutMesh& mesh, const SpineCut& cut,
                                        const PlacesOf& places_of) {
  std::vector<std::uint32_t> r;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (cut.tets[t] == TetSplit::Open)
      r.insert(r.end(), places_of(mesh.tets[t]).begin(), places_of(mesh.tets[t]).end());
  std::ranges::sort(r);
  r.erase(std::unique(r.begin(), r.end()), r.end());
  return r;
}

void look_at_edges(const TensorField& field, const CutMesh& mesh, SpineCut& cut) {
  const auto edges = of_open_tets(
      mesh, cut, [](const CutTet& t) -> auto& { return t.edges; });
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t n) {
    const CutMeshEdge& edge = mesh.edges[edges[n]];
    if (edge.cut.roots > 0) cut.edges[edges[n]] = spine_signs(field, edge.vertices, edge.cut);
  });
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (cut.tets[t] != TetSplit::Open) continue;
    for (const std::uint32_t e : mesh.tets[t].edges)
      for (std::size_t k = 0; k < mesh.edges[e].cut.roots; ++k)
        if (cut.edges[e][k] == Sign::Zero) cut.tets[t] = TetSplit::Contact;
  }
}

void look_at_faces(const TensorField& field, const CutMesh& mesh, SpineCut& cut) {
  const auto faces = of_open_tets(
      mesh, cut, [](const CutTet& t) -> auto& { return t.faces; });
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t n) {
    const CutMeshFace& face = mesh.faces[faces[n]];
    std::array<std::array<Sign, 2>, 3> signs;
    for (std::size_t k = 0; k < 3; ++k) signs[k] = cut.edges[face.edges[k]];
    cut.faces[faces[n]] = spine_on_face(field, face, cuts_of<3>(mesh.edges, face.edges), signs);
  });
}

/// The curve's points on the faces of a tet; nothing if they are not known.
std::optional<std::vector<TetPoint>> ends_in(const CutTet& tet, const SpineCut& cut) {
  std::vector<TetPoint> ends;
  for (std::size_t f = 0; f < 4; ++f) {
    const FaceSpine& face = cut.faces[tet.faces[f]];
    if (!face.known) return std::nullopt;
    for (const SpinePoint& point : face.points) {
      TetPoint& x = ends.emplace_back();
      x = {};
      for (std::size_t k = 0; k < 3; ++k) x[static_cast<std::size_t>(kTetFaces[f][k])] = point.x[k];
    }
  }
  return ends;
}

/// Whether no patch has more than two ends of the curve, those of one loop have two only if they
/// are discs, and every patch has a loop with roots, which tells its side.
bool is_simple(const CutTet& tet, const SpineCut& cut) {
  return std::ranges::all_of(tet.cut.patches, [&](const QuadricPatch& patch) {
    if (patch.loops.empty()) return false;
    std::size_t ends = 0;
    for (const std::uint8_t l : patch.loops) {
      const QuadricLoop& loop = tet.cut.loops[l];
      if (loop.is_oval()) return false;
      for (const LoopArc& arc : loop.arcs)
        ends += static_cast<std::size_t>(
            std::ranges::count(cut.faces[tet.faces[arc.face]].points, arc.arc, &SpinePoint::arc));
    }
    return ends == 0 || (ends == 2 && patch.loops.size() == 1);
  });
}

void look_inside(const TensorField& field, const CutMesh& mesh, SpineCut& cut) {
  tbb::parallel_for(std::size_t{0}, mesh.tets.size(), [&](std::size_t t) {
    if (cut.tets[t] != TetSplit::Open) return;
    const CutTet& tet = mesh.tets[t];
    auto ends = ends_in(tet, cut);
    if (!ends || !is_simple(tet, cut)) return;
    if (ends->empty()) ends->push_back({0.25, 0.25, 0.25, 0.25});
    if (grows_along_spine(field, tet.vertices, height_along_spine(field, tet.vertices, *ends)))
      cut.tets[t] = TetSplit::Proven;
  });
}

}  // namespace

SpineCut cut_by_spine(const TensorField& field, const CutMesh& mesh) {
  SpineCut cut;
  cut.edges.resize(mesh.edges.size());
  cut.faces.resize(mesh.faces.size());
  cut.tets.resize(mesh.tets.size(), TetSplit::Whole);
  look_at_tets(field, mesh, cut);
  look_at_edges(field, mesh, cut);
  look_at_faces(field, mesh, cut);
  look_inside(field, mesh, cut);
  return cut;
}

}  // namespace triplex::detail

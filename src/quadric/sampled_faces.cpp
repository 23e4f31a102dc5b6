// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_faces.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace triplex::detail {
namespace {

constexpr std::uint16_t kMaxRate = 1024;

FacePoint on_face_edge(const CutMesh& mesh, const CutMeshFace& face, EdgeRoot root) {
  const double t = mesh.edges[face.edges[root.edge]].cut.place[root.root];
  FacePoint x{};
  x[kFaceEdges[root.edge][0]] = 1 - t;
  x[kFaceEdges[root.edge][1]] = t;
  return x;
}

}  // namespace

SampledFaces::SampledFaces(const TensorField& field, const QuadricSurface& surface,
                           const CutMesh& mesh, int samples)
    : field_(&field),
      surface_(surface),
      mesh_(&mesh),
      rate_(mesh.faces.size(), static_cast<std::uint16_t>(std::clamp(samples, 2, int{kMaxRate}))),
      changed_(mesh.faces.size(), 1),
      points_(mesh.faces.size()),
      first_of_edge_(mesh.edges.size() + 1),
      first_of_face_(mesh.faces.size() + 1) {
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    first_of_edge_[e + 1] = first_of_edge_[e] + mesh.edges[e].cut.roots;
  tbb::parallel_for(std::size_t{0}, mesh.faces.size(),
                    [&](std::size_t f) { sample(static_cast<std::uint32_t>(f)); });
  renumber();
}

void SampledFaces::sample(std::uint32_t f) {
  const CutMeshFace& face = mesh_->faces[f];
  if (!face.cut.transverse || (face.cut.arcs == 0 && !face.cut.oval)) return;
  const auto form = form_approx(SimplexForm<3>(surface_, *field_, face.vertices));
  const int rate = rate_[f];
  points_[f].clear();
  if (face.cut.oval) points_[f] = sample_oval_approx(form, 4 * rate);
  for (int n = 0; n < face.cut.arcs; ++n) {
    const auto& [from, to] = face.cut.ends[static_cast<std::size_t>(n)];
    const auto arc = sample_arc_approx(form, on_face_edge(*mesh_, face, from),
                                       on_face_edge(*mesh_, face, to), rate);
    points_[f].insert(points_[f].end(), arc.begin(), arc.end());
  }
}

void SampledFaces::renumber() {
  first_of_face_[0] = first_of_edge_.back();
  for (std::size_t f = 0; f < points_.size(); ++f)
    first_of_face_[f + 1] = first_of_face_[f] + static_cast<std::uint32_t>(points_[f].size());
}

void SampledFaces::refine(const std::vector<std::uint32_t>& tets) {
  std::ranges::fill(changed_, std::uint8_t{0});
  for (const std::uint32_t t : tets)
    for (const std::uint32_t f : mesh_->tets[t].faces) {
      if (changed_[f] || rate_[f] > kMaxRate / 2) continue;
      changed_[f] = 1;
      rate_[f] = static_cast<std::uint16_t>(2 * rate_[f]);
      sample(f);
    }
  renumber();
}

std::vector<std::uint32_t> SampledFaces::changed_tets() const {
  std::vector<std::uint32_t> tets;
  for (std::uint32_t t = 0; t < mesh_->tets.size(); ++t)
    if (std::ranges::any_of(mesh_->tets[t].faces, [&](std::uint32_t f) { return changed_[f]; }))
      tets.push_back(t);
  return tets;
}

template <class Visit>
void SampledFaces::walk(const CutTet& tet, const QuadricLoop& loop, const Visit& visit) const {
  const auto visit_face_point = [&](int f, std::uint32_t n) {
    const std::uint32_t face = tet.faces[static_cast<std::size_t>(f)];
    TetPoint x{};
    for (std::size_t k = 0; k < 3; ++k)
      x[static_cast<std::size_t>(kTetFaces[static_cast<std::size_t>(f)][k])] = points_[face][n][k];
    visit(first_of_face_[face] + n, x);
  };
  if (loop.is_oval()) {
    const auto n = static_cast<std::uint32_t>(points_[tet.faces[loop.oval_face]].size());
    for (std::uint32_t k = 0; k < n; ++k) visit_face_point(loop.oval_face, k);
    return;
  }
  for (const LoopArc& arc : loop.arcs) {
    const std::uint32_t edge = tet.edges[arc.start.edge];
    const double t = mesh_->edges[edge].cut.place[arc.start.root];
    TetPoint x{};
    x[static_cast<std::size_t>(kTetEdges[arc.start.edge][0])] = 1 - t;
    x[static_cast<std::size_t>(kTetEdges[arc.start.edge][1])] = t;
    visit(first_of_edge_[edge] + arc.start.root, x);
    const std::uint32_t inner = rate_[tet.faces[arc.face]] - 1u;
    for (std::uint32_t k = 0; k < inner; ++k)
      visit_face_point(arc.face, arc.arc * inner + (arc.reversed ? inner - 1 - k : k));
  }
}

TetLoop SampledFaces::points_of(const CutTet& tet, const QuadricLoop& loop) const {
  TetLoop points;
  walk(tet, loop, [&](std::uint32_t, const TetPoint& x) { points.push_back(x); });
  return points;
}

void SampledFaces::numbers_of(const CutTet& tet, const QuadricLoop& loop,
                              std::vector<std::uint32_t>& to) const {
  walk(tet, loop, [&](std::uint32_t n, const TetPoint&) { to.push_back(n); });
}

void SampledFaces::place(FeatureMesh& mesh, bool with_q) const {
  mesh.points.resize(size());
  mesh.q.resize(with_q ? size() : 0);
  tbb::parallel_for(std::size_t{0}, mesh_->edges.size(), [&](std::size_t e) {
    const CutMeshEdge& edge = mesh_->edges[e];
    for (std::size_t k = 0; k < edge.cut.roots; ++k) {
      const std::array<double, 2> x = {1 - edge.cut.place[k], edge.cut.place[k]};
      const std::size_t n = first_of_edge_[e] + k;
      mesh.points[n] = combination(*field_, edge.vertices, x);
      if (with_q) mesh.q[n] = determinant_approx(*field_, edge.vertices, x);
    }
  });
  tbb::parallel_for(std::size_t{0}, mesh_->faces.size(), [&](std::size_t f) {
    const auto& vertices = mesh_->faces[f].vertices;
    for (std::size_t k = 0; k < points_[f].size(); ++k) {
      const std::size_t n = first_of_face_[f] + k;
      mesh.points[n] = combination(*field_, vertices, points_[f][k]);
      if (with_q) mesh.q[n] = determinant_approx(*field_, vertices, points_[f][k]);
    }
  });
}

}  // namespace triplex::detail

// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampled_faces.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// A number with the sign of a side, where that is known.
double with_side(double x, std::int8_t side) {
  if (side == 0) return x;
  return std::copysign(std::fmax(std::fabs(x), std::numeric_limits<double>::min()), side);
}

}  // namespace

SampledFaces::SampledFaces(const TensorField& field, const QuadricSurface& surface,
                           const CutMesh& mesh, const SpineCut& spine, int samples)
    : field_(&field),
      surface_(surface),
      mesh_(&mesh),
      spine_(&spine),
      rate_(mesh.faces.size(), static_cast<std::uint16_t>(std::clamp(samples, 2, int{kMaxRate}))),
      changed_(mesh.faces.size(), 1),
      points_(mesh.faces.size()),
      sides_(mesh.faces.size()),
      first_of_arc_(mesh.faces.size()),
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
  sides_[f].clear();
  for (int n = 0; n < face.cut.arcs; ++n) {
    first_of_arc_[f][static_cast<std::size_t>(n)] = static_cast<std::uint16_t>(points_[f].size());
    sample_arc(f, n, form);
    first_of_arc_[f][static_cast<std::size_t>(n) + 1] =
        static_cast<std::uint16_t>(points_[f].size());
  }
}

// From the begin to the first point of the curve, to the next, and to the end, each with its share
// of the samples; between two points of the curve there is one at least, to have a side there.
void SampledFaces::sample_arc(std::uint32_t f, int arc, const QuadraticForm<double, 3>& form) {
  const CutMeshFace& face = mesh_->faces[f];
  const auto& [from, to] = face.cut.ends[static_cast<std::size_t>(arc)];
  const FaceSpine* spine =
      spine_->faces.empty() || !spine_->faces[f].known ? nullptr : &spine_->faces[f];
  std::int8_t side = 0;
  if (spine != nullptr)
    side = static_cast<std::int8_t>(spine_->edges[face.edges[from.edge]][from.root]);
  FacePoint begin = on_face_edge(*mesh_, face, from);
  double place = 0;
  const auto lead = [&](const FacePoint& end, double next, int least) {
    const int n = std::max(least, static_cast<int>(std::lround((next - place) * rate_[f])));
    const auto samples = sample_arc_approx(form, begin, end, n);
    points_[f].insert(points_[f].end(), samples.begin(), samples.end());
    if (spine != nullptr) sides_[f].insert(sides_[f].end(), samples.size(), side);
    begin = end;
    place = next;
  };
  bool first = true;
  if (spine != nullptr)
    for (const SpinePoint& zero : spine->points) {
      if (zero.arc != arc) continue;
      lead(zero.x, zero.place, first ? 1 : 2);
      points_[f].push_back(zero.x);
      sides_[f].push_back(0);
      side = static_cast<std::int8_t>(-side);
      first = false;
    }
  lead(on_face_edge(*mesh_, face, to), 1, 1);
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
    visit(first_of_face_[face] + n, x, sides_[face].empty() ? std::int8_t{0} : sides_[face][n]);
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
    visit(first_of_edge_[edge] + arc.start.root, x, side_of(edge, arc.start.root));
    const auto& first = first_of_arc_[tet.faces[arc.face]];
    const std::uint32_t begin = first[arc.arc], inner = first[arc.arc + 1u] - begin;
    for (std::uint32_t k = 0; k < inner; ++k)
      visit_face_point(arc.face, begin + (arc.reversed ? inner - 1 - k : k));
  }
}

TetLoop SampledFaces::points_of(const CutTet& tet, const QuadricLoop& loop) const {
  TetLoop points;
  walk(tet, loop, [&](std::uint32_t, const TetPoint& x, std::int8_t) { points.push_back(x); });
  return points;
}

void SampledFaces::sides_of(const CutTet& tet, const QuadricLoop& loop,
                            std::vector<std::int8_t>& to) const {
  walk(tet, loop, [&](std::uint32_t, const TetPoint&, std::int8_t side) { to.push_back(side); });
}

std::int8_t SampledFaces::side_of(std::uint32_t edge, std::size_t root) const {
  return spine_->edges.empty() ? std::int8_t{0}
                               : static_cast<std::int8_t>(spine_->edges[edge][root]);
}

void SampledFaces::numbers_of(const CutTet& tet, const QuadricLoop& loop,
                              std::vector<std::uint32_t>& to) const {
  walk(tet, loop, [&](std::uint32_t n, const TetPoint&, std::int8_t) { to.push_back(n); });
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
      if (!with_q) continue;
      mesh.q[n] = with_side(determinant_approx(*field_, edge.vertices, x), side_of(e, k));
    }
  });
  tbb::parallel_for(std::size_t{0}, mesh_->faces.size(), [&](std::size_t f) {
    const auto& vertices = mesh_->faces[f].vertices;
    for (std::size_t k = 0; k < points_[f].size(); ++k) {
      const std::size_t n = first_of_face_[f] + k;
      mesh.points[n] = combination(*field_, vertices, points_[f][k]);
      if (!with_q) continue;
      mesh.q[n] = determinant_approx(*field_, vertices, points_[f][k]);
      if (sides_[f].empty()) continue;
      mesh.q[n] = sides_[f][k] == 0 ? 0 : with_side(mesh.q[n], sides_[f][k]);
    }
  });
}

}  // namespace triplex::detail

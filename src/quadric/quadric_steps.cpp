// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/quadric/quadric_steps.hpp"

#include <stdexcept>

#include "tet_patches.hpp"

namespace triplex {
namespace {

using detail::TetLoop;
using detail::TetPoint;

TensorField only(const TensorField& field, TetId tet) {
  TensorField one;
  one.mesh.tets.emplace_back();
  for (std::uint32_t i = 0; i < 4; ++i) {
    const VertexId v = field.mesh.tets[index(tet)][i];
    one.mesh.points.push_back(field.mesh.points[index(v)]);
    one.tensors.push_back(field.tensors[index(v)]);
    one.mesh.tets[0][i] = VertexId{i};
  }
  return one;
}

QuadricPatchSteps steps_of(const TensorField& field, const detail::CutTet& tet,
                           const detail::PatchChart& chart, const std::vector<TetLoop>& loops,
                           const detail::PatchMesh& mesh) {
  QuadricPatchSteps steps;
  const auto add = [&](const TetLoop& points) {
    for (const TetPoint& x : points)
      steps.points.push_back(detail::combination(field, tet.vertices, x));
    for (const detail::PlanePoint& p : chart.flattened(points)) steps.domain.push_back(p);
  };
  for (const TetLoop& loop : loops) {
    const auto first = static_cast<std::ptrdiff_t>(steps.points.size());
    add(loop);
    steps.curves.emplace_back(steps.points.begin() + first, steps.points.end());
  }
  add(mesh.inner);
  steps.triangles = mesh.triangles;
  return steps;
}

}  // namespace

QuadricSteps quadric_steps(const TensorField& field, TetId tet, const FeatureRow& feature,
                           int samples) {
  const auto surface = quadric_of(feature);
  if (!surface) throw std::invalid_argument("the feature " + feature.name + " is on no quadric");
  const TensorField one = only(field, tet);
  const SimplexForm<4> form(*surface, one, {VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}});
  QuadricSteps steps;
  steps.type = quadric_type(form);
  const detail::CutMesh mesh = detail::cut_mesh(one, *surface);
  if (mesh.tets.empty()) return steps;  // nothing in it
  const detail::CutTet& cut = mesh.tets[0];
  steps.transverse = cut.cut.transverse;
  if (!steps.transverse) return steps;
  const auto edges = detail::cuts_of<6>(mesh.edges, cut.edges);
  const auto approx = form_approx(form);
  const detail::SpineCut no_curve;
  const detail::SampledFaces faces(one, *surface, mesh, no_curve, samples);
  for (const std::uint8_t n : detail::patches_of_feature(form, edges, cut.cut)) {
    const QuadricPatch& patch = cut.cut.patches[n];
    std::vector<TetLoop> loops;
    for (const std::uint8_t l : patch.loops)
      loops.push_back(faces.points_of(cut, cut.cut.loops[l]));
    if (loops.empty()) continue;
    const auto chart = detail::parameter_plane(approx, edges, cut.cut, patch, loops);
    if (!chart) continue;
    if (const auto triangles = detail::triangulate_patch(*chart, loops))
      steps.patches.push_back(steps_of(one, cut, *chart, loops, *triangles));
  }
  return steps;
}

}  // namespace triplex

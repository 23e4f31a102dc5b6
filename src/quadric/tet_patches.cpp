// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tet_patches.hpp"

#include <algorithm>
#include <cmath>

#include "border_regions.hpp"
#include "patch_parts.hpp"

namespace triplex::detail {
namespace {

/// Where the holes of a patch are: a place of the convex set beside each loop.
std::vector<TetPoint> holes_of(const QuadraticForm<double, 4>& form,
                               const std::array<EdgeCut, 6>& edges, const TetCut& cut,
                               const QuadricPatch& patch) {
  std::vector<TetPoint> holes;
  const auto add = [&](const TetPoint& x) {
    const double sum = x[0] + x[1] + x[2] + x[3];
    if (sum > 0) holes.push_back({x[0] / sum, x[1] / sum, x[2] / sum, x[3] / sum});
  };
  for (const std::uint8_t l : patch.loops) {
    const QuadricLoop& loop = cut.loops[l];
    if (loop.is_oval()) {
      add(place_in_cone(form, edges, loop, cut.cone));
      continue;
    }
    for (const LoopArc& arc : loop.arcs) {
      QuadricLoop one;
      one.arcs = {arc};
      add(place_in_cone(form, edges, one, cut.cone));
    }
  }
  return holes;
}

std::optional<PatchMesh> mesh_patch(const QuadraticForm<double, 4>& form,
                                    const std::array<EdgeCut, 6>& edges, const TetCut& cut,
                                    const QuadricPatch& patch, const std::vector<TetLoop>& loops,
                                    const PatchCut& arc) {
  if (const auto chart = graph_chart(form, loops))
    if (auto mesh = triangulate_patch(*chart, loops, arc)) return mesh;
  const auto chart = parameter_plane(form, edges, cut, patch, loops);
  return chart ? triangulate_patch(*chart, loops, arc) : std::nullopt;
}

/// The side of the whole tet, if it has one.
std::int8_t side_of(TetSplit split) {
  return split == TetSplit::Linear   ? std::int8_t{1}
         : split == TetSplit::Planar ? std::int8_t{-1}
                                     : std::int8_t{0};
}

/// Less than charts in doubles can tell apart, as at a vertex that the surface misses by rounding.
bool is_tiny(const TetLoop& loop) {
  constexpr double kTiny = 0x1p-30;
  return std::ranges::all_of(loop, [&](const TetPoint& x) {
    double distance = 0;
    for (std::size_t i = 0; i < 4; ++i)
      distance = std::fmax(distance, std::fabs(x[i] - loop.front()[i]));
    return distance < kTiny;
  });
}

}  // namespace

std::unique_ptr<PatchChart> parameter_plane(const QuadraticForm<double, 4>& form,
                                            const std::array<EdgeCut, 6>& edges, const TetCut& cut,
                                            const QuadricPatch& patch,
                                            const std::vector<TetLoop>& loops) {
  return patch.kind == QuadricPatch::Kind::Convex
             ? convex_chart(form, cut.cone, loops, holes_of(form, edges, cut, patch))
             : ruled_chart(form, loops);
}

// On the boundary of a convex cone in which F = tr^2 - 3 eta^2 |T|^2 > 0 the trace vanishes at the
// apex only, so it has the sign that it has anywhere in that cone.
std::vector<std::uint8_t> patches_of_feature(const SimplexForm<4>& form,
                                             const std::array<EdgeCut, 6>& edges,
                                             const TetCut& cut) {
  std::vector<std::uint8_t> chosen;
  const bool all = form.surface().kind != QuadricSurface::Kind::Isotropicity;
  const Sign wanted = form.surface().value > 0 ? Sign::Positive : Sign::Negative;
  for (std::size_t n = 0; n < cut.patches.size(); ++n) {
    if (!all) {
      const auto& f = form.exact();
      std::array<Exact, 4> place;
      if (cut.patches[n].loops.empty()) {
        place = center(adjugate(f));
        const Exact first = place[0];
        for (Exact& x : place) x = first * x;
      } else {
        place = place_in_cone(f, edges, cut.loops[cut.patches[n].loops[0]], cut.cone);
      }
      Exact trace(0);
      for (std::size_t v = 0; v < 4; ++v) {
        const Tensor<double>& t = form.field().tensors[index(form.vertices()[v])];
        trace = trace + place[v] * (Exact(t[0]) + Exact(t[4]) + Exact(t[8]));
      }
      if (sign(trace) != wanted) continue;
    }
    chosen.push_back(static_cast<std::uint8_t>(n));
  }
  return chosen;
}

void mesh_patches(const SimplexForm<4>& form, const CutMesh& mesh, const SampledFaces& faces,
                  const CutTet& tet, TetSplit split, int samples, bool last, TetPatches& patches) {
  const auto approx = form_approx(form);
  const auto edges = cuts_of<6>(mesh.edges, tet.edges);
  patches.complete = patches.split = true;
  patches.meshes.clear();
  for (const std::uint8_t n : patches.chosen) {
    const QuadricPatch& patch = tet.cut.patches[n];
    PatchMesh& result = patches.meshes.emplace_back();
    std::vector<TetLoop> loops;
    for (const std::uint8_t l : patch.loops)
      loops.push_back(faces.points_of(tet, tet.cut.loops[l]));
    std::optional<PatchMesh> found;
    if (loops.empty()) found = triangulate_ellipsoid(approx, samples);
    if (split == TetSplit::Proven) {
      PatchCut arc = cut_of_patch(form.field(), tet, patch, faces, loops, samples);
      found = mesh_patch(approx, edges, tet.cut, patch, loops, arc);
      while (!found && !arc.path.empty()) {  // coarser arcs may not cross the coarse loop
        arc.path.resize(arc.path.size() / 2);
        found = mesh_patch(approx, edges, tet.cut, patch, loops, arc);
      }
    }
    if (!found) found = mesh_patch(approx, edges, tet.cut, patch, loops, {});
    if (!found && loops.size() == 1 && (last || is_tiny(loops[0])))
      found = triangulate_fan(loops[0]);
    patches.complete = patches.complete && found;
    if (!found) continue;
    result = std::move(*found);
    if (split == TetSplit::Whole || !result.parts.empty()) continue;
    result.parts.assign(result.triangles.size(), side_of(split));
    patches.split = patches.split && side_of(split) != 0;
  }
}

}  // namespace triplex::detail
